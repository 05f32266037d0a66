r"""The catalog's documentation: an index and a page for each class as Markdown, with figures as SVG.

Everything is computed from the catalog, so that the pages are the same on every machine and can be compared.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from importlib.resources import files
from itertools import combinations
from os import PathLike
from textwrap import wrap

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Structure, leg_text, legs_text
from gcrules.algebra.language.text import text, text_terms
from gcrules.algebra.shortening.shorten import shorten
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.conditions.example_poses import WorkedPose
from gcrules.core.budget import report
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import SHIPPED, Entry
from gcrules.rules.condition import Condition
from gcrules.rules.strategy import Strategy
from gcrules.views.drawing.figures import graph_figure, incidence_in_words, robot_figure, thumbnail
from gcrules.views.pages.catalog_index import GROUP_NAMES, HEAD, degrees_text, index_page, owner_name
from gcrules.views.pages.class_aspects import aspects_section
from gcrules.views.pages.markdown import block, inline, reference
from gcrules.views.pages.page_names import page_names
from gcrules.views.report.telling_poses import telling_regular, telling_singular

__all__ = ["FIGURES", "HEAD", "bibliography", "catalog_pages", "neighbours"]

STATUS = {
    "inferred": "The literature reports 31 of the 34 regular classes as solved; that this class is one of them is"
    " inferred from its few terms, and was not read.",
    "added": "Not among the classes that the literature reports as solved; the condition was added here.",
    "always-singular": "Singular in every pose.",
}


FIGURES = ("graph", "robot", "singular", "small")
"""What stands after the class in the names of figures: the legs as a graph, the robot, the robot in a singular pose,
and the small drawing of the index.
"""


def catalog_pages(
    catalog: Catalog,
    bibliography: Mapping[str, str],
    catalogs: Sequence[str | PathLike[str]] = (),
    strategy: Strategy | None = None,
    plugins: Sequence[str | PathLike[str]] = (),
    only: Collection[str] = (),
) -> dict[str, str]:
    """File names (relative to the folder of the pages) and contents.

    `bibliography` gives a line for each source; `catalogs` names the files that the catalog was loaded from besides the
    shipped one, `plugins` the folders of plugins, `strategy` the rules that run, for the analysis. With ids in `only`,
    the pages of these classes alone, without the index.
    """
    names = page_names(e.id for e in catalog.entries)
    links = neighbours(catalog)
    pages: dict[str, str] = {}
    chosen = [e for e in catalog.entries if not only or e.id in only]
    for number, entry in enumerate(chosen, 1):
        report(f"{entry.id}, {number} of {len(chosen)}")
        a = analyze(entry.structure, catalogs=catalogs, recheck=True, strategy=strategy, plugins=plugins)
        poses = _worked(a)
        at = {word: _cartesian(pose) for word, pose in poses.items()}
        name = names[entry.id]
        drawn = {"graph": graph_figure(a), "robot": robot_figure(a, at.get("regular"))}
        if "singular" in at:
            drawn["singular"] = robot_figure(a, at["singular"])
        drawn["small"] = thumbnail(a, at.get("regular"))
        pages |= {f"{name}-{kind}.svg": figure.svg() for kind, figure in drawn.items()}
        found = [(what, other, names[other]) for what, other in links[entry.id]]
        pages[f"{name}.md"] = _page(entry, a, poses, name, found, bibliography)
    if not only:
        pages["README.md"] = index_page(catalog.entries, names)
    return pages


def _worked(a: Analysis) -> dict[str, WorkedPose]:
    if not a.typed.polynomial or a.condition.kind == "always-singular":
        return {}
    found = {"regular": telling_regular(a), "singular": telling_singular(a)}
    return {word: pose for word, pose in found.items() if pose}


def _cartesian(pose: WorkedPose) -> dict[str, tuple[int | Fraction, ...]]:
    return {n: c[:3] for n, c in pose.points.items()}


def neighbours(catalog: Catalog) -> dict[str, list[tuple[str, str]]]:
    """For each class the (what is done, id) that merging two joints of one body, or the reverse, leads to."""
    found: dict[str, list[tuple[str, str]]] = {e.id: [] for e in catalog.entries}
    for entry in catalog.entries:
        structure = entry.structure
        for side in (structure.base, structure.platform):
            for a, b in combinations(side, 2):
                legs = tuple((_merged(x, a, b), _merged(y, a, b)) for x, y in entry.legs)
                match = catalog.match(Structure(legs)) if len(set(legs)) == len(legs) else None
                if match:
                    found[entry.id].append((f"merge {a} and {b}", match.entry.id))
                    found[match.entry.id].append(("split a joint", entry.id))
    return {key: _distinct(pairs) for key, pairs in found.items()}


def _merged(name: str, kept: str, gone: str) -> str:
    return kept if name == gone else name


def _distinct(pairs: Iterable[tuple[str, str]]) -> list[tuple[str, str]]:
    first: dict[str, tuple[str, str]] = {}
    for pair in pairs:
        first.setdefault(pair[1], pair)
    return sorted(first.values())


def bibliography() -> dict[str, str]:
    """One line of Markdown for each source of references.bib, with the note that says what was consulted."""
    source = files("gcrules").joinpath("references.bib").read_text(encoding="utf-8")
    return {m[1]: _reference(m[2]) for m in re.finditer(r"^@\w+\{(\w+),(.*?)\}\}$", source, re.MULTILINE | re.DOTALL)}


def _reference(fields: str) -> str:
    found = {
        m[1]: _plain(m[2]) for m in re.finditer(r"(\w+) = \{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}", fields + "}")
    }
    where = ", ".join(found[key] for key in ("journal", "booktitle") if key in found)
    eprint = f"arXiv:{found['eprint']}" if "eprint" in found else ""
    authors = re.sub(r" and others$", " et al.", found.get("author", ""))
    parts = [authors, found.get("title", ""), where, eprint, found.get("year", "")]
    return " ".join(f"{p.removesuffix('.')}." for p in parts if p) + (
        f" *({found['note']})*" if "note" in found else ""
    )


_ACCENTS = {"'": "\u0301", "`": "\u0300", '"': "\u0308", "^": "\u0302"}


def _plain(words: str) -> str:
    """BibTeX text without braces and accent commands."""
    accents = re.sub(r"\{?\\(['`\"^])\{?(\w)\}?\}?", lambda m: m[2] + _ACCENTS[m[1]], words)
    return unicodedata.normalize("NFC", re.sub(r"[{}]", "", accents).replace("--", "–"))


def _page(
    entry: Entry,
    a: Analysis,
    poses: Mapping[str, WorkedPose],
    name: str,
    links: list[tuple[str, str, str]],
    bibliography: Mapping[str, str],
) -> str:
    title = inline(f"Class {entry.id}" + (f": {entry.name}" if entry.name else ""))
    alt = inline(f"class {entry.id}")
    pose = " in the regular pose of the table below" if "regular" in poses else ""
    lines = [
        HEAD,
        f"# {title}",
        "",
        f"**{inline(a.condition.sentence)}**",
        "",
        f"![The legs of {alt} as a graph]({name}-graph.svg)",
        "",
        f"![The robot of {alt}{pose}, with the entities of the condition]({name}-robot.svg)",
        "",
        *([f"The robot is drawn{pose}.", ""] if pose else []),
        *_singular(a, poses, name, alt),
        f"* Legs: {legs_text(entry.legs)}",
        f"* Legs at the {degrees_text(entry, 'base joints {}, at the platform joints {}')}",
        f"* Group: {_group(entry, a)}",
        f"* Status: {_status(entry)}",
        *([f"* Note: {inline(entry.note)}"] if entry.note else []),
        "",
        "## Superbracket",
        "",
        *block(f"{_math(a, a.structure.superbracket)} =", *_formula(a, a.typed.polynomial.to_expr())),
        "## Shortest form",
        "",
        f"Fewest terms over all 720 orders of the legs: {entry.terms[24]} in the 24-term form, {entry.terms[16]} in "
        f"the 16-term form. The {a.shortest.form}-term form with the legs in the order "
        f"{', '.join(leg_text(a.structure.legs[i]) for i in a.shortest.order)}:",
        "",
        *block(*_formula(a, a.shortest.polynomial.to_expr())),
        *_fewest(entry, a),
        "## Derivation",
        "",
        *_derivation(a),
        "## Condition",
        "",
        *_condition(a, a.condition),
        *_other_readings(a),
        *aspects_section(a),
        *_table(a, poses),
        *_neighbours(links),
        *_sources(entry, bibliography),
        "[All classes](README.md)",
        "",
    ]
    return "\n".join(lines)


def _fewest(entry: Entry, a: Analysis) -> list[str]:
    """Whether a bracket polynomial of any other kind is shorter; computed where the catalog does not say."""
    if not a.typed.polynomial:
        return []
    shown = len(a.shortest.polynomial)
    if entry.shortest is None:
        found = shorten(a.structure.superbracket)
        lower, terms = found.lower, found.terms
    else:
        lower = terms = entry.shortest
    if lower == shown:
        return ["No bracket polynomial with fewer terms equals the superbracket (proved by `gcrules shorten`).", ""]
    best = f"A bracket polynomial of {terms} terms equals it" if terms < shown else "No shorter one was found"
    return [f"{best}; at least {lower} are needed (`gcrules shorten`).", ""]


def _group(entry: Entry, a: Analysis) -> str:
    if a.condition.kind == "always-singular":
        return "none"
    return GROUP_NAMES[entry.group if entry.owner == SHIPPED else a.group]


def _status(entry: Entry) -> str:
    own = f"Of the catalog {inline(owner_name(entry))}." if entry.owner != SHIPPED else ""
    stated = entry.owner == SHIPPED or entry.status != "added"
    return " ".join(part for part in (own, STATUS[entry.status] if stated else "") if part)


def _derivation(a: Analysis) -> list[str]:
    lines = []
    steps = tuple(a.derivation)
    for number, step in enumerate(steps, 1):
        why, before = step.why, []
        if len(steps) == 1:
            before = [*_formula(a, step.before), "="]
            if a.condition.certificate.method == "normal-form":
                why = re.sub("^proved:", "this identity is proved from scratch:", why)
        lines += [f"**{number}. {step.rule}**: {inline(why)}", "", *block(*before, *_formula(a, step.after))]
    return lines


def _singular(a: Analysis, poses: Mapping[str, WorkedPose], name: str, alt: str) -> list[str]:
    """The figure of the singular pose and what there is to be seen."""
    if "singular" not in poses:
        return []
    words = inline(incidence_in_words(a, _cartesian(poses["singular"])))
    return [
        f"![The robot of {alt} in the singular pose of the table below]({name}-singular.svg)",
        "",
        " ".join(["In the singular pose of the table", words]),
        "",
    ]


def _math(a: Analysis, e: Expr) -> str:
    return text(e, unicode=True, names=a.structure.names)


_WIDTH = 92


def _formula(a: Analysis, e: Expr, indent: str = "") -> list[str]:
    """The lines of an expression: broken between terms, a term that is too long for a line at its operations."""
    return _wrapped(text_terms(e, unicode=True, names=a.structure.names), indent)


def _wrapped(pieces: Iterable[str], indent: str) -> list[str]:
    kept = (_SPACE_IN_PIECE.sub("\u00a0", p) if len(p) > _WIDTH - 4 else p.replace(" ", "\u00a0") for p in pieces)
    found = wrap(
        " ".join(kept),
        _WIDTH,
        initial_indent=indent,
        subsequent_indent=f"{indent}  ",
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [line.replace("\u00a0", " ") for line in found]


_SPACE_IN_PIECE = re.compile(r" (?![∧∨+−·] )")


def _condition(a: Analysis, c: Condition) -> list[str]:
    if c.kind == "linear-complex":
        return [*block(_math(a, c.expression)), f"Certificate: {inline(c.certificate.detail)}.", ""]
    cofactor = [] if str(c.cofactor) == "1" else [f"({_math(a, c.cofactor)}) ·"]
    left = _wrapped([*cofactor, f"{_math(a, a.structure.superbracket)} ="], "")
    lines = block(*left, *_formula(a, c.right_side, "  "))
    detail = re.sub("^proved:", "proved from scratch:", c.certificate.detail)
    return [*lines, f"Certificate: {inline(detail)}.", ""]


def _other_readings(a: Analysis) -> list[str]:
    readings = [r for r in a.readings if r.kind != "linear-complex"]
    if not readings:
        return []
    lines = ["## Other readings", ""]
    for r in readings:
        lines += [*([inline(r.sentence), ""] if r.statement else []), *_condition(a, r)]
    return lines


def _table(a: Analysis, poses: Mapping[str, WorkedPose]) -> list[str]:
    if a.condition.kind == "always-singular":
        return []
    names = a.structure.names
    lines = ["## Worked poses", "", "Exact coordinates (an example, invented dimensions).", ""]
    if poses:
        heads = " | ".join(inline(n) for n in names)
        lines += [f"| pose | {heads} | superbracket |", "|---|" + "---|" * (len(names) + 1)]
    for word, pose in poses.items():
        lines.append(f"| {word} | " + " | ".join(_point(pose, n) for n in names) + f" | {pose.value} |")
    missing = [word for word in ("regular", "singular") if word not in poses]
    if missing:
        lines += ["", f"No {' and no '.join(missing)} pose with small numbers was found."]
    return [*lines, ""]


def _point(pose: WorkedPose, name: str) -> str:
    return "(" + ", ".join(str(c) for c in pose.points[name][:3]) + ")"


def _neighbours(links: list[tuple[str, str, str]]) -> list[str]:
    if not links:
        return []
    found = (f"* {inline(what)}: [{inline(other)}]({name}.md)" for what, other, name in links)
    return ["## Neighbours", "", "Classes with one joint merged or split:", "", *found, ""]


def _sources(entry: Entry, bibliography: Mapping[str, str]) -> list[str]:
    if not entry.sources:
        return ["## Sources", "", "Derived here." if entry.owner == SHIPPED else "None given.", ""]
    known = (bibliography.get(key) or reference(key) for key in entry.sources)
    return ["## Sources", "", *(f"* {line}" for line in known), ""]
