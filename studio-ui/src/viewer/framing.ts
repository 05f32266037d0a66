// Where to stand so that what is drawn fills the picture: its outline as it is projected, not a ball around it.
import type { Extent } from "./gizmo";
import type { Stand, Vec3 } from "./types";
import { add, cross, distance, dot, scale, sub, unit } from "./vectors";

/** What there is of the picture. */
export interface Pane {
  width: number;
  height: number;
  /** How much of it is covered from above and from below, in pixels. */
  covered: readonly [above: number, below: number];
  /** The angle from the upper edge to the lower one, in degrees. */
  fov: number;
  /** How much larger labels are than in a picture of the usual size. */
  letter: number;
}

/** Pixels beside and above what is drawn, for labels; of small pictures a share of the side. */
const [BESIDE, ABOVE, LARGEST] = [44, 30, 0.09];

/** The stand nearest to some places, seen from a direction, from which all of them are in the pane; it looks at their depth's middle. */
export function framed(places: readonly Vec3[], direction: Vec3, pane: Pane): Stand {
  const back = unit(direction);
  const right = unit(cross([0, 0, 1], back));
  const up = cross(back, right);
  const [wide, high, low] = slopes(pane);
  const flat = places.map((p) => [dot(p, right), dot(p, up), dot(p, back)] as const);
  // a place is inside one edge of the pane if the eye is far enough along that edge's normal: the farthest of them counts
  const edge = (axis: 0 | 1 | 2, sign: number, slope: number) => flat.reduce((far, p) => Math.max(far, sign * p[axis] + slope * p[2]), -Infinity);
  const [east, west, north, south] = [edge(0, 1, wide), edge(0, -1, wide), edge(1, 1, high), edge(1, -1, low)];
  const [front, rear] = [edge(2, 1, 0), -edge(2, -1, 0)];
  const deep = front - rear;
  // what hides behind one place is seen from a distance all the same
  const least = front + (deep > 1e-9 * Math.abs(front) ? 0.2 * deep : 1);
  const away = Math.max((east + west) / (2 * wide), (north + south) / (high + low), least);
  const axis = add(scale(right, (east - west) / 2), scale(up, (north - south + (low - high) * away) / 2));
  const at = (depth: number): Vec3 => add(axis, scale(back, depth));
  return { eye: at(away), target: at((front + rear) / 2) };
}

/** The tips of handles at a place, which reach so far at the distance 1 in a picture of half the height 1. */
export function tips({ at, reach }: Extent, { eye, target }: Stand, fov: number): Vec3[] {
  const back = unit(sub(eye, target));
  const right = unit(cross([0, 0, 1], back));
  const far = reach * Math.tan((fov * Math.PI) / 360) * distance(eye, at);
  return [right, cross(back, right)].flatMap((way) => [add(at, scale(way, far)), add(at, scale(way, -far))]);
}

/** Half the width, and the heights above and below the middle, of what may be filled at the distance 1. */
function slopes({ width, height, covered, fov, letter }: Pane): [number, number, number] {
  const focus = height / 2 / Math.tan((fov * Math.PI) / 360);
  const pad = (side: number, most: number) => Math.min(most * letter, LARGEST * side);
  const half = height / 2 - pad(height, ABOVE);
  return [(width / 2 - pad(width, BESIDE)) / focus, (half - covered[0]) / focus, (half - covered[1]) / focus];
}

/** Whether all places are in the pane as it is seen from a stand. */
export function holds(places: readonly Vec3[], { eye, target }: Stand, pane: Pane): boolean {
  const back = unit(sub(eye, target));
  const right = unit(cross([0, 0, 1], back));
  const up = cross(back, right);
  const [wide, high, low] = slopes({ ...pane, letter: 0 });
  return places.map((p) => sub(p, eye)).every((p) => {
    const [aside, above, depth] = [dot(p, right), dot(p, up), -dot(p, back)];
    return Math.abs(aside) <= wide * depth && above <= high * depth && -above <= low * depth;
  });
}
