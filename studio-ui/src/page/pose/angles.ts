// The three angles of the sliders. Many angles make the same turn, so the ones last set are kept while they still do.
import { useRef } from "preact/hooks";
import type { Quaternion, Vec3 } from "../../protocol";
import { fromAngles, sameTurn, toAngles, type Angles } from "../lib/rotation";

export interface Held {
  angles: Vec3;
  set(axis: 0 | 1 | 2, degrees: number): Quaternion;
}

export function useAngles(kind: Angles, quaternion: Quaternion): Held {
  const held = useRef<{ kind: Angles; angles: Vec3 }>({ kind, angles: [0, 0, 0] });
  const { current } = held;
  if (current.kind !== kind || !sameTurn(fromAngles(kind, current.angles), quaternion)) {
    held.current = { kind, angles: toAngles(kind, quaternion) };
  }
  return {
    angles: held.current.angles,
    set(axis, degrees) {
      const angles: Vec3 = [...held.current.angles];
      angles[axis] = degrees;
      held.current = { kind, angles };
      return fromAngles(kind, angles);
    },
  };
}
