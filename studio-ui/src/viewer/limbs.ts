// Limbs: links, joints by their kind, and wrenches: forces as arrows, couples as curved arrows.
import { SIZES, type Drawing } from "./drawing";
import { curvedArrow } from "./motion";
import type { Joint, Limb, Line } from "../protocol";
import type { Vec3 } from "./types";
import { add, along, distance, mix, scale, unit } from "./vectors";


export function drawnLimbs(d: Drawing): void {
  for (const [a, b] of d.scene.bars ?? [])
    if (distance(a, b) > 1e-6 * d.scene.size) {
      d.rods.push({ a, b, radius: 0.7 * SIZES.leg * d.scene.size, colour: d.colour("leg"), solid: true });
      for (const end of [a, b]) d.ball(end, 0.7 * SIZES.joint * d.scene.size, d.colour("paper"), d.colour("ink"), 1.3);
    }
  skeleton(d);
  for (const limb of d.scene.limbs ?? []) {
    const colour = d.entityColour(limb.colour);
    if (!d.scene.skeleton) {
      links(d, limb);
      limb.joints.forEach((joint, i) => jointShape(d, joint, placeOf(limb.joints, i)));
    }
    for (const line of limb.lines) wrench(d, limb, line, colour);
  }
}

const WIDTHS: Record<string, number> = { link: 1, bar: 0.7, rail: 0.5, axis: 0.3 };

/** Links, rods, rails and arcs as on paper, and the joints where their signs stand there. */
function skeleton(d: Drawing): void {
  const { skeleton: found, size } = d.scene;
  for (const { ends, look } of found?.strokes ?? []) {
    const [a, b] = ends as [Vec3, Vec3];
    if (distance(a, b) <= 1e-6 * size) continue;
    const colour = look === "axis" ? d.colour("muted") : d.colour("leg");
    d.rods.push({ a, b, radius: (WIDTHS[look] ?? 1) * SIZES.leg * size, colour, solid: true });
  }
  for (const sign of found?.signs ?? []) jointShape(d, sign, sign.at);
}

/** Where a joint is drawn: a slide without a place of its own between its neighbours. */
function placeOf(joints: readonly Joint[], i: number): Vec3 | null {
  if (joints[i]!.point) return joints[i]!.point;
  const before = joints.slice(0, i).reverse().find((j) => j.point)?.point;
  const after = joints.slice(i + 1).find((j) => j.point)?.point;
  return before && after ? mix(before, after, 0.5) : null;
}

function links(d: Drawing, limb: Limb): void {
  const places = limb.joints.flatMap((j) => (j.point ? [j.point] : []));
  for (let i = 1; i < places.length; i++)
    if (distance(places[i - 1]!, places[i]!) > 1e-6 * d.scene.size)
      d.rods.push({ a: places[i - 1]!, b: places[i]!, radius: SIZES.leg * d.scene.size, colour: d.colour("leg"), solid: true });
}

/** Short bars along the axes of turns, a thick one along a slide, a ball for a spherical joint, a ring for a pin. */
function jointShape(d: Drawing, joint: Pick<Joint, "kind" | "actuated" | "axes">, at: Vec3 | null): void {
  const size = d.scene.size;
  if (!at) return;
  const fill = joint.actuated ? d.colour("drive") : d.pale(d.colour("leg"), 0.25);
  const bar = (axis: Vec3, half: number, radius: number) => {
    const u = unit(axis);
    d.rods.push({ a: along(at, u, -half * size), b: along(at, u, half * size), radius: radius * size, colour: fill, solid: true });
  };
  const kind = joint.kind.replace(/[^A-Za-z]/g, "");
  if (kind === "S") {
    d.ball(at, 0.026 * size, fill, d.colour("ink"), 1.25);
  } else if (kind === "pin") {
    d.ball(at, 0.6 * SIZES.joint * size, joint.actuated ? fill : d.colour("paper"), d.colour("ink"), 1.3);
  } else if (kind === "carriage") {
    joint.axes.forEach((axis) => bar(axis, 0.085, 0.032));
  } else if (kind === "P") {
    joint.axes.forEach((axis) => bar(axis, 0.075, 0.026));
  } else if (joint.axes.length) {
    joint.axes.forEach((axis) => bar(axis, 0.06, 0.016));
  } else {
    d.ball(at, 0.02 * size, fill, d.colour("ink"), 1.3);
  }
}

function wrench(d: Drawing, limb: Limb, line: Line, colour: string): void {
  const size = d.scene.size;
  const direction = unit(line.direction);
  const first = limb.joints.find((j) => j.point)?.point ?? d.middle;
  if (line.wrench === "force") {
    const at = line.point ?? first;
    const tip = along(at, direction, 0.5 * size);
    d.arrow(at, tip, colour);
    d.tag(line.text, tip, colour, "construction");
    return;
  }
  const at = line.point ?? add(first, scale(direction, 0.16 * size));
  curvedArrow(d, at, direction, 0.1 * size, colour);
  d.line(along(at, direction, -0.12 * size), along(at, direction, 0.16 * size), colour, { radius: 0.004 * size });
  d.tag(line.text, along(at, direction, 0.16 * size), colour, "construction");
}
