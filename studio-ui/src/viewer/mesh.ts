// A curved surface of many triangles: translucent, shaded, and painted farthest first.
import type { Drawing } from "./drawing";
import { blend } from "./palette";
import type { TriangleMesh, Vec3 } from "./types";
import { centre, cross, distance, dot, sub, unit } from "./vectors";

/** A mesh in the colours of a theme. */
export interface Veil {
  corners: readonly Vec3[];
  triangles: readonly (readonly [number, number, number])[];
  middles: readonly Vec3[];
  /** Of each corner. */
  colours: readonly string[];
  /** What colours turn to where the surface is seen edge on. */
  shade: string;
  fill: number;
}

const FILL = { current: 0.3, stale: 0.16 };
const known = new WeakMap<TriangleMesh, Pick<Veil, "corners" | "triangles" | "middles">>();

/** Corners and triangles are the same while the mesh is: it outlives many drawings. */
function partsOf(mesh: TriangleMesh): Pick<Veil, "corners" | "triangles" | "middles"> {
  const found = known.get(mesh);
  if (found) return found;
  const threes = <T,>(list: readonly T[]) => Array.from({ length: Math.floor(list.length / 3) }, (_, i) => list.slice(3 * i, 3 * i + 3));
  const corners = threes(mesh.vertices) as Vec3[];
  const triangles = threes(mesh.faces) as [number, number, number][];
  const parts = { corners, triangles, middles: triangles.map((t) => centre(t.map((k) => corners[k]!))) };
  known.set(mesh, parts);
  return parts;
}

export function drawnMesh(d: Drawing, mesh: TriangleMesh): void {
  const [full, pale] = [d.colour(mesh.stale ? "muted" : "mark"), d.colour("muted")];
  const colours = mesh.reached.map((reached) => (reached ? full : pale));
  d.veil = { ...partsOf(mesh), colours, shade: d.colour("ink"), fill: mesh.stale ? FILL.stale : FILL.current };
}

/** The numbers of the triangles, farthest first. */
export function farthestFirst({ middles }: Pick<Veil, "middles">, eye: Vec3): number[] {
  const away = middles.map((m) => distance(m, eye));
  return away.map((_, i) => i).sort((i, j) => away[j]! - away[i]!);
}

/** The colour of a triangle as it is seen: the deeper, the more it is turned away from the eye. */
export function shaded({ corners, triangles, middles, colours, shade }: Veil, i: number, eye: Vec3): string {
  const [a, b, c] = triangles[i]!;
  const normal = unit(cross(sub(corners[b]!, corners[a]!), sub(corners[c]!, corners[a]!)));
  const edgewise = 1 - Math.abs(dot(normal, unit(sub(eye, middles[i]!))));
  return blend(colours[a]!, shade, 0.2 * edgewise);
}
