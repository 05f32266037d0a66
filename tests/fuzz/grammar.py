"""Well-typed expressions of the language as text, drawn at random."""

from __future__ import annotations

from dataclasses import dataclass
from random import Random

__all__ = ["LETTERS", "UNUSUAL", "WORDS", "Grammar", "legs", "script"]

LETTERS = "abcdefghijklmn"
UNUSUAL = ("A", "S1", "S_2", "A'", "B2''", "p10", "ȧ", "Z")
LONG = ("left", "right", "top", "base")

WORDS = (
    *("a", "b", "ab", "abc", "abcd", "[abcd]", "[abc]", "2", "1/2", "0", "64", "65", "(", ")", "[", "]", "[[", "]]"),
    *("/\\", "\\/", "∧", "∨", "^", "+", "-", "−", "*", "·", "**", "==", "=", "=>", ",", ".", "...", "…", "#", '"', ":"),
    *("rank", "points", "ideal", "let", "claim", "show", "given", "rewrite", "rule", "if", "source", "fires", "silent"),
    *("collinear", "coplanar", "concurrent", "incident", "R...", "%", "%%", ":help", "\\wedge", "\\cap", "left", "<"),
)


@dataclass
class Grammar:
    """Draws expressions of a rank over few points, so that they repeat and much cancels."""

    rng: Random
    rank: int = 4
    names: tuple[str, ...] = tuple(LETTERS[:6])
    unicode: bool = False

    @classmethod
    def drawn(cls, rng: Random) -> Grammar:
        """A rank and points, mostly the usual ones."""
        rank = rng.choices((2, 3, 4, 5, 6, 7, 8), (2, 5, 9, 1, 1, 0.2, 0.2))[0]
        names = tuple(LETTERS[: rng.randint(rank, min(len(LETTERS), rank + 4))])
        if rng.random() < 0.1:
            names = (*names[:-1], rng.choice(UNUSUAL[:6]))
        return cls(rng, rank, names, rng.random() < 0.1)

    def sign(self, ascii_sign: str, others: tuple[str, ...]) -> str:
        if not self.unicode:
            return ascii_sign
        return self.rng.choice((ascii_sign, *others))

    def point(self) -> str:
        return self.rng.choice(self.names)

    def points(self, number: int) -> str:
        if self.rng.random() < 0.9 and number <= len(self.names):
            found = self.rng.sample(self.names, number)
        else:
            found = [self.point() for _ in range(number)]
        return self.rng.choice(("", "", "", " ")).join(found)

    def number(self) -> str:
        rng = self.rng
        return rng.choice(("0", "1", "2", "3", "7", "12", "1/2", "2/3", "5/7", "1000000007", "1/9999991"))

    def bracket(self) -> str:
        return f"[{self.points(self.rank)}]"

    def scalar(self, depth: int) -> str:
        rng = self.rng
        if depth <= 0:
            return self.bracket() if rng.random() < 0.85 else self.number()
        kind = rng.choices(
            ("bracket", "product", "sum", "meet", "power", "extensors", "superbracket", "number", "minus", "dotted"),
            (3, 5, 5, 4, 1, 2, 0.7, 0.5, 1, 0.7),
        )[0]
        match kind:
            case "bracket":
                return self.bracket()
            case "product":
                times = rng.choice(("", " ", self.sign("*", ("·", "×"))))
                return times.join(self.factor(depth - 1) for _ in range(rng.randint(2, 3)))
            case "sum":
                return self.sum([self.scalar(depth - 1) for _ in range(rng.randint(2, 4))])
            case "meet":
                return f"({self.meet(0, depth - 1)})"
            case "power":
                return f"{self.factor(depth - 1)}**{rng.choice((0, 1, 2, 2, 3))}"
            case "extensors":
                return f"[{', '.join(self.part(k, depth - 1) for k in self.split(self.rank))}]"
            case "superbracket" if self.rank in (3, 4):
                lines = (self.part(2, rng.randint(0, 1)) for _ in range(3 if self.rank == 3 else 6))
                return f"[[{', '.join(lines)}]]"
            case "minus":
                return f"-{self.factor(depth - 1)}"
            case "dotted":
                dotted = rng.sample(self.names, 2)
                rows = [[f".{d}", *(self.point() for _ in range(self.rank - 1))] for d in dotted]
                return "".join(f"[{' '.join(row)}]" for row in rows)
        return self.number()

    def factor(self, depth: int) -> str:
        found = self.scalar(depth)
        return found if found.startswith("[") and found.count("[") == 1 else f"({found})"

    def part(self, step: int, depth: int) -> str:
        """An extensor that may stand as an entry or an operand."""
        if depth <= 0:
            return self.points(step)
        found = self.extensor(step, depth)
        return f"({found})"

    def extensor(self, step: int, depth: int) -> str:
        rng = self.rng
        if step == 0:
            return self.scalar(depth)
        if depth <= 0:
            return self.points(step)
        kind = rng.choices(("points", "join", "meet", "sum", "times"), (4, 2, 4 * (step < self.rank), 1, 1))[0]
        match kind:
            case "join":
                return self.sign(" \\/ ", ("∨", " \\vee ")).join(self.part(k, depth - 1) for k in self.split(step))
            case "meet":
                return self.meet(step, depth - 1)
            case "sum":
                return self.sum([self.extensor(step, depth - 1) for _ in range(2)])
            case "times":
                return f"{self.factor(depth - 1)} ({self.extensor(step, depth - 1)})"
        return self.points(step)

    def meet(self, step: int, depth: int) -> str:
        total = step + self.rank
        k = self.rng.randint(max(1, total - self.rank), min(self.rank, total - 1))
        sign = self.sign(" /\\ ", ("∧", " ^ ", " \\wedge "))
        return f"{self.part(k, depth)}{sign}{self.part(total - k, depth)}"

    def sum(self, terms: list[str]) -> str:
        found = terms[0]
        for term in terms[1:]:
            found += self.rng.choice((" + ", " - ", "+", "-", self.sign(" - ", (" − ",)))) + term
        return found

    def split(self, total: int) -> list[int]:
        """`total` as a sum of positive numbers."""
        parts = []
        while total:
            parts.append(self.rng.randint(1, total))
            total -= parts[-1]
        return parts

    def equation(self, depth: int) -> str:
        """Two sides of one step: often equal."""
        rng, step = self.rng, self.rng.choices((0, 1, 2), (6, 1, 1))[0]
        step = min(step, self.rank - 1)
        left = self.extensor(step, depth)
        right = rng.choice(
            (left, f"-({left})", f"{left} + {left}", self.extensor(step, depth), "0" if not step else left)
        )
        return f"{left} == {right}"

    def assumption(self) -> str:
        rng = self.rng
        kind = rng.choices(
            ("collinear", "coplanar", "concurrent", "incident", "equation", "ideal"), (4, 2, 2, 2, 1, 1)
        )[0]
        match kind:
            case "collinear" | "coplanar":
                return f"{kind}({', '.join(self.point() for _ in range(rng.randint(2, 5)))})"
            case "concurrent":
                return f"concurrent({', '.join(self.points(2) for _ in range(rng.randint(2, 4)))})"
            case "incident":
                return f"incident({self.point()}, {self.points(rng.randint(1, self.rank - 1))})"
            case "equation":
                return self.equation(1)
        return f"ideal {' '.join(rng.sample(self.names, rng.randint(1, 3) if len(self.names) > 2 else 1))}"

    def assumptions(self) -> str:
        return ", ".join(self.assumption() for _ in range(self.rng.choices((1, 2, 3), (6, 3, 1))[0]))

    def rule(self) -> str:
        """A rule of a script; most are no identities."""
        rng = self.rng
        left = self.extensor(rng.choice((0, 0, 1)), 1)
        right = rng.choice((left, f"-({left})", self.scalar(1), "0", f"({left}) * 1"))
        sentence = rng.choice(("", ' "a sentence"'))
        found = f"rule r{rng.randint(1, 3)}{sentence}: {left} => {right}"
        if rng.random() < 0.3:
            p, q = self.point(), self.point()
            found += f" if {rng.choice((f'{p} < {q}', f'{p} != {q}', self.assumption()))}"
        for clause in ("fires", "silent"):
            if rng.random() < 0.2:
                found += f"\n  {clause} {self.scalar(1)}"
        return found


