// What is dragged by itself in the picture: the waypoints of a way on its line, and joints while the shape is changed.
import type { Drawing } from "./drawing";
import { SIZES } from "./drawing";
import { legible } from "./palette";
import { IDENTITY, normalised } from "./pose";
import type { Sight } from "./sight";
import type { Grip, Place, Pose, Scene, Vec3 } from "./types";
import { add, sub } from "./vectors";

/** The nearest grip within reach (pixels); waypoints go before the places between them, the chosen one before others at its place. */
export function gripAt(grips: readonly Grip[], chosen: Grip | null, sight: Sight, x: number, y: number, reach: number): Grip | null {
  let best: { grip: Grip; far: number } | null = null;
  for (const grip of grips) {
    const [px, py, depth] = sight.place(grip.at);
    const far = Math.hypot(px - x, py - y);
    if (depth <= sight.near || far > reach) continue;
    const cost = far + (grip.look === "between" ? reach / 2 : grip.id === chosen?.id ? -1 : 0);
    if (!best || cost < best.far) best = { grip, far: cost };
  }
  return best?.grip ?? null;
}

/** A grip as a pose of something that turns about a point. */
export const poseOf = ({ at, turn }: Grip, about: Vec3): Pose => ({ translation: sub(at, about), quaternion: normalised(turn ?? IDENTITY.quaternion) });

export const placeOf = ({ translation, quaternion }: Pose, about: Vec3): Place => ({ at: add(about, translation), turn: quaternion });

/** The line of the way, its waypoints with their numbers, and the singular poses on it. */
export function drawnWay(d: Drawing, { way, grips = [], chosen, size }: Scene): void {
  if (!way) return;
  const colour = d.colour("drive");
  const radius = SIZES.joint * size;
  way.line.slice(1).forEach((b, i) => d.line(way.line[i]!, b, colour, { radius: 0.8 * SIZES.line * size }));
  for (const at of way.singular) d.ball(at, 0.75 * radius, d.colour("mark"), d.colour("paper"), 1.35);
  for (const { id, at, look, label } of grips) {
    if (look === "between") d.ball(at, 0.6 * radius, d.colour("paper"), colour, 1.5);
    if (look !== "stop") continue;
    const strong = id === chosen;
    d.ball(at, radius * (strong ? 1.6 : 1.2), colour, strong ? d.colour("mark") : d.colour("ink"), strong ? 1.5 : 1.3);
    d.tag(label, at, legible(colour, d.state.theme), "entity", { clear: 2 * radius, strong: true, upright: true });
  }
}
