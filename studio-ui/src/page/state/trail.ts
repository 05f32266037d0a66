// The way that the platform has gone, as far as it is plotted: the margin at each pose that was answered.
import type { Along, Numbers, Pose, Verdict } from "../../protocol";
import { samePose } from "./doc";

export interface Passed {
  margin: number;
  verdict: Verdict;
  pose: Numbers["pose"];
}

export const LONGEST = 240;

export const passedOf = ({ margin, verdicts }: Along, way: readonly Pose[]): Passed[] =>
  way.map((pose, i) => ({ pose, margin: margin[i] ?? 0, verdict: verdicts[i] ?? "regular" }));

export function extended(way: readonly Passed[], { margin, verdict, pose }: Numbers): readonly Passed[] {
  const last = way.at(-1);
  const moved = { margin, verdict, pose };
  return last && samePose(last.pose, pose) ? [...way.slice(0, -1), moved] : [...way.slice(-LONGEST + 1), moved];
}
