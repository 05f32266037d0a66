// From space to the screen: the camera's view in plain numbers.
import type { PerspectiveCamera } from "three";
import type { Vec3 } from "./types";
import { mix } from "./vectors";

export interface Sight {
  eye: Vec3;
  width: number;
  height: number;
  /** The distance in front of which nothing is seen. */
  near: number;
  /** CSS pixels from the upper left corner, and the depth in front of the eye. */
  place(p: Vec3): [x: number, y: number, depth: number];
  /** What a place at a depth goes through in space when it goes so many pixels to the right and down, in the plane of the view. */
  shift(right: number, down: number, depth: number): Vec3;
  /** Pixels for a unit of length at a depth. */
  scale(depth: number): number;
  /** How much larger labels are than in a picture of the usual size: large ones are looked at from farther away. */
  letter: number;
}

const USUAL = 560; // pixels
const LARGEST = 1.5;

export function sightOf(camera: PerspectiveCamera, width: number, height: number): Sight {
  camera.updateMatrixWorld();
  const view = camera.matrixWorldInverse.elements;
  const focus = height / 2 / Math.tan((camera.fov * Math.PI) / 360);
  return {
    eye: camera.position.toArray() as Vec3,
    width,
    height,
    near: camera.near,
    letter: Math.min(Math.max(Math.min(width, height) / USUAL, 1), LARGEST),
    shift: (right, down, depth) => {
      const k = Math.max(depth, 1e-9) / focus;
      return [0, 4, 8].map((i) => k * (right * view[i]! - down * view[i + 1]!)) as Vec3;
    },
    scale: (depth) => focus / Math.max(depth, 1e-9),
    place: ([x, y, z]) => {
      const at = (i: number) => view[i]! * x + view[4 + i]! * y + view[8 + i]! * z + view[12 + i]!;
      const depth = -at(2);
      const k = focus / (Math.abs(depth) < 1e-9 ? 1e-9 : depth);
      return [width / 2 + at(0) * k, height / 2 - at(1) * k, depth];
    },
  };
}

/** The part of a polygon or stroke in front of the eye. */
export function inFront(sight: Sight, corners: readonly Vec3[]): Vec3[] {
  const depth = corners.map((c) => sight.place(c)[2] - sight.near);
  if (depth.every((d) => d > 0)) return [...corners];
  const out: Vec3[] = [];
  const count = corners.length;
  for (let i = 0; i < count; i++) {
    const j = (i + 1) % count;
    if (depth[i]! > 0) out.push(corners[i]!);
    if (depth[i]! * depth[j]! < 0 && (count > 2 || i === 0))
      out.push(mix(corners[i]!, corners[j]!, depth[i]! / (depth[i]! - depth[j]!)));
  }
  return out;
}
