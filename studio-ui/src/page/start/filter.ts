// Which cards are shown, and under which headings.
import type { Gallery, GalleryItem } from "../../protocol";

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

/** The cards that hold every word of the query, grouped in the order in which the groups come. */
export function chosen(gallery: Gallery, section: Section, query: string): Group[] {
  const wanted = query.toLowerCase().split(/\s+/).filter(Boolean);
  const kinds = section === "all" ? (["examples", "robots", "classes"] as const) : [section];
  const found = kinds.flatMap((kind) => gallery[kind]).filter((item) => wanted.every((word) => textOf(item).includes(word)));
  const groups = new Map<string, GalleryItem[]>();
  for (const item of found) groups.set(item.group, [...(groups.get(item.group) ?? []), item]);
  return [...groups].map(([title, items]) => ({ title, items }));
}

const textOf = ({ id, title, detail, group, statement }: GalleryItem): string =>
  [id, title, detail, group, statement].join(" ").toLowerCase();
