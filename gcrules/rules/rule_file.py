r"""Files of rules: every rule is proved, tried on its cases and watched for loops before anything uses it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from graphlib import CycleError, TopologicalSorter
from os import PathLike, fspath
from typing import Any

from gcrules.algebra import claims
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.rule_text import Case, Instance, Order, RuleText
from gcrules.algebra.language.statements import Script, parse_script
from gcrules.algebra.letters import letter_of
from gcrules.algebra.prove import Proof, prove
from gcrules.algebra.space import Space
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, GcrulesError, InputError, LimitReached, join_faults
from gcrules.core.proof_memory import digest_of, remember, remembered
from gcrules.core.yaml_file import read_text
from gcrules.rules.identity import Identity, instance_fault, rewrite_all

__all__ = ["RuleCheck", "check_rule", "check_script", "identities", "load_rule_file"]


@dataclass(frozen=True)
class RuleCheck:
    """What became of a rule: `verdict` is proved, refuted, undecided, or refused (it loops, never fires or fails one of
    its cases); `fault` says what is wrong, with its place.

    `ranks` are those in which the identity was proved; `proof` is the one that failed, where one did.
    """

    rule: Identity
    place: str
    verdict: str
    ranks: tuple[int, ...]
    fault: GcrulesError | None = None
    proof: Proof | None = None
    assumed: tuple[str, ...] = ()

    @property
    def ok(self) -> bool:
        return self.verdict == "proved" and self.fault is None

    @property
    def reason(self) -> str:
        """What was found, in words."""
        if self.fault is not None:
            return self.fault.message
        ranks = f"rank {self.ranks[0]}" if len(self.ranks) == 1 else _listed(self.ranks)
        return f"proved in {ranks}" + (f", where {', '.join(self.assumed)} does not vanish" if self.assumed else "")

    def to_json(self) -> dict[str, Any]:
        return {
            "id": self.rule.id,
            "place": self.place,
            "verdict": self.verdict,
            "ranks": list(self.ranks),
            "assumed": list(self.assumed),
            "fault": self.fault.message if self.fault else None,
            "counterexample": self.proof.to_json()["counterexample"] if self.proof else None,
        }


def _listed(ranks: tuple[int, ...]) -> str:
    return f"ranks {ranks[0]} to {ranks[-1]}"


def load_rule_file(path: str | PathLike[str], *, proved: bool = True) -> tuple[Identity, ...]:
    """The rules of a `.gca` file. Raises InputError, with the place of each rule that is wrong, all at once.

    A rule that was proved before, by the same engine, is not proved again (see `core.proof_memory`). With
    `proved=False` the rules are read only: for files that are checked elsewhere.
    """
    name, text = fspath(path), read_text(path)
    if not proved:
        return _unproved(text, name)
    found = list(check_script(_script_of_rules(text, name), recheck=False))
    faults = [f.fault for f in found if f.fault is not None]
    if faults:
        raise join_faults(faults)
    return tuple(f.rule for f in found)


def _script_of_rules(text: str, name: str) -> Script:
    script = parse_script(text, name)
    if not script.rules:
        raise FileError("the file holds no rules", filename=name, hint='rules are written  rule ID "sentence": A => B')
    return script


@lru_cache(maxsize=16)
def _unproved(text: str, name: str) -> tuple[Identity, ...]:
    """Rules that come with gcrules are asked for again and again in one process."""
    return identities(_script_of_rules(text, name))


def identities(script: Script) -> tuple[Identity, ...]:
    """The rules of a script as they stand, unproved."""
    return tuple(_identity(rule, script.filename) for rule in script.rules)


def _identity(rule: RuleText, filename: str) -> Identity:
    return Identity(
        id=rule.id,
        sentence=rule.sentence,
        source=rule.source,
        fires=tuple(c.text for c in rule.fires),
        silent=tuple(c.text for c in rule.silent),
        owner=f"{filename}:{rule.line}",
        text=rule.text,
        instances=rule.instances,
    )


def check_script(script: Script, *, limit: int = MAX_TERMS, recheck: bool = True) -> Iterator[RuleCheck]:
    """Each rule of a script, one after the other."""
    for rule in script.rules:
        yield check_rule(rule, script, limit=limit, recheck=recheck)


def check_rule(rule: RuleText, script: Script, *, limit: int = MAX_TERMS, recheck: bool = True) -> RuleCheck:
    """Prove a rule in each of its ranks, let it run on its own left side and its cases. Without `recheck` proofs that
    are remembered count, which do not tell what was `assumed`.
    """
    identity = _identity(rule, script.filename)
    place = f"{script.filename}:{rule.line}"
    proved: list[int] = []
    assumed: dict[str, None] = {}

    def wrong(fault: GcrulesError, verdict: str = "refuted", proof: Proof | None = None) -> RuleCheck:
        fault.span = fault.span or rule.span
        return RuleCheck(identity, place, verdict, tuple(proved), fault.located(script.source, script.filename), proof)

    for instance in rule.instances:
        shape = instance_fault(instance)
        if shape:
            return wrong(InputError(f"the rule {rule.id} {shape}"), "refused")
        digest = _digest(instance)
        if not recheck and remembered(digest):
            proved.append(instance.rank)
            continue
        proof = _proof(instance, limit)
        if proof.verdict == "refuted":
            return wrong(
                InputError(f"the rule {rule.id} is not an identity{_where(proof, instance, rule)}"), proof=proof
            )
        if proof.verdict != "proved":
            return wrong(LimitReached(f"the rule {rule.id} is not decided: {proof.reason}"), "undecided", proof)
        remember(digest)
        proved.append(instance.rank)
        assumed.update(dict.fromkeys(proof.assumed))
    fault = _runs(identity, rule)
    if fault:
        return wrong(fault, "refused")
    return RuleCheck(identity, place, "proved", tuple(proved), assumed=tuple(assumed))


def _digest(instance: Instance) -> str:
    given = [" ".join([a.kind, *map(claims.digest, a.args)]) for a in instance.given]
    return digest_of("rule", str(instance.rank), claims.digest(instance.left), claims.digest(instance.right), *given)


def _proof(instance: Instance, limit: int) -> Proof:
    return prove(instance.left, instance.right, rank=instance.rank, given=instance.given, limit=limit)


def _where(proof: Proof, instance: Instance, rule: RuleText) -> str:
    """The exact points that refute a rule."""
    points = "; ".join(f"{n} = ({', '.join(map(str, c))})" for n, c in (proof.counterexample or {}).items())
    rank = f" in rank {instance.rank}" if len(rule.instances) > 1 else ""
    values = (
        "" if proof.values is None else f", where the left side is {proof.values[0]}, the right side {proof.values[1]}"
    )
    return f"{rank}: at {points}{values}"


def _runs(identity: Identity, rule: RuleText) -> GcrulesError | None:
    """What goes wrong on the rule's own left side and on its cases: silence, firing, or a loop."""
    fires = 0
    for instance in rule.instances:
        try:
            space = Space(instance.rank, _in_order(instance), given=instance.given)
        except CycleError as cycle:
            return InputError(f"the guards of the rule {rule.id} contradict each other: {' < '.join(cycle.args[1])}")
        try:
            fires += bool(list(rewrite_all(instance.left, (identity,), space)))
        except LimitReached as loop:
            return InputError(loop.message, hint=loop.hint)
    at = rule.context
    space = Space(at.rank, at.points, at.ideal, at.given)
    for case, expected in [*((c, True) for c in rule.fires), *((c, False) for c in rule.silent)]:
        fault = _case(identity, case, expected, space)
        if fault:
            return fault
    if not fires and not rule.fires:
        guard = " under its guards" if any(i.guards for i in rule.instances) else ""
        return InputError(
            f"the rule {rule.id} does not fire on its own left side{guard}",
            hint="show where it fires:  fires EXPR" if guard else "the two sides are the same polynomial",
        )
    return None


def _in_order(instance: Instance) -> tuple[str, ...]:
    """The points of the left side in an order that the guards ask for. Raises CycleError where there is none."""
    after: dict[str, list[str]] = {n: [] for n in points_of(instance.left) if letter_of(n) is None}
    for guard in instance.guards:
        if isinstance(guard, Order) and guard.sign == "<":
            after[guard.right].append(guard.left)
    return tuple(TopologicalSorter(after).static_order())


def _case(identity: Identity, case: Case, expected: bool, space: Space) -> GcrulesError | None:
    try:
        fired = bool(list(rewrite_all(case.expr, (identity,), space)))
    except LimitReached as loop:
        return InputError(loop.message, hint=loop.hint, span=case.span)
    if fired == expected:
        return None
    what = "stays silent on" if expected else "fires on"
    return InputError(f"the rule {identity.id} {what} {case.text}", span=case.span)
