"""The commands that run statements and rules: run, rewrite."""

from __future__ import annotations

from textwrap import indent

import click

from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.language.statements import Script, parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.expressions import argument_text, context_of
from gcrules.apps.cli.files import read_stdin, working
from gcrules.apps.cli.limits import SECONDS, time_limit
from gcrules.apps.cli.options import SpaceOptions, given_option, limit_option, space_options
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options
from gcrules.apps.cli.rule_options import Choice, rules_options
from gcrules.apps.cli.verdicts import EXIT_CODES, coloured
from gcrules.core.alarm import paced
from gcrules.core.budget import report
from gcrules.core.errors import InputError
from gcrules.core.yaml_file import read_text
from gcrules.rules.rewriting import rewrite as rewritten
from gcrules.rules.script import Result, ScriptResult, ScriptResults, results
from gcrules.views.results.script import totals

__all__ = ["rewrite", "run"]

_limit = limit_option(MAX_TERMS, "Give up beyond this many terms.")
_seconds = time_limit()


@click.command(cls=ExpressionCommand)
@click.argument("expression", metavar="EXPR")
@rules_options
@given_option
@space_options(metric=True)
@_seconds
@output_options()
def rewrite(expression: str, choice: Choice, assumptions: tuple[str, ...], space: SpaceOptions, out: Output) -> None:
    """Rewrite an expression by rules, the first that fires each time, until all stay silent; every step is shown.

    \b
    gcrules rewrite "[abce][abdf] - [abcd][abef]" --rules mine.gca
    gcrules rewrite "ab /\\ cde" --rules expansion

    --rules takes files of identities and names of rewriting rules (see `gcrules rules list`). Rules that ask for
    collinear points and the like fire where --given says so.
    """
    at = context_of(space, assumptions)
    e = parse(argument_text(expression), context=at)
    rules = choice.rewriting()
    if not rules:
        raise InputError("no rules to rewrite by", hint="name some:  --rules mine.gca  or  --rules expansion")
    with working("rewriting"):
        out.show(rewritten(e, rules, at))


@click.command(cls=ExpressionCommand)
@click.argument("files", metavar="FILE.gca…", nargs=-1, required=True)
@_limit
@time_limit(SECONDS, "Give up on a statement after this time.", itself=True)
@proof_options
@output_options(latex=False)
@click.pass_context
def run(
    ctx: click.Context, files: tuple[str, ...], limit: int, seconds: float, proofs: ProofOptions, out: Output
) -> None:
    """Run scripts and report every claim with its line; "-" reads standard input.

    \b
    gcrules run octahedron.gca
    gcrules run examples/theorems/*.gca
    A file may hold
        let s = [[ab, af, cb, cd, ed, ef]]
        claim "alternate faces": s == ace /\\ abf /\\ cbd /\\ edf

    Statements: rank, points, ideal, given, let, claim, show, rule, rewrite. Exit code 1 if any claim or rule is
    refuted, 3 if any is undecided.
    """
    scripts = [parse_script(*((read_stdin(), "<stdin>") if f == "-" else (read_text(f), f))) for f in files]
    answers = [_answered(script, limit, seconds) for script in scripts]
    shown = [
        "\n".join([*(coloured(r.verdict, r.text(unicode=out.unicode)) for r in a.results), *totals(a)]) for a in answers
    ]
    together = ScriptResults(tuple(s.filename for s in scripts), tuple(answers))
    whole = together.whole
    if out.brief:
        out.write("\n".join(totals(whole)))
    elif len(files) == 1:
        out.show(answers[0], shown[0])
    else:
        parts = (f"{s.filename}\n{indent(text, '  ')}" for s, text in zip(scripts, shown, strict=True))
        out.show(together, "\n\n".join([*parts, "\n".join(totals(whole))]))
    proofs.write(answers[0] if len(files) == 1 else together, whole.verdict, "a claim or a rule")
    ctx.exit(EXIT_CODES[whole.verdict])


def _answered(script: Script, limit: int, seconds: float) -> ScriptResult:
    found: list[Result] = []
    with working(f"running {script.filename}"):
        for result in paced(results(script, limit=limit), seconds, each=True):
            found.append(result)
            report(f"{len(found)} of {len(script.statements)}, past line {result.line}")
    return ScriptResult(tuple(found))
