// Colours for the language of expressions, by the words and signs of gcrules/grammar.lark.
import { HighlightStyle, StreamLanguage, syntaxHighlighting, type StringStream } from "@codemirror/language";
import { tags } from "@lezer/highlight";
import { BENCH_CONSTRUCTIONS, BENCH_RELATIONS } from "../../../protocol";

const STATEMENTS = new Set(["rank", "points", "ideal", "isotropic", "orthonormal", "line", "plane", "hyperplane", "conic", "quadric", "screw", "let", "claim", "show", "given", "rewrite", "rule"]);
const CLAUSES = new Set<string>(["if", "source", "fires", "silent", ...BENCH_RELATIONS]);
const CONSTRUCTIONS = new Set<string>(BENCH_CONSTRUCTIONS);
const WORD = /^[A-Za-zȦȧḂḃĊċḊḋĖėḞḟĠġḢḣİṀṁṄṅȮȯṖṗṘṙṠṡṪṫẆẇẊẋẎẏŻż][\w'\u0307ȦȧḂḃĊċḊḋĖėḞḟĠġḢḣİṀṁṄṅȮȯṖṗṘṙṠṡṪṫẆẇẊẋẎẏŻż]*(\.\.\.|…)?/;
const SIGNS: readonly [RegExp, string][] = [
  [/^#.*/, "comment"],
  [/^"[^"\n]*"?/, "string"],
  [/^(==|=>|=)/, "definitionOperator"],
  [/^(\*\*|\/\\|\\\/|∧|∨|\^|\\wedge|\\vee|\\cdot|\\times|[*·×+−-]|!=|<)/, "operator"],
  [/^[0-9]+(\/[0-9]+)?/, "number"],
  [/^(\[\[|\]\]|[[\]()])/, "bracket"],
  [/^[,:]/, "punctuation"],
];

interface Reading {
  /** Names bound by let, so far. */
  bound: string[];
  /** The word before was `let`. */
  naming: boolean;
}

function token(stream: StringStream, state: Reading): string | null {
  if (stream.eatSpace()) return null;
  for (const [sign, name] of SIGNS) if (stream.match(sign)) return name;
  const found = stream.match(WORD);
  if (!found || found === true) {
    stream.next();
    return stream.current() === "." ? "operator" : "invalid";
  }
  const [word] = found;
  if (state.naming) {
    state.naming = false;
    state.bound.push(word);
    return "definition";
  }
  if (STATEMENTS.has(word)) {
    state.naming = word === "let";
    return "keyword";
  }
  if (CLAUSES.has(word) || (CONSTRUCTIONS.has(word) && stream.peek() === "(")) return "keyword";
  return state.bound.includes(word) ? "bound" : "points";
}

const language = StreamLanguage.define<Reading>({
  name: "gca",
  startState: () => ({ bound: [], naming: false }),
  copyState: ({ bound, naming }) => ({ bound: [...bound], naming }),
  token,
  languageData: { commentTokens: { line: "#" }, closeBrackets: { brackets: ["(", "[", '"'] } },
  tokenTable: {
    definition: tags.definition(tags.variableName),
    bound: tags.special(tags.variableName),
    points: tags.variableName,
  },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--muted)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--entity3-text)" },
  { tag: tags.keyword, color: "var(--entity4-text)", fontWeight: "600" },
  { tag: tags.definition(tags.variableName), color: "var(--accent)", fontWeight: "600" },
  { tag: tags.special(tags.variableName), color: "var(--accent)" },
  { tag: [tags.operator, tags.definitionOperator], color: "var(--entity2-text)" },
  { tag: tags.number, color: "var(--entity5-text)" },
  { tag: [tags.bracket, tags.punctuation], color: "var(--muted)" },
  { tag: tags.invalid, color: "var(--singular)" },
]);

export const gca = [language, syntaxHighlighting(colours)];
