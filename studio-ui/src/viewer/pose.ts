// Poses: p ↦ R(p − about) + about + translation, R by a unit quaternion with its scalar first.
import type { Pose, Quaternion, Scene, Vec3 } from "./types";
import { add, cross, length, scale, sub } from "./vectors";

export const IDENTITY: Pose = { translation: [0, 0, 0], quaternion: [1, 0, 0, 0] };

export function multiply(p: Quaternion, q: Quaternion): Quaternion {
  const [a, b, c, d] = p;
  const [w, x, y, z] = q;
  return [
    a * w - b * x - c * y - d * z,
    a * x + b * w + c * z - d * y,
    a * y - b * z + c * w + d * x,
    a * z + b * y - c * x + d * w,
  ];
}

export const conjugate = ([w, x, y, z]: Quaternion): Quaternion => [w, -x, -y, -z];

/** Of length 1 with its scalar not negative. */
export function normalised(q: Quaternion): Quaternion {
  const size = (q[0] < 0 ? -1 : 1) * Math.hypot(...q);
  return size ? (q.map((c) => c / size) as Quaternion) : [1, 0, 0, 0];
}

/** A turn by an angle in radians about a unit vector. */
export function turnAbout(axis: Vec3, angle: number): Quaternion {
  const s = Math.sin(angle / 2);
  return [Math.cos(angle / 2), axis[0] * s, axis[1] * s, axis[2] * s];
}

export function turned(v: Vec3, [w, x, y, z]: Quaternion): Vec3 {
  const t = scale(cross([x, y, z], v), 2);
  return add(add(v, scale(t, w)), cross([x, y, z], t));
}

const moved = (p: Vec3, pose: Pose, about: Vec3): Vec3 =>
  add(add(turned(sub(p, about), pose.quaternion), about), pose.translation);

/** Where a point seen at one pose is at another one. */
export function carried(p: Vec3, from: Pose, to: Pose, about: Vec3): Vec3 {
  const home = add(turned(sub(sub(p, from.translation), about), conjugate(from.quaternion)), about);
  return moved(home, to, about);
}

/** A scene whose platform was moved from one pose to another. */
export function sceneAt(scene: Scene, from: Pose, to: Pose): Scene {
  if (from === to || !scene.platform.length) return scene;
  const points = { ...scene.points };
  for (const n of scene.platform) if (points[n]) points[n] = carried(points[n], from, to, scene.about);
  return { ...scene, points };
}

/** The axis of a turn times its angle in degrees. */
export function rotationVector(q: Quaternion): Vec3 {
  const [w, x, y, z] = normalised(q);
  const sine = length([x, y, z]);
  const factor = sine > 1e-12 ? ((2 * Math.atan2(sine, w)) / sine) * (180 / Math.PI) : 0;
  return [x * factor, y * factor, z * factor];
}

/** Euler angles z, y, x in degrees (R = Rz·Ry·Rx): yaw, pitch and roll. */
export function eulerAngles(q: Quaternion): Vec3 {
  const [w, x, y, z] = normalised(q);
  const pitch = Math.asin(Math.max(-1, Math.min(1, 2 * (w * y - x * z))));
  const yaw = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  const roll = Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y));
  return [yaw, pitch, roll].map((a) => (a * 180) / Math.PI) as Vec3;
}

/** The quaternion of Euler angles z, y, x in degrees. */
export function fromEuler([yaw, pitch, roll]: Vec3): Quaternion {
  const half = Math.PI / 180;
  const [z, y, x] = [turnAbout([0, 0, 1], yaw * half), turnAbout([0, 1, 0], pitch * half), turnAbout([1, 0, 0], roll * half)];
  return normalised(multiply(multiply(z, y), x));
}
