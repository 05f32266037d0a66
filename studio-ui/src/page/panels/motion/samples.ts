// The sample of a path that is nearest to a parameter.
import type { PathSample } from "../../../protocol";

export function nearest(samples: readonly PathSample[], parameter: number): number {
  const away = (i: number) => Math.abs((samples[i]?.parameter ?? Infinity) - parameter);
  return samples.reduce((best, _, i) => (away(i) < away(best) ? i : best), 0);
}
