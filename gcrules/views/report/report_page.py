r"""The frame of an HTML report: one file with its styles, and with the 3D viewer and the scene that it shows.

The page says by its content security policy that it loads nothing. The viewer is a classic script, for module scripts
do not load from file://; where scripts are off, or there is no viewer, the figure that stands there already is seen.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any

from gcrules.core.errors import EngineFault
from gcrules.core.version import __version__
from gcrules.views.viewer import viewer_script

__all__ = ["footer", "in_script", "page", "robot_figure_html"]

FIGURE = "gcrules-robot"
SCENE = "gcrules-scene"

_VIEWPORT = '<meta name="viewport" content="width=device-width, initial-scale=1">'
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"


def page(title: str, sections: Iterable[str], scene: Mapping[str, Any] | None = None) -> str:
    """The whole page. With a scene the figure of `robot_figure_html` comes to life.

    Raises EngineFault where the viewer is not part of the installation.
    """
    policy = f"{_POLICY}; script-src 'unsafe-inline'" if scene is not None else _POLICY
    head = (
        f'<meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="{policy}">'
        f"<title>{escape(title)} – gcrules</title>{_VIEWPORT}<style>{_beside('report.css')}</style>"
    )
    scripts = "" if scene is None else _scripts(scene)
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>'
        f"<body><main>{''.join(sections)}</main>{scripts}</body></html>\n"
    )


def robot_figure_html(drawing: str, caption: str, *, live: bool = False, hint: str = "") -> str:
    """The figure of the robot, an SVG drawing; `live` where the page has a scene to show in its place, with a hint what
    to do with it. Without a drawing it is not seen until then.
    """
    mark = f' id="{FIGURE}"{"" if drawing else " hidden"}' if live else ""
    more = f' <span class="hint">{escape(hint)}</span>' if live else ""
    still = f'<div class="still">{drawing}</div>'
    return f'<figure class="robot"{mark}>{still}<figcaption>{escape(caption)}.{more}</figcaption></figure>'


def footer() -> str:
    """The version, and what the brackets mean."""
    legend = "Brackets [abcd] are determinants of homogeneous points; ∨ is join, ∧ is meet."
    return f"<footer>gcrules {__version__}. {legend}</footer>"


def in_script(data: Any) -> str:
    r"""JSON that is safe inside a script element: no text of the user's can end it.

    >>> in_script({"title": "</script><!--"})
    '{"title":"\\u003c/script>\\u003c!--"}'
    """
    found = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return found.replace("<", r"\u003c").replace("\u2028", r"\u2028").replace("\u2029", r"\u2029")


def _scripts(scene: Mapping[str, Any]) -> str:
    data = f'<script type="application/json" id="{SCENE}">{in_script(scene)}</script>'
    return f"{data}<script>{_viewer()}</script><script>{_beside('report.js')}</script>"


@cache
def _viewer() -> str:
    """The bundle of the viewer as the text of a script element."""
    try:
        code = viewer_script()
    except FileNotFoundError:
        raise EngineFault("the bundle of the 3D viewer is missing from this installation (views/static)") from None
    # strings and regular expressions of the code may hold these; escaped they mean the same
    return code.replace("</script", r"<\/script").replace("<!--", r"\x3c!--")


@cache
def _beside(name: str) -> str:
    return files("gcrules.views.report").joinpath(name).read_text(encoding="utf-8")
