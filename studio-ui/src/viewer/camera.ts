// The camera: where it looks from, fitted to the robot, and its way from one view to another.
import { PerspectiveCamera, Vector3 } from "three";
import { planeOf } from "./bsp";
import type { Model, Rod } from "./drawing";
import type { Stand, Vec3, View } from "./types";
import { centre, cross, distance, dot, length, mix, scale, sub, unit } from "./vectors";

const [ELEVATION, ABOVE] = [20, 62]; // degrees: of most robots, and of those that lie flat
const FLAT = 0.02; // how far apart the heights of flat robots are, of the radius
const SIGN = 0.2; // signs of joints are shorter, of the radius
const STRAIGHT = 0.9; // the cosine between strokes that go on from one to the other, as those of arcs do

export function newCamera(): PerspectiveCamera {
  const camera = new PerspectiveCamera(26, 1, 0.01, 100);
  camera.up.set(0, 0, 1);
  return camera;
}

const sum = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** The direction of a standard view, seen from the middle. From the top x goes to the right and y up. */
export function directionOf(view: Exclude<View, "fit">, model: Model): Vec3 {
  if (view === "front") return [0, -1, 0];
  if (view === "side") return [1, 0, 0];
  if (view === "top") return [0, -1e-4, 1];
  return telling(model);
}

/** Among the directions around the robot the one in which joints and ends of rods hide each other least and no plane is
 * seen edge on; from above where it lies flat. */
function telling(model: Model): Vec3 {
  const around = (at: Vec3) => scale(sub(at, model.middle), 1 / model.radius);
  const joints = model.tags.filter((t) => t.look === "joint").map((t) => around(t.at));
  const rods = model.rods.filter((r) => r.solid);
  const places = distinct([...joints, ...endsOf(rods).map(around)]);
  const long = rods.filter((r) => distance(r.a, r.b) > SIGN * model.radius); // no axes of hinges, which stand across
  const heights = [...joints, ...long.flatMap((r) => [r.a, r.b]).map(around)].map((p) => p[2]);
  const elevation = rods.length > 2 && Math.max(...heights) - Math.min(...heights) < FLAT ? ABOVE : ELEVATION;
  const normals = model.faces.flatMap((face) => {
    const n = planeOf(face.corners);
    return n ? [n.normal] : [];
  });
  const legs = rods.map((r) => unit(sub(r.b, r.a)));
  let best: { cost: number; eye: Vec3 } | null = null;
  for (let azimuth = -60; azimuth < 300; azimuth += 10) {
    const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
    const eye: Vec3 = [Math.cos(a) * Math.cos(e), Math.sin(a) * Math.cos(e), Math.sin(e)];
    const right: Vec3 = [-Math.sin(a), Math.cos(a), 0];
    const up = cross(eye, right);
    const flat = places.map((p) => [dot(p, right), dot(p, up)] as const);
    let cost = 0;
    flat.forEach(([x, y], i) =>
      flat.slice(i + 1).forEach(([u, v]) => {
        const apart = Math.hypot(x - u, y - v);
        cost += apart < 0.22 ? 4 * (1 - apart / 0.22) : 0;
      }),
    );
    for (const n of normals) cost += Math.abs(dot(n, eye)) < 0.2 ? 2 * (1 - Math.abs(dot(n, eye)) / 0.2) : 0;
    for (const u of legs) cost += Math.max(0, Math.abs(dot(u, eye)) - 0.7) * 6;
    if (!best || cost < best.cost - 1e-9) best = { cost, eye };
  }
  return best!.eye;
}

/** Ends of rods, but not the places within arcs, where one stroke goes on in the next. */
function endsOf(rods: readonly Rod[]): Vec3[] {
  const ways = new Map<string, { at: Vec3; away: Vec3[] }>();
  for (const { a, b } of rods)
    for (const [at, other] of [[a, b], [b, a]] as const) {
      const found = ways.get(keyOf(at)) ?? { at, away: [] };
      ways.set(keyOf(at), { at, away: [...found.away, unit(sub(other, at))] });
    }
  return [...ways.values()].flatMap(({ at, away }) => (away.length === 2 && dot(away[0]!, away[1]!) < -STRAIGHT ? [] : [at]));
}

const keyOf = (p: Vec3): string => p.map((c) => c.toPrecision(6)).join(" ");

/** Each place once. */
const distinct = (places: readonly Vec3[]): Vec3[] => [...new Map(places.map((p) => [p.map((c) => c.toFixed(3)).join(" "), p])).values()];

export function stand(camera: PerspectiveCamera, target: Vector3, { eye, target: t }: Stand, size: number): void {
  camera.position.set(...eye);
  target.set(...t);
  camera.lookAt(target);
  clip(camera, target, size);
}

/** Near and far planes around what is seen. */
export function clip(camera: PerspectiveCamera, target: Vector3, size: number): void {
  const away = camera.position.distanceTo(target);
  camera.near = Math.max(away - 8 * size, 0.02 * size);
  camera.far = away + 8 * size;
  camera.updateProjectionMatrix();
}

/** A stand on the way from one to another, t from 0 to 1: around the target, not through it. */
export function between(from: Stand, to: Stand, t: number): Stand {
  const ease = t * t * (3 - 2 * t);
  const target = mix(from.target, to.target, ease);
  const [a, b] = [sub(from.eye, from.target), sub(to.eye, to.target)];
  const way = mix(unit(a), unit(b), ease);
  const direction = length(way) > 0.05 ? unit(way) : unit(centre([a, cross(a, [0.3, 0.2, 1])]));
  return { eye: sum(target, scale(direction, length(a) + (length(b) - length(a)) * ease)), target };
}
