"""The import of a model, as text and as LaTeX: what was read, what was merged, and by how much joints were moved."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from gcrules.core.floats import rounded_up
from gcrules.views.formulas.latex_text import latex_table, latex_words
from gcrules.views.results.result_account import Facts, ResultAccount
from gcrules.views.text_tables import ASCII, table

if TYPE_CHECKING:
    from gcrules.mechanisms.models.imported import Imported

__all__ = ["account", "as_latex", "as_text", "limits_of"]

_MOST = 8
_LITTLE = 1e-9  # what is less may be rounding, whose digits are those of a machine


def as_text(r: Imported, *, unicode: bool = False) -> str:
    """The account of an import; without `unicode` in ASCII."""
    found = "\n".join(table([*_rows(r)]))
    return found if unicode else found.translate(ASCII)


def as_latex(r: Imported) -> str:
    """The same as a tabular."""
    return latex_table([(latex_words(name), latex_words(value)) for name, value in _rows(r)])


def account(r: Imported) -> ResultAccount:
    """What there is to say of it."""
    said = f"{r.robot.title} ({r.format.upper()}) is read as {r.robot.chain}: {r.platform} moves relative to {r.base}"
    return ResultAccount(f"{said}, mobility {r.robot.mobility}.", (Facts(tuple(_rows(r))),))


def limits_of(r: Imported) -> dict[str, str]:
    """What each driven joint of the model reaches from home, in metres or radians."""
    return {name: _ends(low, high) for name, low, high in r.limits}


def _ends(low: float, high: float) -> str:
    return f"{low:.6g} to {high:.6g}"


def _rows(r: Imported) -> Iterator[tuple[str, str]]:
    yield "model", f"{r.robot.title} ({r.format.upper()}), {r.size:.4g} m across its joints"
    yield "base", r.base
    yield "platform", f"{r.platform}, {r.why}; mobility {r.robot.mobility}"
    for limb in r.limbs:
        names = list(dict.fromkeys(n for _, own in limb.joints for n in own))
        yield limb.name, f"{limb.chain}: {_several(names)}"
    merged = dict.fromkeys(f"{len(names)} joints to {kind}" for limb in r.limbs for kind, names in limb.merged)
    for said in merged:
        example = next(n for limb in r.limbs for kind, n in limb.merged if f"{len(n)} joints to {kind}" == said)
        yield "merged", f"{said}: {_several(example)}" + (", and so on" if _count(r, said) > 1 else "")
    yield "driven", _several([f"{q} = {joint}" for q, joint in r.drives], most=24)
    if r.limits:
        yield "limits", _several([f"{n} {words}" for n, words in limits_of(r).items()], most=24) + "; from home"
    if r.left_out:
        yield "left out", f"{_several(r.left_out)}: between {r.base} and {r.platform} these hold nothing"
    yield "moved", _moved(r)
    for said in r.exact:
        yield "exact", said
    yield (
        "checked",
        (
            "the wrenches of each limb at home, free and locked, against the twists of the model's joints:"
            f" power {_power(r.deviation)}"
        ),
    )
    for note in r.notes:
        yield "note", note


def _count(r: Imported, said: str) -> int:
    return sum(f"{len(n)} joints to {kind}" == said for limb in r.limbs for kind, n in limb.merged)


def _moved(r: Imported) -> str:
    distance, angle = (x if x > _LITTLE * unit else 0.0 for x, unit in zip(r.farthest, (r.size, 1.0), strict=True))
    if not distance and not angle:
        return f"no joint was moved (tolerance {r.tolerance:g})"
    parts = {m.joint: max(m.distance / r.size, m.angle) for m in r.moved}
    most = max(parts.values()) - _LITTLE
    farthest = next(joint for joint, part in parts.items() if part >= most)
    count = sum(part > _LITTLE for part in parts.values())
    said = f"{count} {'joint' if count == 1 else 'joints'} to make axes and centres exact, by {distance:.2g} m and"
    return f"{said} {angle:.2g} rad at most ({farthest} the farthest; tolerance {r.tolerance:g})"


def _power(deviation: float) -> str:
    return f"{rounded_up(deviation, 2)} at most" if deviation > _LITTLE else "below 1e-9"


def _several(names: Sequence[str], sign: str = ", ", most: int = _MOST) -> str:
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return sign.join(names[:most]) + more
