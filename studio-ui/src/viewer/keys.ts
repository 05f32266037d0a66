// The keyboard: arrows and page keys shift the platform, with Shift they turn it; others move the camera.
import { multiply, normalised, rotationVector, turnAbout } from "./pose";
import type { Pose, Vec3 } from "./types";
import { along, length } from "./vectors";

const DIRECTIONS: Record<string, Vec3> = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};
// with Shift: left and right turn about z, up and down about x, page keys about y
const AXES: Record<string, Vec3> = {
  ArrowLeft: [0, 0, 1],
  ArrowRight: [0, 0, -1],
  ArrowUp: [-1, 0, 0],
  ArrowDown: [1, 0, 0],
  PageUp: [0, 1, 0],
  PageDown: [0, -1, 0],
};

/** The pose after a key, or null if it moves nothing. A step is a hundredth of the size, or two degrees. */
export function nudged(pose: Pose, key: string, shift: boolean, size: number): Pose | null {
  const direction = DIRECTIONS[key];
  if (!direction) return null;
  if (!shift) return { ...pose, translation: along(pose.translation, direction, size / 100) };
  const turn = turnAbout(AXES[key]!, Math.PI / 90);
  return { ...pose, quaternion: normalised(multiply(turn, pose.quaternion)) };
}

/** The pose in words, for those who do not see it. */
export function poseInWords(pose: Pose, unit: string): string {
  const number = (c: number) => String(Number(c.toPrecision(3))).replace("-", "minus ");
  const [x, y, z] = pose.translation.map(number);
  const angle = length(rotationVector(pose.quaternion));
  return `Platform shifted by x ${x}, y ${y}, z ${z} ${unit}, turned by ${number(Math.round(angle * 10) / 10)} degrees`;
}

export const HELP =
  "Arrow keys shift the platform along x and y, Page Up and Page Down along z; with Shift they turn it. " +
  "With Alt the arrow keys turn the view. Plus and minus zoom, Home fits the view.";

export const GRIPS =
  "Full stop and comma choose what can be dragged, waypoints or joints; the keys above then move it. " +
  "Delete takes a waypoint out, Insert puts one after it, Escape lets go.";
