r"""Scripts: the statements of a `.gca` file, and assumptions as the command line takes them.

>>> script = parse_script("given collinear(a, b, c)   claim [abcd] == 0")
>>> [str(a) for a in script.context.given], script.statements[0].label
(['collinear(a, b, c)'], '[abcd] == 0')
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.parse_tree import Node, read, span_of, whole
from gcrules.algebra.language.relations import Claimed, read_assumptions, read_claim
from gcrules.algebra.language.rule_text import Case, RuleText, instances
from gcrules.algebra.language.syntax import Builder, Context
from gcrules.algebra.language.with_polars import WithPolars
from gcrules.algebra.language.words import METRICS, with_infinity
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import LETTERS, SCREW, letter_name, letter_step
from gcrules.algebra.names import NAME, NAMES_HINT
from gcrules.algebra.space import SourcePlace, shortened
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import GcrulesError, InputError, Span, SyntaxFault

__all__ = [
    "Claim",
    "Rewrite",
    "Script",
    "Show",
    "Statement",
    "parse_assumption",
    "parse_letters",
    "parse_script",
]


@dataclass(frozen=True, slots=True)
class Claim:
    """`claim LHS == RHS`, or a relation, of a script, with its line and the context it was made in."""

    claimed: Claimed
    label: str
    line: int
    context: Context


@dataclass(frozen=True, slots=True)
class Show:
    """`show EXPR` of a script."""

    expr: Expr
    label: str
    line: int
    context: Context


@dataclass(frozen=True, slots=True)
class Rewrite:
    """`rewrite EXPR` of a script: by the rules that stand before it."""

    expr: Expr
    label: str
    line: int
    context: Context


Statement = Claim | Show | Rewrite | RuleText


@dataclass(frozen=True, slots=True)
class Script:
    """The statements of a file that ask for an answer, and the context at its end; `source` is the text itself."""

    statements: tuple[Statement, ...]
    context: Context
    source: str = ""
    filename: str = "<input>"

    @property
    def rules(self) -> tuple[RuleText, ...]:
        return tuple(s for s in self.statements if isinstance(s, RuleText))


def parse_script(text: str, filename: str = "<input>", context: Context | None = None) -> Script:
    """Read the statements of a `.gca` file: rank, points, ideal, line, plane, given, let, claim, show, rule, rewrite.

    `context` is what came before, for texts that are read piece by piece. Raises SyntaxFault, StepError and
    InputError with line and column.
    """
    return read(text, "script", filename, lambda tree: _Reader(text, filename, context).script(tree))


def parse_assumption(text: str, context: Context | None = None) -> Context:
    """The context with more assumptions, as `given` takes them: "collinear(a, b, c), [abcd] == 0", "ideal i j"."""
    return read(text, "assumptions", "<input>", lambda tree: _Reader(text, "<input>", context).assumed(tree))


def parse_letters(text: str, context: Context) -> Context:
    """The context with letters that stand for lines, planes or hyperplanes: "line L M, plane P". Raises InputError."""
    hint = f'letters are declared by {listed(LETTERS)}: "line L M, plane P"'
    try:
        found = parse_assumption(text, context)
    except SyntaxFault as fault:
        fault.hint = fault.hint or hint
        raise
    before = {key: getattr(context, key) for key in ("letters", "screws", "conics")}
    if replace(found, **before) != context or found == context:
        raise InputError("this declares more than letters, or none", hint=hint, span=Span(0, len(text)), source=text)
    return found


class _Reader:
    """Collects the statements; one method for each."""

    def __init__(self, text: str, filename: str, context: Context | None) -> None:
        self.text = text
        self.filename = filename
        self.ranked = False  # whether the file chooses a rank, in which all its rules stand
        self.context = context or Context()
        self.statements: list[Statement] = []
        self.ids: dict[str, int] = {}

    def script(self, tree: Node) -> Script:
        for item in tree.children:
            try:
                getattr(self, f"_{item.data}")(item)
            except GcrulesError as fault:
                fault.span = fault.span or span_of(item)
                raise
        return Script(tuple(self.statements), self.context, self.text, self.filename)

    def _line(self, item: Node) -> int:
        return span_of(item).line_column(self.text)[0]

    def _source(self, *trees: Node) -> str:
        start, end = span_of(trees[0]).start, span_of(trees[-1]).end
        return " ".join(self.text[start:end].split())

    def _rank(self, item: Node) -> None:
        if self.statements or self.context != Context() or self.ranked:
            raise InputError("`rank` must come before every other statement")
        self.context = replace(self.context, rank=whole(item.children[0], "a rank"))
        self.ranked = True

    def _points(self, item: Node) -> None:
        """Every word is one name."""
        self.context = replace(self.context, points=self._declared(self.context.points, item.children[0].children))

    def _ideal(self, item: Node) -> None:
        self.context = replace(self.context, ideal=self._declared(self.context.ideal, item.children[0].children))

    def _isotropic(self, item: Node) -> None:
        self._metric(item.data, item.children[0].children, item)

    def _orthonormal(self, item: Node) -> None:
        self._metric(item.data, item.children[0].children, item)

    def _metric(self, kind: str, tokens: list[Node], tree: Node) -> None:
        """Points at infinity by which right angles are known."""
        try:
            self.context = with_infinity(self.context, kind, self._declared((), tokens))
        except GcrulesError as fault:
            fault.span = fault.span or span_of(tree)
            raise

    def _letters(self, item: Node) -> None:
        kind, *tokens = item.children
        self._lettered(kind, tokens[0].children if tokens[0:1] and hasattr(tokens[0], "children") else tokens)

    def _lettered(self, kind: Node, tokens: Iterable[Node]) -> None:
        """Letters that stand for lines, planes, hyperplanes, conics or screws."""
        at = self.context
        try:
            step = letter_step(str(kind), at.rank)
        except GcrulesError as fault:
            fault.span = fault.span or span_of(kind)
            raise
        before = set(points_of(*at.bound.values(), *(e for a in at.given for e in (*a.args, *a.also, *a.exists))))
        for token in tokens:
            name = str(token)
            self._declared((), (token,), str(kind))
            alike = (kind == SCREW) == (name in at.screws) and at.letters.get(name) == step
            if alike or (name in at.conics and not step):
                continue
            if name in at.declared() or name in before:
                known = "declared" if name in at.declared() else "a point in what stands before"
                hint = f"choose another name, or declare the {kind} first"
                raise InputError(f"{shortened(name)} is already {known}", span=span_of(token), hint=hint)
            if step:
                screws = (*at.screws, name) if kind == SCREW else at.screws
                at = replace(at, letters={**at.letters, name: step}, screws=screws)
            else:
                at = replace(at, conics=(*at.conics, name))
        self.context = at

    def _letter(self, name: str) -> str:
        """What a letter is called."""
        at = self.context
        return letter_name(name, at.letters[name], at.screws, at.rank)

    def _declared(self, known: tuple[str, ...], tokens: Iterable[Node], kind: str = "point") -> tuple[str, ...]:
        """The names declared so far and those of a new declaration."""
        names = []
        for token in tokens:
            name = str(token)
            if name in self.context.bound:
                raise InputError(f"{shortened(name)} is already bound by `let`", span=span_of(token))
            if not NAME.fullmatch(name):
                raise InputError(f"{shortened(name)!r} cannot name a {kind}", span=span_of(token), hint=NAMES_HINT)
            if name in self.context.letters and kind not in LETTERS:
                what = f"{shortened(name)} is already {self._letter(name)}"
                raise InputError(what, span=span_of(token), hint="choose another name")
            if name in self.context.conics and kind not in LETTERS:
                what = f"{shortened(name)} is already a {FORMS[self.context.rank].word}"
                raise InputError(what, span=span_of(token), hint="choose another name")
            names.append(name)
        return tuple(dict.fromkeys((*known, *names)))

    def _let(self, item: Node) -> None:
        token, body = item.children
        name, at = str(token), self.context
        if name in at.declared():
            raise InputError(f"{shortened(name)} is already declared", span=span_of(token), hint="choose another name")
        if not NAME.fullmatch(name):
            raise InputError(f"{shortened(name)!r} cannot be bound", span=span_of(token), hint=NAMES_HINT)
        builder = Builder(at)
        bound = {**at.bound, name: builder.value(body)}
        required = {**at.required, name: found} if (found := builder.requirements()) else at.required
        polars = {**at.with_polars, name: WithPolars(at).value(body)} if at.conics else at.with_polars
        finite, on_conics = frozenset(builder.finite), frozenset(builder.on_conics)
        self.context = replace(
            at, bound=bound, required=required, finite=finite, on_conics=on_conics, with_polars=polars
        )

    def _claim(self, item: Node) -> None:
        label, body = item.children
        claimed = read_claim(body, Builder(self.context), self._source(body))
        shown = str(label or "").strip('"') or self._source(body)
        self.statements.append(Claim(claimed, shown, self._line(item), self.context))

    def _show(self, item: Node) -> None:
        (body,) = item.children
        shown = Builder(self.context).value(body)
        self.statements.append(Show(shown, self._source(body), self._line(item), self.context))

    def _rewrite(self, item: Node) -> None:
        (body,) = item.children
        e = Builder(self.context).value(body)
        self.statements.append(Rewrite(e, self._source(body), self._line(item), self.context))

    # --- assumptions ---

    def _given(self, item: Node) -> None:
        self.assumed(item)

    def assumed(self, tree: Node) -> Context:
        for part in tree.children:
            try:
                self.assume(part)
            except GcrulesError as fault:
                fault.span = fault.span or span_of(part)
                raise
        return self.context

    def assume(self, tree: Node) -> Context:
        if tree.data == "at_infinity":
            self._check_points(tree)
            self.context = replace(self.context, ideal=self._declared(self.context.ideal, tree.children))
        elif tree.data == "letters":
            self._letters(tree)
        elif tree.data in METRICS:
            self._check_points(tree)
            self._metric(tree.data, tree.children, tree)
        else:
            place = SourcePlace(span_of(tree), self.text, self.filename)
            found = read_assumptions(tree, Builder(self.context), self._source(tree), place)
            self.context = replace(self.context, given=(*self.context.given, *found))
        return self.context

    def _check_points(self, tree: Node) -> None:
        builder = Builder(self.context)
        for token in tree.children:
            if len(builder.split(token)) > 1:
                hint = f"write them apart: {' '.join(n for n, _ in builder.split(token))}"
                raise InputError(f"{shortened(token)} is several points", span=span_of(token), hint=hint)

    # --- rules ---

    def _refuse_letters(self, trees: Iterable[Node]) -> None:
        """Those of screws, conics and quadrics, which are not joins of points."""
        at = self.context
        refused = dict.fromkeys(at.screws, "the screw as a sum of two lines, ab + cd")
        refused |= dict.fromkeys(at.conics, FORMS[at.rank].instead if at.conics else "")
        words = (w for t in trees if hasattr(t, "scan_values") for w in t.scan_values(_is_word)) if refused else ()
        for word in words:
            used = next((n for n, _ in Builder(at).split(word) if n in refused), None)
            if used is not None:
                what = f"a {FORMS[at.rank].word}" if used in at.conics else self._letter(used)
                told = f"{used} is {what}, and rules are about points, lines, planes and hyperplanes"
                raise InputError(told, span=span_of(word), hint=f"write {refused[used]}")

    def _case(self, tree: Node) -> Case:
        return Case(Builder(self.context).value(tree), self._source(tree), span_of(tree))

    def _rule(self, item: Node) -> None:
        token, sentence, left, right, *rest = item.children
        name, at = str(token), self.context
        if name in self.ids:
            fault = f"the rule {name} is already defined in line {self.ids[name]}"
            raise InputError(fault, span=span_of(token), hint="choose another id")
        self._refuse_letters(tree for tree in item.children if tree is not None and tree is not token)
        self.ids[name] = self._line(item)
        parts: dict[str, list[Node]] = {"guards": [], "source": [], "fires": [], "silent": []}
        for tree in filter(None, rest):
            parts[tree.data] += tree.children
        if len(parts["source"]) > 1:
            raise InputError("a rule has one source", span=span_of(parts["source"][1]))
        any_rank = not self.ranked and at.rank == Context().rank
        text = self._source(left, *(parts["guards"] or [right]))
        self.statements.append(
            RuleText(
                id=name,
                sentence=str(sentence or "").strip('"') or text,
                source=str(parts["source"][0]).strip('"') if parts["source"] else "derived here",
                text=text,
                instances=tuple(instances(at, any_rank, left, right, parts["guards"], self._source)),
                fires=tuple(map(self._case, parts["fires"])),
                silent=tuple(map(self._case, parts["silent"])),
                span=span_of(item),
                line=self._line(item),
                context=at,
            )
        )


def _is_word(token: Node) -> bool:
    return getattr(token, "type", "") == "WORD"
