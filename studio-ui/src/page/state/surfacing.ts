// The singular surface over x, y and z: the ranges that it begins with, where it lies in the scene, and whether it still holds.
import type { Numbers, Pose, Study, SurfaceAnswer, Vec3 } from "../../protocol";
import type { TriangleMesh } from "../../viewer";
import type { Box } from "./doc";
import type { Refined } from "./refining";


/** Where joints are solved for, each pose takes longer. */
export const finenessOf = ({ kind }: Study): number => (kind === "robot" ? 9 : 25);

const rounded = (value: number): number => Number(value.toPrecision(2));

/** Ranges of x, y and z to begin with, which leave the robot in sight; null where the platform is not told by them. */
export function boxOf({ ranges }: Study): Box | null {
  const found = (["x", "y", "z"] as const).map((name) => ranges.find((range) => range.name === name));
  if (!found.every((range) => range !== undefined)) return null;
  return found.map(({ name, low, high }) => ({ name, low: rounded(low), high: rounded(high) })) as Box;
}

const TURNED = 1e-9;

/** Whether the coordinates that are no axes of it are others now. */
export function isStale({ asked, result }: Refined<"surface">, pose: Pose, numbers: Numbers | null, { kind, freedoms }: Study): boolean {
  if (kind !== "robot") {
    const [a, b] = [asked.pose.quaternion, pose.quaternion];
    const size = Math.hypot(...a) * Math.hypot(...b);
    return 1 - Math.abs(a.reduce((sum, c, i) => sum + c * b[i]!, 0)) / size > TURNED; // q and −q are one turn
  }
  return freedoms.some(({ name, unit }, i) => {
    const held = result.held[name];
    const now = numbers?.freedoms[i];
    if (held === undefined || now === undefined) return false;
    return Math.abs((unit === "deg" ? (now * Math.PI) / 180 : now) - held) > 1e-4;
  });
}

/** In the scene: the platform's centre is there where the robot is singular. */
export function meshOf({ vertices, faces, reached }: SurfaceAnswer, about: Vec3, stale: boolean): TriangleMesh {
  return { vertices: vertices.map((c, i) => c + about[(i % 3) as 0 | 1 | 2]), faces, reached, stale };
}

/** The corner nearest to a place from home, one within the limits if there are some; null where there is none. */
export function nearestCorner({ vertices, reached }: SurfaceAnswer, at: Vec3): Vec3 | null {
  const among = reached.flatMap((within, i) => (within || !reached.includes(true) ? [i] : []));
  const away = (i: number) => Math.hypot(...at.map((c, k) => vertices[3 * i + k]! - c));
  const best = among.reduce<number | null>((a, b) => (a === null || away(b) < away(a) ? b : a), null);
  return best === null ? null : (vertices.slice(3 * best, 3 * best + 3) as Vec3);
}
