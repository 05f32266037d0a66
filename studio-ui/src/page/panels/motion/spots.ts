// Places of a map as parts of its ranges, from 0 to 1: nodes, cells, coordinates.
import type { Axis, MapAnswer } from "../../../protocol";
import type { Spot } from "./plot";

/** The next node that way. */
export function stepped(from: Spot, by: Spot, { length: rows, [0]: row }: MapAnswer["margin"]): Spot {
  const next = (i: 0 | 1, nodes: number) => Math.min(Math.max(Math.round(from[i] * (nodes - 1)) + by[i], 0), nodes - 1) / (nodes - 1);
  return [next(0, rows), next(1, row?.length ?? rows)];
}

/** Which of so many cells a part of their range lies in. */
export const within = (part: number, cells: number): number => Math.min(Math.floor(part * cells), cells - 1);

/** The coordinate at a part of its range. */
export const valueOf = ({ low, high }: Axis, part: number): number => low + part * (high - low);
