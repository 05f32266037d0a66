// What the page shows that a line repeats: each with the question that it answers.
import type { Method, RepeatArgs } from "../../protocol";
import type { Running } from "./running";
import type { Store } from "./store";

export interface Repeatable {
  title: string;
  what: RepeatArgs["what"];
  args: Readonly<Record<string, unknown>>;
}

/** In the order of the panels; answers that were asked for count as long as they are there. */
export function repeatables({ source$, pose$, threshold$, commands$, bench$, rules$, study, posing, timeline, touring, roaming }: Store): Repeatable[] {
  const [source, shown, pose, threshold, text] = [source$.value, study.value, pose$.value, threshold$.value, bench$.value];
  const commands = commands$.value;
  const actuated = (posing.numbers.value?.actuators.length ?? 0) > 0;
  const moves = (shown?.axes.length ?? 0) > 0;
  const rows: [string, Repeatable["what"], Repeatable["args"] | false | null][] = [
    ["The analysis", "open", shown !== null && { source }],
    ["The pose on show", "pose", moves && { source, pose, threshold }],
    ["Its actuators", "actuators", moves && actuated && { source, pose, threshold }],
    ["The way", "path", askedOf(timeline.check.value)],
    ["By hand", "manual", shown !== null && commands.length > 0 && { source, commands }],
    ["The path", "path", askedOf(touring.path.now.value)],
    ["The map", "map", shownOf(touring.map.shown.value)],
    ["The singular surface", "surface", shownOf(touring.surface.shown.value)],
    ["The formula", "locus", askedOf(touring.locus.now.value)],
    ["Assembly modes", "assemblies", askedOf(roaming.assemblies.now.value)],
    ["Aspects", "aspects", askedOf(roaming.aspects.now.value)],
    ["The free region", "free", askedOf(roaming.free.now.value)],
    ["Whole ranges, mapped", "boxes", askedOf(roaming.boxes.now.value)],
    ["Whole ranges, certified", "certify", askedOf(roaming.certify.now.value)],
    ["The bench", "bench", text.trim() !== "" && { text, ...(rules$.value.length > 0 && { rules: rules$.value }) }],
  ];
  return rows.flatMap(([title, what, args]) => (args ? [{ title, what, args }] : []));
}

/** Of what is refined while one looks, the finest that is there. */
const shownOf = (shown: { asked: object } | null): Repeatable["args"] | null => (shown ? { ...shown.asked } : null);

const askedOf = <M extends Method>(now: Running<M>): Repeatable["args"] | null => (now.state === "found" ? { ...now.asked } : null);
