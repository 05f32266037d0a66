// What a button asks of the statement under the cursor: a line of the language, put below it.
import type { EditorView } from "@codemirror/view";
import type { BenchResult } from "../../../protocol";

export interface Operation {
  id: string;
  title: string;
  words: string;
  /** The line that asks, for what stands under the cursor; null where it does not fit. */
  line(asked: Asked): string | null;
}

export interface Asked {
  /** An expression, or the left side of an equation; "" where there is none. */
  expression: string;
  equation: string;
  /** Legs of a superbracket, "Aa Bb Cc Dd Ee Ff". */
  legs: string;
}

const ask =
  (command: string) =>
  ({ expression }: Asked): string | null =>
    expression === "" ? null : `:${command} ${expression}`;

export const OPERATIONS: readonly Operation[] = [
  { id: "expand", title: "Expand", words: "Into brackets", line: ask("expand") },
  { id: "straighten", title: "Straighten", words: "The normal form of standard tableaux", line: ask("straighten") },
  { id: "steps", title: "Every step", words: "Straighten, each syzygy shown", line: ask("steps") },
  { id: "factor", title: "Factor", words: "One expression of joins and meets that equals it", line: ask("factor") },
  { id: "shorten", title: "Shorten", words: "The fewest terms", line: ask("shorten") },
  { id: "rewrite", title: "Rewrite", words: "By the rules of this text", line: ({ expression }) => (expression === "" ? null : `rewrite ${expression}`) },
  { id: "prove", title: "Prove", words: "Decide the equation, or write its other side", line: ({ expression, equation }) => (equation !== "" ? `:prove ${equation}` : expression === "" ? null : `${expression} == `) },
  { id: "discover", title: "Discover", words: "What holds of the points so far, and is not trivial, proved", line: () => ":discover" },
  { id: "transversals", title: "Transversals", words: "Compare the turns about two lines that meet four legs", line: ({ legs }) => (legs === "" ? null : `:transversals ${legs}`) },
  { id: "analyze", title: "Analyze", words: "When and why a robot on these six legs is singular", line: ({ legs }) => (legs === "" ? null : `:analyze ${legs}`) },
  { id: "latex", title: "LaTeX", words: "As it stands, for a paper", line: ask("latex") },
];

/** Statements that declare: written at the top, with what is to be changed selected. */
export const DECLARATIONS: readonly { id: string; title: string; text: string; select: string }[] = [
  { id: "rank", title: "another rank: the plane is rank 3", text: "rank 3", select: "3" },
  { id: "points", title: "points with long names", text: "points left right", select: "left right" },
  { id: "ideal", title: "points at infinity", text: "ideal i j k", select: "i j k" },
  { id: "given", title: "what is assumed", text: "given collinear(a, b, c)", select: "collinear(a, b, c)" },
  { id: "rule", title: "a rule of your own, which is proved first", text: 'rule swap "two points change places": [R... a b] => -[R... b a] if b < a', select: "swap" },
];

const DECLARES = /^\s*(rank|points|ideal|given|let|rule)\b/;
const COMMENT = /^\s*#/;

/** A statement without its comments, its label and its key word. */
export function askedOf(statement: string, legs: string): Asked {
  const none = { expression: "", equation: "", legs };
  const plain = statement
    .split("\n")
    .filter((line) => !COMMENT.test(line))
    .join(" ")
    .replace(/\s+/g, " ")
    .trim();
  const bound = /^let\s+(\S+)\s*=/.exec(plain);
  if (bound) return { ...none, expression: bound[1] ?? "" };
  if (/^(rank|points|ideal|given|rule)\b/.test(plain)) return none;
  const body = plain.replace(/^:[a-z]*\s*/, "").replace(/^(show|rewrite)\s+/, "").replace(/^claim\s+("[^"]*"\s*:)?\s*/, "");
  const [left = "", right] = body.split("==").map((side) => side.trim());
  const lines = /^\[\[([^[\]]*)\]\]$/.exec(left)?.[1];
  const own = lines && /^[\w', ]+$/.test(lines) ? lines.split(",").map((leg) => leg.trim()).join(" ") : legs;
  return { expression: left, equation: right === undefined ? "" : body, legs: own };
}

/** Where the statement under the cursor is; what is selected counts as one. */
function placeOf(view: EditorView, results: readonly BenchResult[]): { from: number; to: number } {
  const { main } = view.state.selection;
  const line = view.state.doc.lineAt(main.head);
  if (!main.empty && !DECLARES.test(line.text)) return { from: main.from, to: main.to };
  const found = results.find(({ start, end }) => start <= line.to && end >= line.from && end <= view.state.doc.length);
  return found ? { from: found.start, to: found.end } : { from: line.from, to: line.to };
}

export function askedAt(view: EditorView, results: readonly BenchResult[], legs: string): Asked {
  const { from, to } = placeOf(view, results);
  return askedOf(view.state.sliceDoc(from, to), legs);
}

/** Puts the question below the statement, and the cursor behind it. */
export function put(view: EditorView, results: readonly BenchResult[], line: string): void {
  const end = view.state.doc.lineAt(Math.min(placeOf(view, results).to, view.state.doc.length)).to;
  view.dispatch({ changes: { from: end, insert: `\n${line}` }, selection: { anchor: end + 1 + line.length }, scrollIntoView: true });
  view.focus();
}

/** Puts a declaration behind those at the top; the rank stands first. */
export function declare(view: EditorView, { id, text, select }: (typeof DECLARATIONS)[number]): void {
  declareText(view, text, id === "rank", select);
}

/** Puts a text there, and the cursor on what is to be changed of it. */
export function declareText(view: EditorView, text: string, first = false, select = text): void {
  const { doc } = view.state;
  let at = 0;
  for (let n = 1; n <= doc.lines; n += 1) {
    const line = doc.line(n);
    const declares = DECLARES.test(line.text);
    if (first && declares) break;
    if (declares) at = line.to + 1;
    else if (COMMENT.test(line.text) && at === line.from && n < doc.lines) at = line.to + 1;
    else if (line.text.trim() !== "" && !COMMENT.test(line.text)) break;
  }
  const last = at > doc.length;
  const from = Math.min(at, doc.length);
  const begin = from + (last ? 1 : 0) + text.indexOf(select);
  view.dispatch({ changes: { from, insert: last ? `\n${text}` : `${text}\n` }, selection: { anchor: begin, head: begin + select.length }, scrollIntoView: true });
  view.focus();
}
