// Terms of the glossary in a sentence.
import { EVERYDAY, GLOSSARY } from "../../protocol";

export type GlossaryTerm = (typeof GLOSSARY)[number];

const NAMES = new Map<string, GlossaryTerm>(
  GLOSSARY.flatMap((entry) => [entry.term, ...entry.forms.split("|").filter(Boolean)].map((name) => [name.toLowerCase(), entry] as const)),
);
const everyday = new Set<string>(EVERYDAY);
const longestFirst = [...NAMES.keys()].filter((name) => !everyday.has(name)).sort((a, b) => b.length - a.length);
const NAMED = new RegExp(`(?<![\\p{L}\\p{N}_-])(${longestFirst.join("|")})(?![\\p{L}\\p{N}_-])`, "iu");

export const entryOf = (name: string): GlossaryTerm | null => NAMES.get(name.toLowerCase()) ?? null;

/** A text in pieces, of which those that name a term have it; each term where it comes first only, `seen` over several texts. */
export function inTerms(text: string, seen: Set<string> = new Set()): { text: string; entry: GlossaryTerm | null }[] {
  return text
    .split(NAMED)
    .filter((piece) => piece !== "")
    .map((piece) => {
      const entry = entryOf(piece);
      const first = entry !== null && !seen.has(entry.term);
      if (first) seen.add(entry.term);
      return { text: piece, entry: first ? entry : null };
    });
}
