"""The commands that begin with a colon: one function for each, which answers a request to an interpreter."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from math import inf, nan
from os.path import expanduser
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.discovery.limits import SECONDS as SECONDS_TO_DISCOVER
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.factoring.limits import SECONDS as SECONDS_TO_FACTOR
from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.text import Names
from gcrules.algebra.letters import declarations
from gcrules.algebra.names import step_name
from gcrules.algebra.shortening.limits import SECONDS as SECONDS_TO_SHORTEN
from gcrules.algebra.straightening.straighten import straighten, straighten_steps
from gcrules.apps.repl.answers import Answer, context_text, polynomial_text
from gcrules.apps.repl.help import help_text
from gcrules.apps.repl.reading import is_blank
from gcrules.apps.repl.request import Request
from gcrules.apps.repl.session import PromptSession
from gcrules.apps.repl.state import PromptState
from gcrules.conditions.analysis import Analysis
from gcrules.core.deferred import deferred
from gcrules.core.errors import GcrulesError, Span
from gcrules.core.files import write_file
from gcrules.core.hints import near
from gcrules.core.memory import GIGABYTE, memory_limit
from gcrules.core.shown import Shown
from gcrules.mechanisms.analyze import analyze
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.load import Loaded, load
from gcrules.rules.identity import Identity
from gcrules.rules.plugins import load_rules
from gcrules.rules.strategy import Strategy
from gcrules.views.detail import without_options
from gcrules.views.formulas.latex import latex

__all__ = ["HANDLERS"]

discover = deferred("gcrules.algebra.discovery.discover:discover")
relations = deferred("gcrules.algebra.discovery.discover:asked")
factor = deferred("gcrules.algebra.factoring.factorize:factor")
factors = deferred("gcrules.algebra.factoring.factors:factors")
shorten = deferred("gcrules.algebra.shortening.shorten:shorten")
transversals = deferred("gcrules.conditions.transversals:transversals")
_leading_sentences = deferred("gcrules.views.report.stages:leading_sentences")


def _asked(repl: PromptSession, request: Request) -> Expr:
    """The expression behind a command, or the last result where there is none."""
    if not is_blank(request.argument):
        return repl.expression(request.source)
    if not repl.state.results:
        raise request.fault("there is no result yet")
    return repl.state.results[0]


# --- algebra -------------------------------------------------------------------------------------------------------


def _expand(repl: PromptSession, request: Request) -> Iterator[Answer]:
    return repl.shown(_asked(repl, request), request.source)


def _straighten(repl: PromptSession, request: Request) -> Iterator[Answer]:
    at, limit = repl.state.context, repl.settings.limit
    e = _asked(repl, request)
    found = straighten(e, points=at.points, ideal=at.ideal, rank=at.rank, limit=limit)
    repl.remember(found.to_expr())
    yield Answer(polynomial_text(found, repl.settings, at), "shown")


def _steps(repl: PromptSession, request: Request) -> Iterator[Answer]:
    at, settings = repl.state.context, repl.settings
    e = _asked(repl, request)
    found = expand(e, points=at.points, ideal=at.ideal, rank=at.rank, limit=settings.limit)
    if not isinstance(found, BracketPolynomial):
        raise request.fault(f"the steps of scalars are shown; this is {step_name(found.step, at.rank)}")
    normal, steps = straighten_steps(found)
    repl.remember(normal.to_expr())
    lines = [f"{polynomial_text(s.before, settings, at)} = {polynomial_text(s.after, settings, at)}" for s in steps]
    end = " \\\\" if settings.latex else ""
    yield Answer("\n".join([*(f"{line}{end}" for line in lines), polynomial_text(normal, settings, at)]), "shown")


def _searched(repl: PromptSession, request: Request, search: Callable[..., Any], most: float) -> Any:
    at, e = repl.state.context, _asked(repl, request)
    with request.placed():
        return search(e, points=at.points, ideal=at.ideal, rank=at.rank, seconds=min(most, repl.settings.seconds))


def _factor(repl: PromptSession, request: Request) -> Iterator[Answer]:
    found = _searched(repl, request, factor, SECONDS_TO_FACTOR)
    if found.exists:
        repl.remember(found.whole())
    yield _whole(repl, found, "shown" if found.proved else "undecided", _unused(repl))


def _factors(repl: PromptSession, request: Request) -> Iterator[Answer]:
    found = _searched(repl, request, factors, SECONDS_TO_FACTOR)
    repl.remember(found.to_expr())
    yield _whole(repl, found, "shown" if found.decided else "undecided", _unused(repl))


def _shorten(repl: PromptSession, request: Request) -> Iterator[Answer]:
    found = _searched(repl, request, shorten, SECONDS_TO_SHORTEN)
    repl.remember(found.polynomial.to_expr())
    yield _whole(repl, found, "undecided" if found.undecided else "shown", _unused(repl))


def _transversals(repl: PromptSession, request: Request) -> Iterator[Answer]:
    if is_blank(request.argument):
        raise request.fault("no legs", "six legs, each its two joints:  :transversals Aa Ab Bc Cd De Ef")
    structure = _legs(repl, request, read_legs)
    assert isinstance(structure, Structure)
    found = transversals(structure)
    if found.exists:
        repl.remember(found.condition.expression)
    yield _whole(repl, found, "shown" if found.definite or found.exists else "undecided")


def _unused(repl: PromptSession) -> str:
    """What has to be said where something is assumed, and the answer is that without it."""
    return "\n  assumptions  not used: this is the answer without them" if repl.state.context.given else ""


def _whole(repl: PromptSession, found: Shown, verdict: str, note: str = "") -> Answer:
    """A result with all that it says."""
    settings = repl.settings
    with without_options():
        text = found.latex() if settings.latex else found.text(unicode=settings.unicode)
    shown = text.rstrip("\n")
    return Answer(shown if settings.latex else shown + note, verdict, wraps=False)


def _discover(repl: PromptSession, request: Request) -> Iterator[Answer]:
    settings, argument = repl.settings, request.argument.partition("#")[0]
    with request.placed():
        found = discover(
            repl.state.context,
            relations=relations(argument),
            limit=settings.limit,
            seconds=min(SECONDS_TO_DISCOVER, settings.seconds),
        )
    yield _whole(repl, found, "undecided" if found.verdict == "undecided" else "shown")


def _prove(repl: PromptSession, request: Request) -> Iterator[Answer]:
    if is_blank(request.argument):
        raise request.fault("no equation to prove", request.command.usage)
    return repl.equation(request.source)


def _analyze(repl: PromptSession, request: Request) -> Iterator[Answer]:
    at = repl.state.context
    if at.rank != 4:
        raise request.fault(f"platforms with six legs are in rank 4, and this is rank {at.rank}", ":reset starts over")
    if is_blank(request.argument):
        raise request.fault("no legs", "six legs, each its two joints:  :analyze ab af cb cd ed ef")
    folders = repl.settings.plugins
    asked = _legs(repl, request, _loaded if repl.settings.files else read_legs)
    of_legs = isinstance(asked, (Structure, Platform))
    chosen = _strategy(repl) if of_legs else None
    found = analyze(asked, strategy=chosen, plugins=folders, catalogs=repl.settings.catalogs if of_legs else ())
    if found.condition is not None:
        repl.remember(found.condition.expression)
    whole = _whole(repl, found, "shown")
    if isinstance(found, Analysis):
        whole = replace(whole, applied=(*found.applied, *found.claimed), sentences=_leading_sentences(found))
    yield whole


def _loaded(word: str, points: Names) -> Loaded:
    return load(expanduser(word), points=points)


def _strategy(repl: PromptSession) -> Strategy | None:
    """The usual rules and those so far; None where there are no others."""
    if not repl.state.rules:
        return None
    usual = load_rules(folders=repl.settings.plugins, identities=False).strategy()
    return Strategy((*repl.state.rules, *usual.rules))


def _legs(repl: PromptSession, request: Request, reading: Callable[..., Loaded]) -> Loaded:
    """Legs, whose points may be declared here, or what else is read."""
    at = repl.state.context
    word = request.argument.partition("#")[0].strip()
    text = request.source.text
    place = request.span
    try:
        if at.letters.keys() & set(word.replace(",", " ").split()):
            reading = partial(read_legs, letters=", ".join(declarations(at.letters, at.rank, at.screws)))
        legs = reading(word, points=(*at.points, *at.ideal))
        if not isinstance(legs, Structure):
            return legs
        known = {*legs.names, *at.points}
        given = tuple(a for a in at.given if known.issuperset(points_of(*a.args)))
        return replace(legs, points=at.points, ideal=tuple(n for n in at.ideal if n in legs.names), given=given)
    except GcrulesError as fault:
        if fault.source == word and fault.span is not None:
            fault.source = text
            fault.span = Span(fault.span.start + place.start, fault.span.end + place.start)
            fault.filename = request.source.filename
        raise fault.located(text, request.source.filename, place) from None


# --- how answers are shown -----------------------------------------------------------------------------------------


def _switch(request: Request, now: bool) -> bool:
    word = request.argument
    if word not in ("on", "off", ""):
        raise request.fault(f"{word!r} is neither on nor off", request.command.usage)
    return {"on": True, "off": False, "": now}[word]


def _latex(repl: PromptSession, request: Request) -> Iterator[Answer]:
    if request.argument in ("on", "off"):
        repl.settings = replace(repl.settings, latex=_switch(request, False))
        yield Answer(f"LaTeX {request.argument}")
    else:
        yield Answer(latex(_asked(repl, request)), "shown")


def _unicode(repl: PromptSession, request: Request) -> Iterator[Answer]:
    on = _switch(request, repl.settings.unicode)
    repl.settings = replace(repl.settings, unicode=on)
    yield Answer(f"Unicode {'on' if on else 'off'}")


def _limit(repl: PromptSession, request: Request) -> Iterator[Answer]:
    word = request.argument.replace(",", "").replace("_", "")
    if word:
        if not (word.isascii() and word.isdigit() and len(word) < 19 and int(word)):
            raise request.fault("the limit is a number of terms, 1 or more")
        repl.settings = replace(repl.settings, limit=int(word))
    yield Answer(f"limit {repl.settings.limit:,} terms")


def _seconds(repl: PromptSession, request: Request) -> Iterator[Answer]:
    if request.argument:
        repl.settings = replace(repl.settings, seconds=_amount(request, "seconds"))
    yield Answer("no limit of time" if repl.settings.seconds == inf else f"limit {repl.settings.seconds:g} seconds")


def _memory(repl: PromptSession, request: Request) -> Iterator[Answer]:
    if request.argument:
        repl.settings = replace(repl.settings, gigabytes=_amount(request, "gigabytes"))
    most = memory_limit(repl.settings.gigabytes)
    yield Answer("no limit of memory" if most is None else f"limit {most / GIGABYTE:.3g} GB of memory")


def _amount(request: Request, what: str) -> float:
    """The number that a limit is set to."""
    try:
        found = float(request.argument)
    except ValueError:
        found = nan
    if not found >= 0:
        raise request.fault(f"the limit is a number of {what}, 0 or more; inf is none")
    return found


# --- what is declared ----------------------------------------------------------------------------------------------


def _context(repl: PromptSession, request: Request) -> Iterator[Answer]:
    yield Answer(context_text(repl.state, replace(repl.settings, latex=False)))


def _rules(repl: PromptSession, request: Request) -> Iterator[Answer]:
    rules = repl.state.rules
    if is_blank(request.argument):
        shown = [f"{r.id}: {r.text if isinstance(r, Identity) else r.sentence}" for r in rules]
        yield Answer("\n".join(shown) or 'no rules yet; write  rule ID "sentence": LHS => RHS')
        return
    rule = next((r for r in rules if r.id == request.argument), None)
    if rule is None:
        raise request.fault(
            f"there is no rule {request.argument[:40]}",
            near(request.argument, [r.id for r in rules]) or ":rules lists them",
        )
    facts = {"rule": rule.id, "sentence": rule.sentence, "text": getattr(rule, "text", ""), "source": rule.source}
    if isinstance(rule, Identity):
        facts["ranks"] = " ".join(str(i.rank) for i in rule.instances)
    facts |= {"fires": ", ".join(rule.fires), "silent": ", ".join(rule.silent)}
    yield Answer("\n".join(f"{key:<10}  {value}" for key, value in facts.items() if value))


def _help(repl: PromptSession, request: Request) -> Iterator[Answer]:
    yield Answer(help_text(request.argument), wraps=False)


# --- files ---------------------------------------------------------------------------------------------------------


def _file(repl: PromptSession, request: Request) -> str:
    if not repl.settings.files:
        raise request.fault("no files are read or written here")
    name = request.argument
    if len(name) > 1 and name[0] == name[-1] and name[0] in "\"'":
        name = name[1:-1]
    if not name:
        raise request.fault("a file name is missing", request.command.usage)
    return expanduser(name)


def _load(repl: PromptSession, request: Request) -> Iterator[Answer]:
    return repl.script(_file(repl, request))


def _save(repl: PromptSession, request: Request) -> Iterator[Answer]:
    name, script = _file(repl, request), repl.state.script()
    if not script:
        raise request.fault("there are no statements to save")
    if name == "-":
        yield Answer(script.rstrip("\n"))
        return
    parse_script(script, name)  # what is written can be run
    write_file(name, script)
    count = len(repl.state.statements)
    yield Answer(f"{count} statement{'s' * (count != 1)} written to {name}")


# --- the session ---------------------------------------------------------------------------------------------------


def _undo(repl: PromptSession, request: Request) -> Iterator[Answer]:
    if not repl.past:
        raise request.fault("there is nothing to take back")
    before = repl.state.statements
    repl.state, repl.past = repl.past[-1], repl.past[:-1]
    after = repl.state.statements
    if len(after) < len(before):
        yield Answer(f"taken back: {_few(before[len(after) :])}")
    else:
        yield Answer(f"back again: {_few(after[len(before) :])}")


def _few(statements: tuple[str, ...]) -> str:
    return " ".join(statements[0].split()) if len(statements) == 1 else f"{len(statements)} statements"


def _reset(repl: PromptSession, request: Request) -> Iterator[Answer]:
    before = repl.state.statements
    with repl.step():
        repl.state = PromptState()
    yield Answer(f"forgotten: {_few(before)}; :undo brings this back" if before else "nothing is declared")


def _quit(repl: PromptSession, request: Request) -> Iterator[Answer]:
    repl.over = True
    yield from ()


HANDLERS: Mapping[str, Callable[[PromptSession, Request], Iterator[Answer]]] = {
    "help": _help,
    "analyze": _analyze,
    "expand": _expand,
    "straighten": _straighten,
    "steps": _steps,
    "factor": _factor,
    "factors": _factors,
    "shorten": _shorten,
    "transversals": _transversals,
    "prove": _prove,
    "discover": _discover,
    "latex": _latex,
    "unicode": _unicode,
    "limit": _limit,
    "memory": _memory,
    "seconds": _seconds,
    "context": _context,
    "rules": _rules,
    "load": _load,
    "save": _save,
    "undo": _undo,
    "reset": _reset,
    "quit": _quit,
}