_KNOWN_LEGS = (
    *("ab af cb cd ed ef", "Aa Ab Bc Bd Ce Cf", "Aa Ab Ac Bd Be Cf", "Aa Bb Cc Dd Ee Ff", "Aa Ab Ba Bb Cc Dd"),
    *("Aa Ab Ac Bd Ce Df", "Aa Ab Bc Cd De Ef", "ab bc ca de fg hi", "Aa Ab Bc Bd Ce Df", "Aa Bb Cc ij jk ki"),
)


def legs(rng: Random, *, number: int | None = None) -> str:
    """Legs: those of known classes relabelled, any pairs of points, lines built from points."""
    kind = rng.choices(("known", "pairs", "bipartite", "built", "names"), (3, 3, 3, 1, 0.5))[0]
    n = number or rng.choices((6, 5, 7, 1, 3, 0), (30, 1, 1, 0.3, 1, 0.2))[0]
    if kind == "known":
        found = rng.choice(_KNOWN_LEGS).split()
        if rng.random() < 0.5:
            names = sorted(set("".join(found)))
            found = [
                "".join(dict(zip(names, rng.sample(names, len(names)), strict=True))[c] for c in leg) for leg in found
            ]
        rng.shuffle(found)
        return " ".join(found)
    if kind == "names":
        return ", ".join(f"{rng.choice(LONG)} {rng.choice(('u1', 'v', 'arm_1', 'w'))}" for _ in range(n))
    letters = LETTERS[: rng.randint(4, 12)]
    if kind == "built":
        plane = "".join(rng.sample(letters, 3)) + rng.choice((" /\\ ", " ^ ")) + "".join(rng.sample(letters, 3))
        return ", ".join(
            rng.sample([*("".join(rng.sample(letters, 2)) for _ in range(max(n, 1) - 1)), plane], max(n, 1))
        )
    upper = letters.upper()[: rng.randint(2, 6)] if kind == "bipartite" else letters
    return rng.choice((" ", " ", ", ")).join(rng.choice(upper) + rng.choice(letters) for _ in range(n))


