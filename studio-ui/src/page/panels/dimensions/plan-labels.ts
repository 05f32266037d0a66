// Where the names of the joints stand in the plan: beside their dots, clear of each other and of the legs.
import { placed } from "../../../viewer/labels";
import { widthOf } from "../../../viewer/overlay";

/** The sheet in its own units, from the upper left corner downwards; a name is written twelve of them high. */
export const SHEET = { width: 308, height: 220, dot: 4.5 } as const;
const [LETTER, LINE] = [13, 16]; // the letters of the page are a little wider than those that are measured
const LONGEST = 20; // letters
const COVERED = 30; // square units that one name may have in common with others

type Spot = readonly [number, number];

export interface Named {
  name: string;
  at: Spot;
  body: "base" | "platform" | "limb";
  selected: boolean;
}

export interface Label {
  text: string;
  /** The middle of the label, seen from its joint. */
  by: Spot;
}

/** A label for each joint, in order; null where it would cover another one that counts for more. */
export function planLabels(joints: readonly Named[], legs: readonly (readonly [Spot, Spot])[]): (Label | null)[] {
  const texts = joints.map(({ name }) => (name.length > LONGEST ? `${name.slice(0, LONGEST)}…` : name));
  const wishes = joints.map(({ at, body, selected }, i) => ({
    x: at[0],
    y: at[1],
    radius: SHEET.dot,
    width: widthOf({ text: texts[i]!, upright: true }, LETTER),
    height: LINE,
    toward: (body === "base" ? [-1, 1] : [1, -1]) as [number, number],
    rank: selected ? 2 : body === "limb" ? 0 : 1,
  }));
  const dots = joints.map(({ at }): [number, number, number] => [...at, SHEET.dot]);
  const strokes = legs.map(([[a, b], [c, d]]): [number, number, number, number] => [a, b, c, d]);
  return placed(wishes, dots, strokes, [], SHEET.width, SHEET.height).map(({ x, y, covered }, i) => {
    const { at, selected } = joints[i]!;
    return covered > COVERED && !selected ? null : { text: texts[i]!, by: [x - at[0], y - at[1]] };
  });
}
