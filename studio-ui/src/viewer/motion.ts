// The motion that the platform gains in a singular pose: an arrow about its axis, and the platform carried along it.
import type { Drawing } from "./drawing";
import { turnAbout, turned } from "./pose";
import { throughBall } from "./solids";
import type { Scene, Vec3 } from "./types";
import { across, add, along, cross, dot, length, scale, sub, unit } from "./vectors";

export type Motion = NonNullable<Scene["motion"]>;

const REACH = 0.2; // how far the platform swings, as a share of the size
const WIDEST = 0.45; // radians

/** The points, those of the platform carried along the motion; s from −1 to 1. */
export function swung(scene: Scene, motion: Motion, s: number): Record<string, Vec3> {
  const axis = unit(motion.axis);
  const points = { ...scene.points };
  const joints = scene.platform.filter((n) => points[n]);
  const pitch = motion.pitch;
  if (pitch === null) {
    for (const n of joints) points[n] = along(points[n]!, axis, s * REACH * scene.size);
    return points;
  }
  const speeds = joints.map((n) => length(add(cross(axis, sub(points[n]!, motion.through)), scale(axis, pitch))));
  const angle = s * Math.min(WIDEST, (REACH * scene.size) / (Math.max(...speeds) || 1));
  const turn = turnAbout(axis, angle);
  for (const n of joints)
    points[n] = along(add(motion.through, turned(sub(points[n]!, motion.through), turn)), axis, angle * pitch);
  return points;
}

/** The axis, and around it a curved arrow; a straight one for a shift. */
export function drawnMotion(d: Drawing, motion: Motion): void {
  const { scene } = d;
  const colour = d.colour("mark");
  const axis = unit(motion.axis);
  const ends = throughBall(motion.through, axis, d.middle, 1.1 * d.radius);
  if (motion.pitch === null) {
    d.arrow(motion.through, along(motion.through, axis, 0.6 * scene.size), colour, 1.2);
    return;
  }
  if (!ends) return;
  d.dashes(ends[0], ends[1], colour);
  const platform = scene.platform.flatMap((n) => (scene.points[n] ? [scene.points[n]] : []));
  const heights = platform.map((p) => dot(sub(p, motion.through), axis));
  const place = along(motion.through, axis, heights.length ? Math.max(...heights) + 0.12 * scene.size : 0);
  curvedArrow(d, place, axis, 0.16 * scene.size, colour);
  if (motion.pitch) d.arrow(place, along(place, axis, Math.sign(motion.pitch) * 0.3 * scene.size), colour);
}

/** Three quarters of a circle about an axis with a head, turning counterclockwise. */
export function curvedArrow(d: Drawing, at: Vec3, axis: Vec3, radius: number, colour: string): void {
  const [u, v] = across(axis);
  const place = (angle: number) => add(along(at, u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle)));
  const steps = 18;
  const last = 1.5 * Math.PI;
  for (let k = 0; k < steps; k++) d.line(place((last * k) / steps), place((last * (k + 1)) / steps), colour, { radius: 0.006 * d.scene.size });
  const end = place(last);
  const forward = unit(cross(axis, sub(end, at)));
  d.cones.push({ base: end, tip: along(end, forward, 0.07 * d.scene.size), radius: 0.022 * d.scene.size, colour });
}
