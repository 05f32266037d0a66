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

/** The part of its range at which a coordinate stands. */
export const partOf = ({ low, high }: Axis, value: number): number => (value - low) / (high - low);

/** Round coordinates along an axis, a handful. */
export function ticks({ low, high }: Axis): number[] {
  const power = 10 ** Math.floor(Math.log10((high - low) / 4));
  const step = [1, 2, 2.5, 5, 10].map((k) => k * power).find((k) => (high - low) / k <= 5) ?? high - low;
  const first = Math.ceil(low / step - 1e-9);
  const number = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: number }, (_, i) => Number(((first + i) * step).toPrecision(6)));
}

const measured = ({ margin, index }: MapAnswer) => (index.length ? index : margin);

/** The least and the largest measure at the nodes. */
export function extent(map: MapAnswer): [number, number] {
  const all = measured(map).flat().filter((value) => value !== null);
  return all.length ? [Math.min(...all), Math.max(...all)] : [0, 0];
}

/** How large the measure is in each cell, from 0 to 1: the mean of its corners, of what there is between least and most. */
export function shades(map: MapAnswer): number[][] {
  const nodes = measured(map);
  const [least, most] = extent(map);
  const at = (i: number, j: number) => ((nodes[i]?.[j] ?? least) - least) / (most - least || 1);
  return map.status.map((column, i) =>
    column.map((_, j) => (at(i, j) + at(i + 1, j) + at(i, j + 1) + at(i + 1, j + 1)) / 4),
  );
}
