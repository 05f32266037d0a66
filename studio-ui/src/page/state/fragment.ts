// The document in the fragment of the address: base64url of JSON, deflated where that is shorter. Only what differs from
// the empty document is written, so that the link of a class is short. The fragment never leaves the browser.
import { LONGEST_LINK } from "../../protocol";
import { EMPTY, HOME, samePose, type Doc } from "./doc";
import { readDoc } from "./read";
import { isReload } from "./tab-memory";

const LONGEST = 4_000_000; // bytes of JSON that a link may hold: a file of the largest size, each letter escaped, fits well
const LARGE = 240; // characters of JSON above which deflating pays

export interface Link {
  fragment: string;
  /** The waypoints are left out, since with them the link would be too long. */
  short: boolean;
}

/** The fragment, without the waypoints where these make it too long. */
export async function linkOf(doc: Doc): Promise<Link> {
  const fragment = await deflatedFragment(doc);
  if (fragment.length <= LONGEST_LINK || (doc.way.length === 0 && doc.driven.length === 0)) return { fragment, short: false };
  return { fragment: await deflatedFragment({ ...doc, way: [], driven: [] }), short: true };
}

async function deflatedFragment(doc: Doc): Promise<string> {
  const json = compact(doc);
  if (json === "{}") return "";
  if (json.length < LARGE || typeof CompressionStream === "undefined") return plainFragment(doc);
  const deflated = await piped(new TextEncoder().encode(json), new CompressionStream("deflate-raw"));
  return `#z=${toBase64(deflated)}`;
}

/** The same without deflating: at once, for when the page goes away. */
export function plainFragment(doc: Doc): string {
  const json = compact(doc);
  return json === "{}" ? "" : `#s=${toBase64(new TextEncoder().encode(json))}`;
}

/** The document of a fragment, the empty one if there is none; null if it cannot be read. */
export async function readFragment(fragment: string): Promise<Doc | null> {
  if (fragment.length < 2) return EMPTY;
  const found = /^#([sz])=([\w-]+)$/.exec(fragment);
  if (!found) return null;
  try {
    const bytes = fromBase64(found[2] ?? "");
    const plain = found[1] === "z" ? await piped(bytes, new DecompressionStream("deflate-raw"), LONGEST) : bytes;
    const told: unknown = JSON.parse(new TextDecoder().decode(plain));
    const doc = readDoc(told);
    const named = typeof told === "object" && told !== null && "source" in told && told.source !== null;
    return named && doc.source === null ? null : doc; // what it opens cannot be told
  } catch {
    return null;
  }
}

const LEFT = "gcrules-studio-left";

/** Keeps a fragment for the reload of this tab. */
export function leave(fragment: string): void {
  try {
    sessionStorage.setItem(LEFT, fragment || "#");
  } catch {
    // storage may be forbidden: the last third of a second before a reload is then lost
  }
}

/** The fragment that this tab left behind when it was reloaded, else that of the address. */
export function arriving(): string {
  try {
    const left = sessionStorage.getItem(LEFT);
    sessionStorage.removeItem(LEFT);
    if (left !== null && isReload()) return left;
  } catch {
    // see leave
  }
  return location.hash;
}

/** Of two ways the one that is on show. */
const compact = (doc: Doc): string => JSON.stringify(changedFields(doc.way.length > 0 ? { ...doc, driven: [] } : doc));

/** What differs from the empty document. */
export function changedFields(doc: Doc): Partial<Doc> {
  const changed = Object.entries(doc).filter(([key, value]) => {
    if (key === "pose") return !samePose(doc.pose, HOME);
    return JSON.stringify(value) !== JSON.stringify(EMPTY[key as keyof Doc]);
  });
  return Object.fromEntries(changed);
}

/** What comes out of a stream; refused as soon as it is longer than it may be. */
async function piped(
  bytes: Uint8Array<ArrayBuffer>,
  through: GenericTransformStream,
  longest = Infinity,
): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(through as ReadableWritablePair<Uint8Array, Uint8Array<ArrayBuffer>>);
  const reader = (stream as ReadableStream<Uint8Array<ArrayBuffer>>).getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  for (let size = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > longest) {
      await reader.cancel();
      throw new RangeError("too long");
    }
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

function toBase64(bytes: Uint8Array): string {
  const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}
