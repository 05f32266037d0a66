// Which cards are shown, and under which headings.
import type { Gallery, GalleryItem } from "../../protocol";
import { folded, holds, wordsOf } from "../lib/finding";

export type Section = "all" | "classes" | "robots" | "examples";

export const SECTIONS: readonly { id: Section; title: string }[] = [
  { id: "all", title: "All" },
  { id: "classes", title: "Classes" },
  { id: "robots", title: "Robots" },
  { id: "examples", title: "Examples" },
];

export interface Group {
  title: string;
  items: GalleryItem[];
}

/** The cards that hold every word of the query, those whose name holds them first, grouped in the order in which the groups come; those that a newcomer knows stand first, under a heading of their own before anything is asked. */
export function chosen(gallery: Gallery, section: Section, query: string): Group[] {
  const wanted = wordsOf(freedomsJoined(query));
  const kinds = section === "all" ? (["examples", "robots", "classes"] as const) : [section];
  const items = kinds.flatMap((kind) => gallery[kind]).filter((item) => wanted.every((word) => holds(textOf(item), word)));
  const ranks = new Map(items.map((item) => [item, rankOf(item, wanted)]));
  items.sort((a, b) => ranks.get(a)! - ranks.get(b)! || (a.familiar ?? Infinity) - (b.familiar ?? Infinity) || 0);
  const first = section === "all" && !wanted.length ? items.filter((item) => item.familiar !== null) : [];
  const groups = new Map<string, GalleryItem[]>(first.length ? [[FAMILIAR, first]] : []);
  for (const item of items) {
    if (!first.includes(item)) groups.set(item.group, [...(groups.get(item.group) ?? []), item]);
  }
  return [...groups].map(([title, items]) => ({ title, items }));
}

/** How well the name matches: 0 if it holds every word, 1 if what the card is called beside it begins with one, 2 else. */
function rankOf({ id, title, words }: GalleryItem, wanted: readonly string[]): number {
  const name = folded(`${id} ${title}`);
  if (wanted.every((word) => holds(name, word))) return 0;
  return wanted.some((word) => folded(words).startsWith(word)) ? 1 : 2;
}

const FAMILIAR = "Well known";

const COUNTS = ["one", "two", "three", "four", "five", "six"];
const FREEDOMS = new RegExp(`\\b(\\d|${COUNTS.join("|")})[\\s-]*(?:dofs?\\b|freedoms?\\b|degrees?[\\s-]+of[\\s-]+freedom)`, "gi");

/** A count of freedoms as one word, however it is written: "4-dof", which the robots that have so many are called. */
const freedomsJoined = (query: string): string =>
  query.replace(FREEDOMS, (_, count: string) => `${COUNTS.indexOf(count.toLowerCase()) + 1 || count}-dof`);

const textOf = ({ id, title, detail, group, statement, words }: GalleryItem): string =>
  folded([id, title, detail, group, statement, words].join(" "));
