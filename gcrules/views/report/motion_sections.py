"""A path and maps of any mechanism as sections of its report: figure, singular places, and what is proved."""

from __future__ import annotations

from base64 import b64encode
from html import escape

from gcrules.core.deferred import deferred
from gcrules.core.english import as_sentence, listed
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.paths.report import PathReport
from gcrules.views.forms import shown
from gcrules.views.report.account_html import NO_PICTURE, account_section, facts_html, inline_svg, map_figure
from gcrules.views.report.carried_files import checking_html
from gcrules.views.report.leads import path_lead
from gcrules.views.results.box_map import leaves_nothing, seen
from gcrules.views.results.map import account
from gcrules.views.results.path_account import PathAccount, PathPlace, PathStretch

__all__ = ["boxes_html", "map_html", "path_html"]

picture = deferred("gcrules.views.plots.map_plot:picture")  # matplotlib, an extra of the installation

_MOST = 100  # places that are listed; the JSON object of `gcrules path` holds all


def path_html(r: PathReport | RobotPath, m: SixLegs | Limbs, *, live: bool, title: str = "Along a path") -> str:
    """Verdict and reason, the margin along the path, a table of the singular places and of what is not decided; in a
    page that is `live` a 3D view that goes along it.
    """
    a: PathAccount = shown(r, "account")
    words = "The margin along the path" + ("; singular places carry the numbers of the table." if a.places else ".")
    figure = f'<figure class="plot">{shown(r, "svg")}<figcaption>{words}</figcaption></figure>'
    head = f'<h2>{escape(title)}</h2><p class="verdict">{escape(a.verdict.capitalize())}</p>'
    reason = f'<p class="why">{escape(a.reason)}</p>'
    view = path_lead(r, m) if live else ""
    return (
        f'<section class="motion {a.verdict}">{head}{reason}{figure}{view}{_places(a)}{facts_html(a.facts)}</section>'
    )


def _places(a: PathAccount) -> str:
    rows = [*map(_stretch, a.stretches), *(_place(n, p) for n, p in enumerate(a.places[:_MOST], 1))]
    if not rows:
        return ""
    more = len(a.places) - _MOST
    left = f"<p>And {more:,} more, which <code>gcrules path … --json</code> shows.</p>" if more > 0 else ""
    head = "<tr><th></th><th>parameter</th><th>why, and what the platform gains</th></tr>"
    return f'<table class="places"><thead>{head}</thead><tbody>{"".join(rows)}</tbody></table>{left}'


def _place(number: int, p: PathPlace) -> str:
    pose = f'<p class="at"><code>{escape(p.pose)}</code></p>'
    sure = f'<p class="sure">{escape(as_sentence(p.sure))}</p>' if p.sure else ""
    words = _paragraphs(as_sentence(p.kind), *p.causes, *p.motions)
    return f"<tr><th>{number}</th><td>{p.parameter:.6g}{escape(p.exactly)}</td><td>{pose}{words}{sure}</td></tr>"


def _stretch(s: PathStretch) -> str:
    words = _paragraphs(as_sentence(s.words), *s.causes, *s.motions)
    place = f"{s.start:.6g} to {s.end:.6g}" if s.end > s.start else f"{s.start:.6g}"
    return f"<tr><th>–</th><td>{place}</td><td>{words}</td></tr>"


def _paragraphs(*words: str) -> str:
    return "".join(f"<p>{escape(one)}</p>" for one in words)


def map_html(r: SingularMap, m: SixLegs | Limbs, *, live: bool, title: str = "") -> str:
    """The picture, the sentence that says what is proved, and what was computed."""
    title = title or f"Map over {listed([a.name for a in r.grid.axes])}"
    facts = account(r)
    proof = f'<p class="proof">{escape(as_sentence(r.guarantee))}</p>'
    head = f"<h2>{escape(title)}</h2>"
    again = checking_html(r, r.grid.title)
    return f'<section class="motion">{head}{proof}{_picture(r)}{facts_html(facts)}{again}</section>'


def _picture(m: SingularMap) -> str:
    """Curves as SVG, surfaces from several sides as PNG; where matplotlib is missing the page says so."""
    title = m.grid.title or "the robot"
    seen = f"Singular poses of {title} over {listed([a.name for a in m.grid.axes])}."
    try:
        if len(m.grid.axes) == 2:
            drawn = inline_svg(picture(m, "svg").decode(), seen)
        else:
            drawn = f'<img alt="{escape(seen)}" src="data:image/png;base64,{b64encode(picture(m, "png")).decode()}">'
    except ImportError:
        return NO_PICTURE
    words = f"Singular poses of {title}; what is proved of them stands above."
    return map_figure(drawn, words)


def boxes_html(r: BoxMap, m: SixLegs | Limbs, *, live: bool) -> str:
    """The sentence that says what is proved of whole ranges, the picture, and how much is free and what is not."""
    return account_section(
        r,
        f"Whole ranges of {listed([a.name for a in r.axes])}",
        _boxes_picture(r),
        _more(r),
        last=checking_html(r, r.task.mechanism.title),
    )


def _boxes_picture(r: BoxMap) -> str:
    """The boxes, or what is left of them over each pair of coordinates; nothing where nothing is left."""
    if leaves_nothing(r):
        return ""
    pairs = len(r.axes) > 2
    drawn = shown(r, "svg")
    if drawn is None:
        return NO_PICTURE
    words = "What is not proved free, over each pair of coordinates" if pairs else "Boxes of poses"
    return map_figure(inline_svg(drawn, seen(r)), f"{words}; what is proved stands above.")


def _more(r: BoxMap) -> str:
    """What decides more, where something is undecided."""
    if not r.summary.shares[-1]:
        return ""
    return "<p>More boxes decide more: <code>gcrules map boxes … --boxes N</code>.</p>"
