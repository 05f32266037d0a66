"""Theorems as ideals of polynomials in coordinates, and whether Singular and Macaulay2 find them true.

A claim holds at all positions that satisfy the hypotheses and at which n does not vanish, if the hypotheses and
1 − n·(y1·c1 + y2·c2 + …) have no common zero, where c are the coordinates of what is claimed to vanish: then 1 is in
their ideal (Rabinowitsch). It is written here as a person would who wants it done fast: free points are a frame, other
points have last coordinate 1, or 0 at infinity, and n is what gcrules says that it assumes not to vanish (of extensors
a combination of their coordinates). So the systems prove a little less than gcrules.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

from gcrules.algebra.assumptions.assumed import equations, resolve
from gcrules.algebra.decide import decide
from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.statements import Claim
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.prove import difference_of

__all__ = ["SYSTEMS", "Answer", "Emitted", "Ideal", "ideals_of", "text_of"]

MEMORY = 4 << 30  # bytes that a system may have


class Emitted:
    """A number of a ring that is not computed: what would be done is written as lines of a program."""

    def __init__(self, text: str, lines: list[str], kind: str = "") -> None:
        self.text, self.lines, self.kind = text, lines, kind

    def _line(self, text: str) -> Emitted:
        name = f"t{len(self.lines)}"
        self.lines.append(f"{self.kind}{name}={text};")
        return Emitted(name, self.lines, self.kind)

    def _with(self, sign: str, other: Any) -> Emitted:
        return self._line(f"{self.text}{sign}({other.text if isinstance(other, Emitted) else other})")

    def __add__(self, other: Any) -> Emitted:
        return self._with("+", other) if other else self

    def __sub__(self, other: Any) -> Emitted:
        return self._with("-", other) if other else self

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, int) and other in (-1, 0, 1):
            return -self if other < 0 else self if other else 0
        return self._with("*", other)

    def __neg__(self) -> Emitted:
        return self._line(f"-{self.text}")

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, other: Any) -> Emitted:
        return self._line(f"{other}-{self.text}") if other else -self


@dataclass(frozen=True)
class Ideal:
    """What a claim says: where `hypotheses` vanish and `nonzero` do not, the coordinates of `claim` vanish."""

    rank: int
    points: Mapping[str, tuple[int | str, ...]]
    hypotheses: tuple[Expr, ...]
    nonzero: tuple[Expr, ...]
    claim: Expr

    @property
    def variables(self) -> tuple[str, ...]:
        return tuple(c for point in self.points.values() for c in point if isinstance(c, str))


@dataclass(frozen=True)
class Answer:
    """What a system found, the seconds that it took once it ran, and the megabytes that it had at most."""

    true: bool
    seconds: float
    megabytes: float


def ideals_of(claim: Claim) -> list[Ideal]:
    """Those of the equations of a claim, which gcrules proves."""
    space, claimed = claim.context, claim.claimed
    told = tuple(parse(text, context=space) for text in decide(claim.claimed, space).assumed)
    nonzero = (*told, *claimed.nonzero)
    hypotheses = tuple(e for a in space.given for e in equations(a, space.rank))
    found = []
    for left, right in claimed.equations:
        difference = difference_of(left, right, space.rank)
        names = points_of(difference, *hypotheses, *nonzero)
        free = resolve(space, names, (difference,)).free if space.given else names
        points = _coordinates(names, free, space.ideal, space.rank)
        found.append(Ideal(space.rank, points, hypotheses, nonzero, difference))
    return found


def _coordinates(
    names: Iterable[str], free: Iterable[str], ideal: Sequence[str], rank: int
) -> dict[str, tuple[int | str, ...]]:
    """Free points are e1, …, ed and their sum; beside points at infinity, d − 1 of them at most, an origin and points
    that differ from it by an ei.
    """
    infinite = [n for n in names if n in ideal]
    chosen = [n for n in infinite if n in set(free)][: rank - 1]
    finite = [n for n in names if n not in ideal and n in set(free)]
    points: dict[str, tuple[int | str, ...]] = {}
    for i, name in enumerate([*chosen, *finite[: rank - len(chosen)]]):
        place = i if i < len(chosen) or not infinite else (rank - 1 if i == len(chosen) else i - 1)
        last = int(bool(infinite) and i >= len(chosen))
        points[name] = tuple(int(k == place or (k == rank - 1 and last == 1)) for k in range(rank))
    if not infinite or len(chosen) == rank - 1:
        points |= dict.fromkeys(finite[rank - len(chosen) :][:1], (1,) * rank)
    numbers = count()
    for name in names:
        if name not in points:
            last = int(name not in ideal)
            points[name] = (*(f"x{next(numbers)}" for _ in range(rank - 1)), last)
    return points


def text_of(ideal: Ideal, system: System) -> str:
    """The program that decides it and prints whether it is true, and the seconds that this took."""
    lines: list[str] = []
    points = {
        n: tuple(Emitted(c, lines, system.kind) if isinstance(c, str) else c for c in p)
        for n, p in ideal.points.items()
    }
    at = Evaluator(points, ideal.rank)
    written = [_text(c) for e in ideal.hypotheses for c in at.value(e)]
    claimed = [_text(c) for c in at.value(ideal.claim)]
    factors = [_combined(at.value(e)) for e in ideal.nonzero]
    factors.append("+".join(f"y{i}*({c})" for i, c in enumerate(claimed)))
    more = [f"y{i}" for i in range(len(claimed))]
    lines += [f"{system.kind}n{i}={factor};" for i, factor in enumerate(factors)]  # a line has a limit
    return system.program.format(
        variables=",".join((*more, *ideal.variables)),
        lines="\n".join(lines),
        hypotheses=",".join(c for c in written if c != "0") or "0",
        claims=",".join(claimed),
        refuted="*".join(f"n{i}" for i in range(len(factors))),
    )


def _text(number: Any) -> str:
    return number.text if isinstance(number, Emitted) else str(number)


def _combined(coordinates: Sequence[Any]) -> str:
    """A combination of coordinates that vanishes where all of them do, and rarely elsewhere."""
    return "+".join(f"{(7, 11, 5, 13, 3, 17)[i % 6] + i // 6}*({_text(c)})" for i, c in enumerate(coordinates))


@dataclass(frozen=True)
class System:
    """A computer algebra system: how it is called, what declares a polynomial there, and its program."""

    name: str
    command: tuple[str, ...]
    kind: str
    program: str

    def decide(self, ideal: Ideal, limit: int) -> Answer | None:
        """Its answer; None where it takes more than `limit` seconds, or too much memory."""
        return run(self.command, text_of(ideal, self), limit)

    @property
    def present(self) -> bool:
        return shutil.which(self.command[0]) is not None


def run(command: Sequence[str], program: str, limit: int) -> Answer | None:
    """What a program says on standard output: `answer`, 1 if all is true, and the seconds that it took. A process that
    another one started counts the memory of that one as its own, so a small one starts it.
    """
    with tempfile.TemporaryFile("w+") as given, tempfile.TemporaryFile("w+") as printed:
        given.write(program)
        given.seek(0)
        launched = subprocess.run(
            [sys.executable, "-ISc", LAUNCHER, str(limit), str(MEMORY), *command],
            stdin=given,
            stdout=printed,
            stderr=subprocess.PIPE,
            text=True,
            check=True,
        )
        printed.seek(0)
        text = printed.read()
    stopped, kilobytes = map(int, launched.stderr.split())
    if stopped:
        return None
    found = re.search(r"answer (\d) ([\d.e-]+)", text)
    if not found and re.search("halt|memory", text):  # Singular's last words
        return None
    assert found, text[-2_000:]
    return Answer(found[1] == "1", float(found[2]), kilobytes / 1024)


LAUNCHER = """\
import os, resource, signal, sys
limit, memory, *command = sys.argv[1:]
process = os.fork()
if not process:
    os.dup2(1, 2)
    resource.setrlimit(resource.RLIMIT_AS, (int(memory), int(memory)))
    os.execvp(command[0], command)
