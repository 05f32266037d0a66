// Undo and redo over a reload: the newest steps, each as what differs from an empty document, sources told once.
import type { Source } from "../../protocol";
import type { Doc } from "./doc";
import { changedFields } from "./fragment";
import { begin, type History } from "./history";
import { readDoc } from "./read";

const MOST = 60; // steps each way

interface Kept {
  sources: (Source | null)[];
  past: [number, Partial<Doc>][];
  present: [number, Partial<Doc>];
  future: [number, Partial<Doc>][];
}

export function writeHistory({ past, present, future }: History): string {
  const sources: (Source | null)[] = [];
  const known = new Map<string, number>();
  const short = (doc: Doc): [number, Partial<Doc>] => {
    const key = JSON.stringify(doc.source);
    if (!known.has(key)) known.set(key, sources.push(doc.source) - 1);
    const { source: _, driven: __, ...rest } = changedFields(doc); // the way that was driven is in the address
    return [known.get(key) ?? 0, rest];
  };
  const kept: Kept = {
    past: past.slice(-MOST).map(short),
    present: short(present),
    future: future.slice(0, MOST).map(short),
    sources,
  };
  return JSON.stringify(kept);
}

/** The history that ends at this document; one that begins there, where the text is of another. */
export function readHistory(text: string | null, start: Doc): History {
  if (text === null) return begin(start);
  try {
    const { sources, past, present, future } = JSON.parse(text) as Kept;
    const long = ([source, rest]: [number, Partial<Doc>]): Doc => readDoc({ ...rest, source: sources[source] });
    if (JSON.stringify(changedFields(long(present))) !== JSON.stringify(changedFields({ ...start, driven: [] }))) return begin(start);
    return { past: past.map(long), present: start, future: future.map(long), open: null };
  } catch {
    return begin(start);
  }
}
