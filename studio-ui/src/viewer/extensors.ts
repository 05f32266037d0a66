// Joins and meets of points of projective space, up to a factor: what is constructed from the joints, in any pose.
//
// An extensor is sixteen numbers, one for each subset of the four coordinates (x, y, z, w), the subset a bit mask.
import { singular } from "./linear";
import type { Construction, Vec3 } from "./types";
import { along, cross, dot, length, scale, sub } from "./vectors";

export type Extensor = number[];

const bits = (mask: number): number => [1, 2, 4, 8].filter((b) => mask & b).length;

/** The sign of the shuffle that sorts the elements of two disjoint subsets. */
function shuffle(a: number, b: number): number {
  let swaps = 0;
  for (let rest = a >> 1; rest; rest >>= 1) swaps += bits(rest & b);
  return swaps % 2 ? -1 : 1;
}

export function join(a: Extensor, b: Extensor): Extensor {
  const out = new Array<number>(16).fill(0);
  for (let i = 0; i < 16; i++)
    for (let j = 0; j < 16; j++) if (a[i] && b[j] && !(i & j)) out[i | j]! += shuffle(i, j) * a[i]! * b[j]!;
  return out;
}

const dual = (a: Extensor): Extensor => a.map((_, i) => shuffle(15 ^ i, i) * a[15 ^ i]!);

/** By duality; the sign is not that of the language, which does not matter for what is drawn. */
export const meet = (a: Extensor, b: Extensor): Extensor => dual(join(dual(a), dual(b)));

export function point([x, y, z]: Vec3): Extensor {
  const out = new Array<number>(16).fill(0);
  [out[1], out[2], out[4], out[8]] = [x, y, z, 1];
  return out;
}

export function constructed(what: Construction, points: Record<string, Vec3>): Extensor {
  if (typeof what === "string") {
    const at = points[what];
    if (!at) throw new Error(`no point ${what}`);
    return point(at);
  }
  const [kind, ...parts] = what; // "join" or "meet"
  return parts.map((part) => constructed(part, points)).reduce(kind === "join" ? join : meet);
}

/** A point of a line, the one nearest to a middle, and its unit direction; null for a line at infinity or none. */
export function lineOf(a: Extensor, middle: Vec3): { at: Vec3; direction: Vec3 } | null {
  const [p12, p13, p14, p23, p24, p34] = [a[3]!, a[5]!, a[9]!, a[6]!, a[10]!, a[12]!];
  const d: Vec3 = [-p14, -p24, -p34];
  const size = length(d);
  if (!(size > 1e-12 * Math.max(...[p12, p13, p23].map(Math.abs), size))) return null;
  const direction = scale(d, 1 / size);
  const foot = cross(direction, scale([p23, -p13, p12], 1 / size));
  return { at: along(foot, direction, dot(sub(middle, foot), direction)), direction };
}

/** The linear equations of the points of an extensor: their join with it is zero. */
function equations(a: Extensor): number[][] {
  const columns = [1, 2, 4, 8].map((bit) => join(a.map((_, i) => (i === bit ? 1 : 0)), a));
  return Array.from({ length: 16 }, (_, mask) => columns.map((c) => c[mask]!)).filter((row) => row.some((c) => c));
}

/** In sizes of the robot: how far a point is told in which all meet, and one near which they pass; as in `Scenery`. */
const [FARTHEST, SEEN] = [100, 3];

/** The finite point nearest to all extensors and how far off they are; coordinates of about 1 are expected. Below `met`
 * singular values count as 0. */
export function common(parts: readonly Extensor[], met: number): { at: Vec3; miss: number } | null {
  const rows = parts.flatMap(equations).map((row) => row.map((c) => c / (Math.hypot(...row) || 1)));
  if (rows.length < 4) return null;
  const { values, vectors } = singular(rows);
  const [x, y, z, w] = vectors[3] as [number, number, number, number];
  const reach = values[3]! <= met * Math.abs(w) ? FARTHEST : SEEN;
  if (values[2]! < met || Math.abs(w) * reach < Math.max(Math.abs(x), Math.abs(y), Math.abs(z))) return null;
  return { at: [x / w, y / w, z / w], miss: values[3]! / Math.abs(w) };
}