def script(rng: Random) -> str:
    """A script: declarations, then statements."""
    g = Grammar.drawn(rng)
    lines = [f"rank {g.rank}"] if g.rank != 4 or rng.random() < 0.3 else []
    if rng.random() < 0.3:
        lines.append(f"points {' '.join(rng.sample(g.names, len(g.names)))}")
    if rng.random() < 0.15:
        lines.append(f"ideal {' '.join(rng.sample(g.names, rng.randint(1, min(3, len(g.names)))))}")
    bound: list[str] = []
    for _ in range(rng.randint(1, 6)):
        depth = rng.choices((0, 1, 2), (2, 4, 1))[0]
        kind = rng.choices(("let", "claim", "show", "given", "rule", "rewrite", "comment"), (3, 5, 3, 1, 1, 1, 0.5))[0]
        match kind:
            case "let":
                name = rng.choice(("x", "y", "z", "q1", "p'"))
                lines.append(f"let {name} = {g.extensor(rng.randint(0, g.rank - 1), depth)}")
                bound.append(name)
            case "claim":
                label = rng.choice(("", "", '"a label": ', '"": ', '"ü∧": '))
                lines.append(f"claim {label}{g.equation(depth)}")
            case "show":
                again = bound and rng.random() < 0.5
                lines.append(f"show {rng.choice(bound) if again else g.extensor(rng.randint(0, 2), depth)}")
            case "given":
                lines.append(f"given {g.assumptions()}")
            case "rule":
                lines.append(g.rule())
            case "rewrite":
                lines.append(f"rewrite {g.scalar(depth)}")
            case "comment":
                lines.append("# nothing")
    return "\n".join(lines) + rng.choice(("", "\n"))
