// Shapes in space that stand for bodies, planes and lines, as corners of polygons and ends of strokes.
import type { Vec3 } from "./types";
import { add, along, centre, cross, distance, dot, flatNormal, scale, sub, unit } from "./vectors";

type XY = [number, number];

export interface Outline {
  corners: Vec3[];
  /** Whether the edge from a corner to the next is a true one. */
  edges: boolean[];
}

/** The corners of the convex hull, counterclockwise (Andrew's monotone chain). */
export function convexHull(points: readonly XY[]): XY[] {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (run: XY[]): XY[] => {
    const out: XY[] = [];
    for (const p of run) {
      while (out.length > 1 && turn(out[out.length - 2]!, out[out.length - 1]!, p) <= 1e-9) out.pop();
      out.push(p);
    }
    return out.slice(0, -1);
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
}

const turn = (a: XY, b: XY, c: XY): number => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** The outline of all places within a radius of the hull of points that are not all in one line. */
function rounded(points: readonly XY[], radius: number, step: number): XY[] {
  const hull = convexHull(points);
  return hull.flatMap(([x, y], i) => {
    const before = hull[(i + hull.length - 1) % hull.length]!;
    const after = hull[(i + 1) % hull.length]!;
    const first = Math.atan2(y - before[1], x - before[0]) - Math.PI / 2;
    let last = Math.atan2(after[1] - y, after[0] - x) - Math.PI / 2;
    while (last < first - 1e-9) last += 2 * Math.PI;
    const count = Math.max(1, Math.ceil((last - first) / step - 1e-6));
    return Array.from({ length: count + 1 }, (_, k): XY => {
      const a = first + ((last - first) * k) / count;
      return [x + radius * Math.cos(a), y + radius * Math.sin(a)];
    });
  });
}

/** Coordinates in the plane through an origin, and back. */
function chart(origin: Vec3, normal: Vec3, corners: readonly Vec3[]) {
  const far = corners.reduce((a, b) => (distance(b, corners[0]!) > distance(a, corners[0]!) + 1e-9 ? b : a));
  const raw = sub(far, corners[0]!);
  const u = unit(sub(raw, scale(normal, dot(raw, normal))));
  const v = cross(normal, u);
  return {
    flat: (p: Vec3): XY => [dot(sub(p, origin), u), dot(sub(p, origin), v)],
    lift: ([x, y]: XY): Vec3 => add(along(origin, u, x), scale(v, y)),
  };
}

/**
 * A body through its joints as polygons. Joints in one plane give their convex hull, others triangles around their
 * centre; fewer than three, or all in one line, give nothing.
 */
export function body(corners: readonly Vec3[]): Outline[] {
  const normal = flatNormal(corners);
  if (!normal) return [];
  const origin = centre(corners);
  const { flat } = chart(origin, normal, corners);
  const size = Math.max(...corners.map((c) => distance(c, origin)));
  const places = corners.map(flat);
  if (corners.every((c) => Math.abs(dot(sub(c, origin), normal)) <= 0.01 * size)) {
    const hull = convexHull(places).map((p) => corners[places.indexOf(p)]!);
    return [{ corners: hull, edges: hull.map(() => true) }];
  }
  const angle = (i: number) => Math.atan2(places[i]![1], places[i]![0]);
  const ring = corners.map((_, i) => i).sort((i, j) => angle(i) - angle(j));
  return ring.map((i, k) => ({
    corners: [origin, corners[i]!, corners[ring[(k + 1) % ring.length]!]!],
    edges: [false, true, false],
  }));
}

/**
 * A part of the plane of three or more points, reaching beyond them by a margin, with round corners; null for a line.
 * It also covers those of the further points that lie within `slack` of the plane.
 */
export function patch(corners: readonly Vec3[], margin: number, also: readonly Vec3[] = [], slack = margin / 20): Vec3[] | null {
  const normal = flatNormal(corners);
  if (!normal) return null;
  const origin = centre(corners);
  const { flat, lift } = chart(origin, normal, corners);
  const covered = [...corners, ...also.filter((p) => Math.abs(dot(sub(p, origin), normal)) <= slack)];
  return rounded(covered.map(flat), margin, 0.3).map(lift);
}

/** A round part of the plane normal · p = offset around the place that is nearest to a middle. */
export function disc(normal: Vec3, offset: number, middle: Vec3, radius: number): Vec3[] {
  const n = unit(normal);
  const foot = along(middle, n, offset / Math.hypot(...normal) - dot(middle, n));
  const { lift } = chart(foot, n, [foot, add(foot, cross(n, Math.abs(n[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]))]);
  return Array.from({ length: 40 }, (_, k) => {
    const a = (2 * Math.PI * k) / 40;
    return lift([radius * Math.cos(a), radius * Math.sin(a)]);
  });
}

/** A segment made longer at both ends, and up to those of the further points that lie on its line. */
export function stretched(a: Vec3, b: Vec3, extra: number, also: readonly Vec3[] = []): [Vec3, Vec3] {
  const u = unit(sub(b, a));
  const reach = [0, distance(a, b)];
  for (const p of also) {
    const t = dot(sub(p, a), u);
    if (distance(p, along(a, u, t)) <= extra / 20) reach.push(t);
  }
  return [along(a, u, Math.min(...reach) - extra), along(a, u, Math.max(...reach) + extra)];
}

/** The part inside a ball of the line through a point in a direction; null if it misses the ball. */
export function throughBall(at: Vec3, direction: Vec3, middle: Vec3, radius: number): [Vec3, Vec3] | null {
  const u = unit(direction);
  const nearest = along(at, u, dot(sub(middle, at), u));
  const square = radius * radius - distance(nearest, middle) ** 2;
  if (!(square > (0.1 * radius) ** 2)) return null;
  const half = Math.sqrt(square);
  return [along(nearest, u, -half), along(nearest, u, half)];
}

/** Six times the volume of a tetrahedron, over the cube of a length. */
export const volume = ([a, b, c, d]: readonly Vec3[], size: number): number =>
  dot(sub(b!, a!), cross(sub(c!, a!), sub(d!, a!))) / size ** 3;
