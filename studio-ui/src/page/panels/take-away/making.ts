// Makes files, and keeps them as long as structure and pose stay the same.
import type { Saved } from "../../../protocol";
import type { Doc } from "../../state/doc";
import { filmed } from "../../state/filming";
import { stateOf } from "../../state/standing";
import type { Store } from "../../state/store";
import type { Thing } from "./formats";

export interface Made {
  name: string;
  blob: Blob;
  /** null for what is no text. */
  text: string | null;
}

/** What is made of more than that, and so anew each time: what was turned, asked or noted since. */
export const ALWAYS_NEW: readonly Thing[] = ["html", "view-png", "view-svg", "view-way", "view-motion"];

/** What a file depends on. */
export const keyOf = ({ source, pose, threshold }: Doc): string => JSON.stringify([source, pose, threshold]);

export async function make(store: Store, thing: Thing, signal: AbortSignal, tell: (words: string) => void): Promise<Made> {
  if (thing === "view-png" || thing === "view-svg") return viewed(store, thing === "view-png" ? "png" : "svg");
  if (thing === "view-way" || thing === "view-motion") {
    const film = thing === "view-way" ? "way" : "motion";
    const blob = await filmed(store, film, signal, tell);
    return { name: fileName(store.study.peek()?.title, `${film}.webm`), blob, text: null };
  }
  const { source, pose, threshold } = store.doc.peek();
  if (!source) throw new Error("nothing is open");
  const state = thing === "html" ? { state: await stateOf(store) } : {};
  const what = thing === "embedded" ? "html" : thing;
  const saved = await store.client.ask("save", { source, pose, what, threshold, ...state }, { signal, progress: tell });
  return madeOf(saved);
}

/** A file that the server made. */
export function madeOf({ name, mime, data, binary }: Saved): Made {
  return { name, blob: new Blob([binary ? bytesOf(data) : data], { type: mime }), text: binary ? null : data };
}

/** The picture in 3D as it stands. */
export async function viewed(store: Store, kind: "png" | "svg"): Promise<Made> {
  const viewer = store.space.viewer.peek();
  if (!viewer) throw new Error("there is no picture in 3D");
  const picture = await viewer.snapshot(kind);
  const name = fileName(store.study.peek()?.title, `view.${kind}`);
  if (kind === "svg") return { name, blob: new Blob([picture], { type: "image/svg+xml" }), text: picture };
  const blob = new Blob([bytesOf(picture.slice(picture.indexOf(",") + 1))], { type: "image/png" });
  return { name, blob, text: null };
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const binary = atob(base64);
  return Uint8Array.from(binary, (c) => c.charCodeAt(0));
}

/** A name for a file about a robot of this title. */
export function fileName(title: string | undefined, rest: string): string {
  return `${(title ?? "").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "") || "robot"}-${rest}`;
}

export function sizeOf(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  return bytes < 1e6 ? `${(bytes / 1e3).toFixed(bytes < 1e4 ? 1 : 0)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}
