// Where joints are, and how one is said to be elsewhere.
import type { Study, Vec3 } from "../../../protocol";
import { readNumber } from "../../parts/number-field";
import type { Written } from "../../state/resizing";

/** Where a joint is to be: as wanted while the platform is not so yet. */
export function placeOf(study: Study, wanted: Readonly<Record<string, Written>>, name: string): Vec3 {
  const at = study.points[name] ?? [0, 0, 0];
  const to = wanted[name] ?? [null, null, null];
  return at.map((c, i) => (to[i] == null ? c : (readNumber(to[i]!) ?? c))) as Vec3;
}

/** One coordinate elsewhere, the others kept. */
export function written(axis: 0 | 1 | 2, value: number): Written {
  const text = String(Number(value.toPrecision(12)));
  return [axis === 0 ? text : null, axis === 1 ? text : null, axis === 2 ? text : null];
}

/** 1, 2 or 5 times a power of ten, near a hundredth of the robot's size. */
export function stepOf({ size }: Study): number {
  const rough = size / 100;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].reduce((a, b) => (Math.abs(Math.log(b * power / rough)) < Math.abs(Math.log(a * power / rough)) ? b : a)) * power;
}
