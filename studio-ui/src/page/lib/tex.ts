// KaTeX, each piece rendered once.
import katex from "katex";

const rendered = new Map<string, string>();
const MOST = 5000; // pieces kept

export function texToHtml(tex: string): string {
  const known = rendered.get(tex);
  if (known !== undefined) return known;
  const html = katex.renderToString(tex, { throwOnError: false, output: "html", strict: false });
  if (rendered.size >= MOST) rendered.clear();
  rendered.set(tex, html);
  return html;
}

const WORDS: readonly [RegExp, string][] = [
  [/\\wedge/g, "∧"],
  [/\\vee/g, "∨"],
  [/\\cdot/g, "·"],
  [/\\(?:left|right|,|;|!|quad)/g, ""],
  [/\\mathit|\\mathrm|\\operatorname|\\text/g, ""],
  [/\\lbrack/g, "["],
  [/\\rbrack/g, "]"],
  [/[{}\\_]/g, ""],
];

/** What a screen reader says. */
export const texToText = (tex: string): string => WORDS.reduce((text, [from, to]) => text.replace(from, to), tex).trim();

/** The brackets of a monomial one by one, with what stands before them; null if it is none of so many brackets. */
export function splitBrackets(tex: string, count: number): { before: string; brackets: string[] } | null {
  const brackets = tex.match(/\[[^[\]]*\]/g) ?? [];
  const before = tex.slice(0, tex.indexOf("["));
  return brackets.length === count && before + brackets.join("") === tex ? { before, brackets } : null;
}

/** A leading operator and parentheses of other pieces are set apart: colours and light fall on what stands between. */
export function splitOperator(tex: string): [string, string, string] {
  const found = /^((?:\{\}\s*)?(?:\\wedge|\\vee|\\cdot|[+-])\s*)(.+)$/s.exec(tex);
  const operator = found ? `{}${(found[1] ?? "").replace("{}", "").trim()}{}` : "";
  const rest = found?.[2] ?? tex;
  const [opened, closed] = ["(", ")"].map((mark) => rest.split(mark).length - 1) as [number, number];
  const before = /^\(*/.exec(rest)?.[0].slice(0, Math.max(opened - closed, 0)) ?? "";
  const after = /\)*$/.exec(rest)?.[0].slice(0, Math.max(closed - opened, 0)) ?? "";
  return [operator + before, rest.slice(before.length, rest.length - after.length), after];
}