stopped = []
signal.signal(signal.SIGALRM, lambda *_: (stopped.append(1), os.kill(process, signal.SIGKILL)))
signal.alarm(int(limit))
used = os.wait4(process, 0)[2]
print(len(stopped), used.ru_maxrss, file=sys.stderr)
"""

SINGULAR = """\
system("--ticks-per-sec",1000);
ring r=0,({variables}),dp;
proc once() {{
{lines}
ideal h={hypotheses};
ideal c={claims};
if(size(c)==0) {{ return(1); }}
ideal g=std(h+ideal(1-{refuted}));
return(g[1]==1);
}}
int began=rtimer;
int times=0;
int zero=1;
while(rtimer-began<200) {{ zero=zero and once(); times=times+1; }}
ring s=0,x,dp;
number spent=number(rtimer-began)/(1000*times);
print("answer "+string(zero)+" "+string(int(spent*10000000))+"e-7");
quit;
"""

MACAULAY2 = """\
R=QQ[{variables},MonomialOrder=>GRevLex];
once=()->(
{lines}
h:=ideal(0_R,{hypotheses});
c:=ideal(0_R,{claims});
c==0 or 1%(h+ideal(1_R-{refuted}))==0);
spent=0.;
runs=0;
found=true;
while spent<0.2 do (one=elapsedTiming once(); spent=spent+one#0; found=found and one#1; runs=runs+1);
print("answer "|(if found then "1" else "0")|" "|toString(spent/runs));
exit 0
"""

SYSTEMS = (
    System("Singular", ("Singular", "-q", "--no-rc"), "poly ", SINGULAR),
    System("Macaulay2", ("M2", "--script", "/dev/stdin"), "", MACAULAY2),
)
