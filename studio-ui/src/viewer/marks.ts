// Arrows at the edge of the picture towards places that are not in it, and rings around those that are too far away to be drawn.
import type { Model } from "./drawing";
import { widthOf, type Placed } from "./overlay";
import type { Sight } from "./sight";
import { element } from "./svg";

type XY = readonly [number, number];
/** Left, top, right, bottom, in CSS pixels from the upper left corner. */
export type Box = readonly [number, number, number, number];

export interface Pointer {
  colour: string;
  /** An arrow's corners; a ring's middle alone. */
  shape: readonly XY[];
  label: Placed;
}

const INSET = 12; // pixels between the tip of an arrow and the edge
const [HEAD, HALF, SHAFT] = [13, 6, 30];
const RING = 7;
const SIZE = 15;

/** What points to the marks that are not seen where they are. */
export function pointersOf({ marks }: Model, sight: Sight): Pointer[] {
  return marks.flatMap((mark): Pointer[] => {
    const { width, height } = sight;
    const [x, y, depth] = sight.place(mark.at);
    const inside = depth > sight.near && x >= 0 && y >= 0 && x <= width && y <= height;
    if (inside && mark.drawn) return [];
    const labelled = (at: XY): Placed => {
      const tag = { text: mark.words, at: mark.at, clear: 0, colour: mark.colour, look: "construction", strong: true, upright: true } as const;
      const [w, h] = [widthOf(tag, SIZE) / 2 + 6, SIZE];
      return { tag, size: SIZE, x: within(at[0], w, width - w), y: within(at[1], h, height - h) };
    };
    if (inside) return [{ colour: mark.colour, shape: [[x, y]], label: labelled([x, y + (y < height / 2 ? 1 : -1) * (RING + SIZE)]) }];
    const forward = depth > 0 ? 1 : -1; // what is behind the eye is seen upside down
    const [dx, dy] = [forward * (x - width / 2), forward * (y - height / 2)];
    const size = Math.hypot(dx, dy);
    const [ux, uy] = size > 1e-9 ? [dx / size, dy / size] : [0, 1];
    const reach = Math.min((width / 2 - INSET) / Math.max(Math.abs(ux), 1e-9), (height / 2 - INSET) / Math.max(Math.abs(uy), 1e-9));
    const at = (back: number, aside: number): XY => [width / 2 + (reach - back) * ux - aside * uy, height / 2 + (reach - back) * uy + aside * ux];
    const shape = [at(0, 0), at(HEAD, HALF), at(HEAD, 1.5), at(SHAFT, 1.5), at(SHAFT, -1.5), at(HEAD, -1.5), at(HEAD, -HALF)];
    const half = widthOf({ text: mark.words, upright: true }, SIZE) / 2;
    const [cx, cy] = at(SHAFT / 2, 0);
    // beside an arrow upwards or downwards, on the side that has room; above or below one to the side
    const outwards = (cx < width / 2 ? -1 : 1) * (half + 14);
    const aside = cx + outwards - half > 0 && cx + outwards + half < width ? outwards : -outwards;
    const beside: XY = Math.abs(uy) > Math.abs(ux) ? [cx + aside, cy] : [cx, cy + (cy < height / 2 ? 1 : -1) * (SIZE + 4)];
    return [{ colour: mark.colour, shape, label: labelled(beside) }];
  });
}

const within = (value: number, low: number, high: number): number => (low > high ? (low + high) / 2 : Math.min(Math.max(value, low), high));

/** What is not to be covered: the marks with their labels. */
export function boxesOf({ marks }: Model, sight: Sight, labels: readonly Placed[], pointers: readonly Pointer[]): Box[] {
  const around = (x: number, y: number, w: number, h: number): Box => [Math.floor(x - w), Math.floor(y - h), Math.ceil(x + w), Math.ceil(y + h)];
  const text = ({ tag, x, y, size }: Placed): Box => around(x, y, widthOf(tag, size) / 2, size / 2);
  const own = new Set(marks.map(({ label }) => label));
  return [
    ...marks.filter(({ drawn }) => drawn).flatMap(({ at }): Box[] => {
      const [x, y, depth] = sight.place(at);
      return depth > sight.near && x >= 0 && y >= 0 && x <= sight.width && y <= sight.height ? [around(x, y, 10, 10)] : [];
    }),
    ...labels.filter(({ tag }) => tag.look === "construction" && own.has(tag.text)).map(text),
    ...pointers.flatMap(({ shape, label }) => [text(label), ...shape.map(([x, y]) => around(x, y, 2, 2))]),
  ];
}

export function svgPointers(pointers: readonly Pointer[]): SVGElement[] {
  return pointers.map(({ shape, colour }) => {
    const [first] = shape;
    if (shape.length === 1 && first) return element("circle", { cx: first[0], cy: first[1], r: RING, fill: "none", stroke: colour, "stroke-width": 2.5 });
    return element("polygon", { points: shape.map((p) => p.map((c) => c.toFixed(1)).join(",")).join(" "), fill: colour });
  });
}

export function drawPointers(pen: CanvasRenderingContext2D, pointers: readonly Pointer[]): void {
  for (const { shape, colour } of pointers) {
    const [first] = shape;
    if (!first) continue;
    pen.beginPath();
    if (shape.length === 1) {
      pen.strokeStyle = colour;
      pen.lineWidth = 2.5;
      pen.arc(first[0], first[1], RING, 0, 2 * Math.PI);
      pen.stroke();
    } else {
      pen.fillStyle = colour;
      shape.forEach(([x, y]) => pen.lineTo(x, y));
      pen.fill();
    }
  }
}
