"""The commands of the algebra: prove, expand, straighten."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.decide import decide
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expand import expand as expanded
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.relations import parse_claim
from gcrules.algebra.straightening.straighten import Straightening, straighten_steps
from gcrules.algebra.straightening.straighten import straighten as straightened
from gcrules.algebra.whole_letters import in_letters
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.expressions import argument_text, context_of, read_expression
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.options import SpaceOptions, given_option, limit_option, space_options
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options
from gcrules.apps.cli.verdicts import EXIT_CODES, coloured
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.views.formulas.latex import latex
from gcrules.views.results.proof import conditions

__all__ = ["expand", "prove", "straighten"]

_limit = limit_option(MAX_TERMS, "Give up beyond this many terms.")
_seconds = time_limit()


@click.command(cls=ExpressionCommand)
@click.argument("claim", metavar="CLAIM")
@given_option
@space_options(metric=True)
@_limit
@_seconds
@proof_options
@output_options()
@click.pass_context
def prove(
    ctx: click.Context,
    claim: str,
    assumptions: tuple[str, ...],
    space: SpaceOptions,
    limit: int,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Decide whether two expressions are equal, or a relation holds, for all positions; "-" reads standard input.

    \b
    gcrules prove "ab /\\ cde == [acde] b - [bcde] a"
    gcrules prove "[[Aa,Ab,Ac,Bd,Be,Cf]] == [Aabc][ABde][ABCf]" --json
    gcrules prove "collinear(b, c, d)" --rank 3 --given "collinear(a, b, c), collinear(a, b, d)"
    gcrules prove "perpendicular(c \\/ orthocentre(a, b, c), ab)" --rank 3 --isotropic "i j"

    With --given only positions that satisfy the assumptions count, and the answer says what else was assumed not to
    vanish. (expand and straighten do without assumptions: their polynomials hold for all positions.)

    Exit code 0: proved, by equal normal forms. 1: refuted; exact points at which the sides differ are shown.
    3: not decided within the limit.
    """
    at = context_of(space, assumptions)
    claimed = parse_claim(argument_text(claim), at)
    with working("proving"):
        proof = decide(claimed, at, limit=limit)
    if out.latex:
        out.write(
            "\n".join([proof.latex(), f"% {proof.verdict}: {proof.reason}", *(f"%{c}" for c in conditions(proof))])
        )
    else:
        out.show(proof, coloured(proof.verdict, proof.text(unicode=out.unicode)))
    proofs.write(proof, proof.verdict)
    ctx.exit(EXIT_CODES[proof.verdict])


@click.command(cls=ExpressionCommand)
@click.argument("expression", metavar="EXPR")
@space_options(metric=True)
@_limit
@_seconds
@output_options()
def expand(expression: str, space: SpaceOptions, limit: int, out: Output) -> None:
    """Expand an expression into brackets: a bracket polynomial, or a sum of extensors with such coefficients.

    \b
    gcrules expand "abf /\\ ace /\\ edf /\\ cbd"
    gcrules expand "[[ab,af,cb,cd,ed,ef]]" --latex

    "-" reads standard input. The result is text of the language again.
    """
    e, at = read_expression(expression, space)
    with working("expanding"):
        found = expanded(e, points=at.points, ideal=at.ideal, rank=at.rank, limit=limit)
    out.show(_Polynomial(found, short=out.terminal))


@click.command(cls=ExpressionCommand)
@click.argument("expression", metavar="EXPR")
@click.option("--steps", is_flag=True, help="Show every syzygy that is used (scalars only).")
@space_options(metric=True)
@_limit
@_seconds
@output_options()
def straighten(expression: str, steps: bool, space: SpaceOptions, limit: int, out: Output) -> None:
    """The normal form of an expression: its bracket monomials as standard tableaux.

    \b
    gcrules straighten "[p1p4p5][p1p5p6][p2p3p4]" --rank 3 --steps
    gcrules straighten "[afgl][behk][cdij]"

    The tableau order is that of --points, else sorted; points at infinity come first. "-" reads standard input.
    """
    e, at = read_expression(expression, space)
    with working("straightening"):
        found = expanded(e, points=at.points, ideal=at.ideal, rank=at.rank, limit=limit)
        if not steps:
            out.show(_Polynomial(straightened(found, limit=limit), short=out.terminal))
            return
        if not isinstance(found, BracketPolynomial):
            raise InputError(f"--steps shows scalars only, this is an expression of step {found.step}")
        normal, syzygies = straighten_steps(found)
    out.show(_Polynomial(normal, syzygies, short=out.terminal))


@dataclass(frozen=True)
class _Polynomial:
    """A polynomial with its steps, in the forms in which it is shown."""

    value: BracketPolynomial | ExtensorPolynomial
    steps: tuple[Straightening, ...] | None = None
    short: bool = False

    def to_json(self) -> dict[str, Any]:
        found = self.value.to_json()
        if self.steps is not None:
            found["steps"] = [{"rule": "syzygy", "before": str(s.before), "after": str(s.after)} for s in self.steps]
        return found

    def text(self, *, unicode: bool = False) -> str:
        def shown(p: BracketPolynomial | ExtensorPolynomial) -> str:
            return p.text(unicode=unicode, short=self.short)

        return "\n".join(self._lines(shown, "", " = "))

    def latex(self) -> str:
        return "\n".join(self._lines(lambda p: _latex(in_letters(p)), " \\\\", " = "))

    def _lines(
        self, shown: Callable[[BracketPolynomial | ExtensorPolynomial], str], end: str, equals: str
    ) -> list[str]:
        steps = [f"{shown(s.before)}{equals}{shown(s.after)}{end}" for s in self.steps or ()]
        return [*steps, shown(self.value)]


def _latex(e: Expr) -> str:
    return latex(e)
