// Back-to-front order of polygons and strokes in space, by a tree of half-spaces; what crosses a polygon is split.
// The tree is built once for each pose and walked for each place of the eye: translucent areas that intersect, and
// strokes that pass through them, come out right.
import type { Vec3 } from "./types";
import { cross, dot, mix, sub } from "./vectors";

/** Three or more corners (a plane convex polygon), or two (a stroke). */
export interface Piece<T> {
  corners: Vec3[];
  /** Whether the edge from a corner to the next is one of the original polygon, not a cut. */
  edges: boolean[];
  tag: T;
}

type Plane = { normal: Vec3; offset: number };
type Flat<T> = { piece: Piece<T>; plane: Plane };

export interface Tree<T> {
  plane: Plane | null;
  /** What lies in the plane. */
  polygons: Piece<T>[];
  strokes: Piece<T>[];
  sides: [Tree<T> | null, Tree<T> | null];
}

/** `tolerance` is the distance below which a corner counts as lying in a plane; polygons without area are left out. */
export function tree<T>(pieces: readonly Piece<T>[], tolerance: number): Tree<T> | null {
  const flats = pieces.flatMap((piece): Flat<T>[] => {
    const plane = piece.corners.length > 2 ? planeOf(piece.corners) : null;
    return plane ? [{ piece, plane }] : [];
  });
  return build(flats, pieces.filter((p) => p.corners.length === 2), tolerance);
}

function build<T>(flats: Flat<T>[], strokes: Piece<T>[], tolerance: number): Tree<T> | null {
  if (!flats.length) return strokes.length ? { plane: null, polygons: [], strokes, sides: [null, null] } : null;
  const [{ piece, plane }, ...rest] = flats as [Flat<T>, ...Flat<T>[]];
  const inside: Piece<T>[] = [piece];
  const flatSides: [Flat<T>[], Flat<T>[]] = [[], []];
  const strokeSides: [Piece<T>[], Piece<T>[]] = [[], []];
  const within: Piece<T>[] = [];
  for (const one of rest)
    for (const [side, part] of split(one.piece, plane, tolerance))
      if (side === 0) inside.push(part);
      else flatSides[side > 0 ? 0 : 1].push({ piece: part, plane: one.plane });
  for (const one of strokes)
    for (const [side, part] of split(one, plane, tolerance))
      if (side === 0) within.push(part);
      else strokeSides[side > 0 ? 0 : 1].push(part);
  const side = (i: 0 | 1) => build(flatSides[i], strokeSides[i], tolerance);
  return { plane, polygons: inside, strokes: within, sides: [side(0), side(1)] };
}

/** The pieces in the order in which to draw them, seen from the place of the eye. */
export function painted<T>(root: Tree<T> | null, eye: Vec3): Piece<T>[] {
  const out: Piece<T>[] = [];
  const farthestFirst = (strokes: readonly Piece<T>[]) => {
    const depth = (p: Piece<T>) => {
      const away = sub(mix(p.corners[0]!, p.corners[1]!, 0.5), eye);
      return dot(away, away);
    };
    out.push(...[...strokes].sort((p, q) => depth(q) - depth(p)));
  };
  const walk = (node: Tree<T> | null): void => {
    if (!node) return;
    if (!node.plane) return farthestFirst(node.strokes);
    const near = dot(node.plane.normal, eye) > node.plane.offset ? 0 : 1;
    walk(node.sides[1 - near]!);
    out.push(...node.polygons);
    farthestFirst(node.strokes);
    walk(node.sides[near]!);
  };
  walk(root);
  return out;
}

/** Unit normal (Newell's sum over all corners) and offset; null for corners on one line. */
export function planeOf(corners: readonly Vec3[]): Plane | null {
  const first = corners[0]!;
  const sum: Vec3 = [0, 0, 0];
  let size = 0;
  corners.forEach((a, i) => {
    const n = cross(sub(a, first), sub(corners[(i + 1) % corners.length]!, first));
    for (const k of [0, 1, 2] as const) {
      sum[k] += n[k];
      size = Math.max(size, Math.abs(a[k] - first[k]));
    }
  });
  const long = Math.hypot(...sum);
  if (long <= 1e-9 * size * size) return null;
  const normal: Vec3 = [sum[0] / long, sum[1] / long, sum[2] / long];
  return { normal, offset: corners.reduce((total, c) => total + dot(normal, c), 0) / corners.length };
}

function split<T>(piece: Piece<T>, plane: Plane, tolerance: number): [number, Piece<T>][] {
  const heights = piece.corners.map((c) => {
    const h = dot(plane.normal, c) - plane.offset;
    return Math.abs(h) <= tolerance ? 0 : h;
  });
  if (!heights.some((h) => h)) return [[0, piece]];
  const found: [number, Piece<T>][] = [];
  for (const side of [1, -1]) {
    if (!heights.some((h) => side * h > 0)) continue;
    if (heights.every((h) => side * h >= 0)) return [[side, piece]];
    const part = half(piece, heights.map((h) => side * h));
    if (part.corners.length >= Math.min(piece.corners.length, 3)) found.push([side, part]);
  }
  return found;
}

/** The part of a piece where the height is not negative. */
function half<T>(piece: Piece<T>, heights: readonly number[]): Piece<T> {
  const corners: Vec3[] = [];
  const edges: boolean[] = [];
  const count = piece.corners.length;
  const closed = count > 2;
  for (let i = 0; i < count; i++) {
    const j = (i + 1) % count;
    const [hi, hj] = [heights[i]!, heights[j]!];
    const original = closed ? piece.edges[i]! : true;
    if (hi >= 0) {
      corners.push(piece.corners[i]!);
      edges.push(original && (hi > 0 || hj >= 0));
    }
    if (hi * hj < 0 && (closed || i === 0)) {
      corners.push(mix(piece.corners[i]!, piece.corners[j]!, hi / (hi - hj)));
      edges.push(hi < 0 && original);
    }
  }
  return { corners, edges, tag: piece.tag };
}
