r"""Poses that equations linear in y allow, taken apart by the rank of these equations.

Over the orientations of an irreducible set, where the rank is r the poses are a bundle of affine spaces of dimension
4 − r: such a stratum is irreducible, of the dimension of the set plus 4 − r. Elimination with cases finds all strata.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.operation_modes.limb_constraints import STUDY, Equation
from gcrules.poses.operation_modes.orientations import Form, Orientations, as_form, pieces

__all__ = ["PoseBundle", "Row", "Stratum", "rows_of", "strata"]

Row = tuple[Form, Form, Form, Form, Form]
"""a0 y0 + … + a3 y3 + c = 0."""


@dataclass(frozen=True)
class Stratum:
    """Poses over a set of orientations: those that solve the rows, which have a leading entry each, in different
    columns, that is 0 in the other rows; the forms in `nonzero` are not 0 there.
    """

    orientations: Orientations
    rows: tuple[Row, ...]
    nonzero: tuple[Form, ...]

    @property
    def dimension(self) -> int:
        """Of the poses."""
        return self.orientations.dimension + 4 - len(self.rows)


@dataclass(frozen=True)
class PoseBundle:
    """A stratum with `rows` that are 0 in it, its own and more: where they have the rank of its own, the poses of its
    closure are those that solve them.
    """

    stratum: Stratum
    rows: tuple[Row, ...]


def rows_of(equations: Sequence[Equation]) -> tuple[list[Row], list[Form]]:
    """Equations with Study's own as rows, and those without y as forms."""
    rows: list[Row] = []
    forms: list[Form] = []
    for e in (STUDY, *equations):
        a0, a1, a2, a3, c = (as_form(form) for form in e)
        if a0 or a1 or a2 or a3:
            rows.append((a0, a1, a2, a3, c))
        else:
            forms.append(c)
    return rows, forms


def strata(rows: Sequence[Row], forms: Sequence[Form], least: int) -> Iterator[Stratum]:
    """All strata of at least this dimension."""
    for piece in pieces(forms):
        yield from _over(piece, list(rows), [], (), least)


def _over(
    piece: Orientations, rows: list[Row], done: list[tuple[int, Row]], nonzero: tuple[Form, ...], least: int
) -> Iterator[Stratum]:
    checkpoint()
    if piece.dimension + 4 - len(done) < least or any(not piece.reduced(f) for f in nonzero):
        return
    done = [(k, _short(_reduced(row, piece), nonzero)) for k, row in done]
    left: list[Row] = []
    for row in rows:
        small = _reduced(row, piece)
        if any(small[:4]):
            left.append(small)
        elif small[4]:
            for smaller in pieces([*piece.basis, small[4]]):
                yield from _over(smaller, rows, done, nonzero, least)
            return
    if not left:
        yield Stratum(piece, tuple(row for _, row in sorted(done, key=lambda own: own[0])), nonzero)
        return
    used = {k for k, _ in done}
    _, _, place, column = min(
        (sum(row[k].LM), len(row[k]), place, k)
        for place, row in enumerate(left)
        for k in range(4)
        if row[k] and k not in used
    )
    chosen = left.pop(place)
    lead = chosen[column]
    if sum(lead.LM):
        for smaller in pieces([*piece.basis, lead]):
            yield from _over(smaller, [chosen, *left], done, nonzero, least)
        nonzero = (*nonzero, lead)
    rest = [_divided(_less(row, chosen, column), nonzero) for row in left]
    before = [(k, _less(row, chosen, column)) for k, row in done]
    yield from _over(piece, rest, [*before, (column, chosen)], nonzero, least)


def _less(row: Row, chosen: Row, column: int) -> Row:
    a0, a1, a2, a3, c = (chosen[column] * p - row[column] * q for p, q in zip(row, chosen, strict=True))
    return a0, a1, a2, a3, c


def _divided(row: Row, nonzero: tuple[Form, ...]) -> Row:
    """The row without factors that are nowhere 0 in the stratum: earlier leading entries, brought in by elimination."""
    for f in nonzero:
        while any(row) and not any(entry.rem([f]) for entry in row):
            a0, a1, a2, a3, c = (entry.exquo(f) for entry in row)
            row = a0, a1, a2, a3, c
    return row


def _reduced(row: Row, piece: Orientations) -> Row:
    a0, a1, a2, a3, c = (piece.reduced(f) for f in row)
    return a0, a1, a2, a3, c


def _short(row: Row, nonzero: tuple[Form, ...]) -> Row:
    """The row without its common divisor, which is not 0 as it divides the leading entry, with whole coefficients."""
    divisor = row[0].ring.zero
    for f in row:
        divisor = divisor.gcd(f) if divisor else f
    if not divisor:
        return row
    forms = [f.exquo(divisor) for f in row]
    denominators: Any = 1
    for f in forms:
        denominators = f.ring.domain.get_ring().lcm(denominators, f.clear_denoms()[0])
    a0, a1, a2, a3, c = (f * denominators for f in forms)
    return a0, a1, a2, a3, c
