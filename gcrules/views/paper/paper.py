"""The files of a paper: the section with its figures and works, and a document that sets them."""

from __future__ import annotations

import os
from hashlib import sha256
from os import PathLike, fspath

from gcrules.conditions.analysis import Analysis
from gcrules.core.english import listed
from gcrules.core.errors import FileError
from gcrules.core.files import check_name, held, write_file
from gcrules.core.version import __version__
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.views.drawing.drawing import Drawing
from gcrules.views.formulas.latex_text import latex_words
from gcrules.views.paper.bibliography import references
from gcrules.views.paper.formulas import MACROS
from gcrules.views.paper.section import appendix, keys, section, slug
from gcrules.views.paper.subject import Figure, Subject, subject_of
from gcrules.views.paper.tikz import at_column_width, tikz, trimmed

__all__ = ["as_latex", "files_of", "save"]

_MARK = "% gcrules paper"
"""How each of the files begins. What begins otherwise is somebody's own, and so are lines that were changed below a
first line with their digest: neither is overwritten unless asked for.
"""

_ELSEWHERE = "choose another directory, or overwrite what is there with --force (in Python with force=True)"
_CLASS = r"\documentclass[10pt]{article}"
_PREAMBLE = r"""\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{amsmath,amsthm}
\usepackage{tikz}
\newtheorem{theorem}{Theorem}
\newtheorem{observation}[theorem]{Observation}
\emergencystretch=2em
\allowdisplaybreaks"""
_NEEDED = "needs the packages amsmath, amsthm and tikz, and theorem environments `theorem` and `observation`"


def files_of(a: Analysis | RobotAnalysis, *, full: bool = False) -> dict[str, str]:
    """The files by name: section.tex, figure.tex (and figure-2.tex), references.bib, main.tex; `full`: appendix.tex."""
    s = subject_of(a)
    head = f"{_MARK}, version {__version__}; sha256 of the analysis {s.digest}"
    pictures, placed = {}, []
    for n, (figure, drawing) in enumerate(_drawn(s), 1):
        name = f"figure{f'-{n}' * (n > 1)}"
        pictures[f"{name}.tex"] = f"{tikz(drawing)}\n"
        placed.append(_placed(s, n, figure, drawing, rf"\input{{{name}}}"))
    body = section(s, placed, full=full)
    more = {"appendix.tex": appendix(s)} if full else {}
    made = {
        "section.tex": f"% {_NEEDED}\n{MACROS}\n\n{body}",
        **more,
        **pictures,
        "references.bib": references(keys(s)),
        "main.tex": _document(
            f"{_CLASS} % or [10pt,twocolumn]", r"\input{section}", r"\input{appendix}" if full else ""
        ),
    }
    return {name: f"{head}; of the lines below {_digest(text)}\n{text}" for name, text in made.items()}


def _digest(text: str) -> str:
    return sha256(text.encode()).hexdigest()


def as_latex(a: Analysis | RobotAnalysis, *, full: bool = False) -> str:
    """The same as one document that brings its list of works along."""
    s = subject_of(a)
    placed = [_placed(s, n, figure, drawing, tikz(drawing)) for n, (figure, drawing) in enumerate(_drawn(s), 1)]
    works = f"\\begin{{filecontents}}{{references.bib}}\n{references(keys(s))}\\end{{filecontents}}\n"
    return works + _document(_CLASS, f"{MACROS}\n\n{section(s, placed, full=full)}", appendix(s) if full else "")


def save(
    a: Analysis | RobotAnalysis, folder: str | PathLike[str], *, full: bool = False, force: bool = False
) -> tuple[str, ...]:
    """Write the files into a folder, which is made if need be; all of them appear, or none.

    Returns their names. Raises FileError where that is not possible, and where a file of one of these names was not
    written by gcrules, or was changed since, unless `force` is given.
    """
    where = fspath(folder)
    check_name(where)
    made = files_of(a, full=full)
    if os.path.exists(where) and not os.path.isdir(where):
        raise FileError("this is a file, expected a directory", filename=where, hint="-o names the directory")
    kept = [(path, why) for path in (os.path.join(where, name) for name in made) if (why := _not_own(path))]
    if kept and not force:
        path, why = kept[0]
        others = f", and {listed([os.path.basename(other) for other, _ in kept[1:]])} likewise" if kept[1:] else ""
        raise FileError(f"{why}{others}", filename=path, hint=_ELSEWHERE)
    try:
        if not os.path.isdir(where):
            os.mkdir(where)
    except OSError as fault:
        raise FileError(f"cannot be made: {fault.strerror}", filename=where) from None
    paths = tuple(os.path.join(where, name) for name in made)
    with held():
        for path, content in zip(paths, made.values(), strict=True):
            write_file(path, content)
    return paths


def _not_own(path: str) -> str:
    """Why a file is somebody's own; "" where it is not there, or is as gcrules wrote it."""
    if not os.path.lexists(path):
        return ""
    try:
        with open(path, encoding="utf-8", errors="replace", newline="") as file:
            first, text = file.readline(), file.read()
    except OSError as fault:
        raise FileError(f"cannot be read: {fault.strerror}", filename=path) from None
    if not first.startswith(_MARK):
        return "there is a file of this name that gcrules did not write"
    return "" if first.rstrip().endswith(_digest(text)) else "this file is not as gcrules wrote it"


def _drawn(s: Subject) -> list[tuple[Figure, Drawing]]:
    """The figures, each with its drawing as it is printed."""
    return [(figure, trimmed(figure.drawing)) for figure in s.figures()]


def _placed(s: Subject, number: int, figure: Figure, drawing: Drawing, picture: str) -> str:
    return "\n".join(
        [
            r"\begin{figure}[t]",
            r"\centering",
            at_column_width(picture, drawing.width, drawing.height),
            rf"\caption[{{{latex_words(s.title)}}}]{{{figure.caption}.}}\label{{fig:{slug(s)}-{number}}}",
            r"\end{figure}",
        ]
    )


def _document(first: str, body: str, more: str) -> str:
    added = [r"\appendix", more] if more else []
    works = [r"\bibliographystyle{plain}", r"\bibliography{references}"]
    return "\n".join([first, _PREAMBLE, r"\begin{document}", body, *added, *works, r"\end{document}", ""])
