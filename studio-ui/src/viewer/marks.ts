// Arrows at the edge of the picture towards places that are not in it, and rings around those that are too far away to be drawn.
import type { Mark, Model } from "./drawing";
import { overlap, type Box } from "./labels";
import { widthOf, type Placed } from "./overlay";
import type { Sight } from "./sight";
import { element } from "./svg";

type XY = readonly [number, number];

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
const CLEAR = 4; // pixels between a label and what it is not to touch

/** What points to the marks that are not seen where they are; of their labels each is clear of all others, and of the arrows. */
export function pointersOf({ marks }: Model, sight: Sight): Pointer[] {
  const wishes = marks.flatMap((mark) => wishOf(mark, sight) ?? []);
  const taken = wishes.map(({ shape }) => outline(shape));
  return wishes.map(({ colour, shape, labels: [first, ...others] }) => {
    const cost = (label: Placed): number => taken.reduce((sum, box) => sum + overlap(boxOf(label), box, CLEAR), 0);
    const label = others.reduce((best, one) => (cost(one) < cost(best) - 1e-6 ? one : best), first);
    taken.push(boxOf(label));
    return { colour, shape, label };
  });
}

/** What other labels are to leave free for these. */
export const takenBy = (pointers: readonly Pointer[]): Box[] => pointers.flatMap(({ shape, label }) => [outline(shape), boxOf(label)]);

const around = (x: number, y: number, w: number, h: number): Box => [Math.floor(x - w), Math.floor(y - h), Math.ceil(x + w), Math.ceil(y + h)];
const boxOf = ({ tag, x, y, size }: Placed): Box => around(x, y, widthOf(tag, size) / 2, size / 2);

function outline(shape: readonly XY[]): Box {
  const [xs, ys] = [shape.map(([x]) => x), shape.map(([, y]) => y)];
  const rim = shape.length === 1 ? RING : 0;
  return [Math.min(...xs) - rim, Math.min(...ys) - rim, Math.max(...xs) + rim, Math.max(...ys) + rim];
}

interface PointerWish extends Omit<Pointer, "label"> {
  /** Where the label may be, the best place first. */
  labels: readonly [Placed, ...Placed[]];
}

function wishOf(mark: Mark, sight: Sight): PointerWish | null {
  const { width, height } = sight;
  const letter = SIZE * sight.letter;
  const [x, y, depth] = sight.place(mark.at);
  const inside = depth > sight.near && x >= 0 && y >= 0 && x <= width && y <= height;
  if (inside && mark.drawn) return null;
  const tag = { text: mark.words, at: mark.at, clear: 0, colour: mark.colour, look: "construction", strong: true, upright: true } as const;
  const half = widthOf(tag, letter) / 2;
  const labelled = ([x, y]: XY): Placed => ({ tag, size: letter, x: within(x, half + 6, width - half - 6), y: within(y, letter, height - letter) });
  const { colour } = mark;
  if (inside) {
    const away = RING + letter;
    const down = y < height / 2 ? 1 : -1;
    const others: XY[] = [[x, y - down * away], [x + half + away, y], [x - half - away, y], [x, y + down * 2 * away]];
    return { colour, shape: [[x, y]], labels: [labelled([x, y + down * away]), ...others.map(labelled)] };
  }
  const forward = depth > 0 ? 1 : -1; // what is behind the eye is seen upside down
  const [dx, dy] = [forward * (x - width / 2), forward * (y - height / 2)];
  const size = Math.hypot(dx, dy);
  const [ux, uy] = size > 1e-9 ? [dx / size, dy / size] : [0, 1];
  const reach = Math.min((width / 2 - INSET) / Math.max(Math.abs(ux), 1e-9), (height / 2 - INSET) / Math.max(Math.abs(uy), 1e-9));
  const at = (back: number, aside: number): XY => [width / 2 + (reach - back) * ux - aside * uy, height / 2 + (reach - back) * uy + aside * ux];
  const shape = [at(0, 0), at(HEAD, HALF), at(HEAD, 1.5), at(SHAFT, 1.5), at(SHAFT, -1.5), at(HEAD, -1.5), at(HEAD, -HALF)];
  const [cx, cy] = at(SHAFT / 2, 0);
  const down = cy < height / 2 ? 1 : -1;
  // beside an arrow upwards or downwards, on the side that has room; above or below one to the side
  const outwards = (cx < width / 2 ? -1 : 1) * (half + 14);
  const aside = cx + outwards - half > 0 && cx + outwards + half < width ? outwards : -outwards;
  const steep = Math.abs(uy) > Math.abs(ux);
  const beside: XY = steep ? [cx + aside, cy] : [cx, cy + down * (letter + CLEAR)];
  // where that is taken: its other side, then line after line further inside
  const opposite: XY = steep ? [cx - aside, cy] : [cx, cy - down * (letter + CLEAR)];
  const lines = [1, 2, 3, 4].flatMap((k): XY[] => [beside, opposite].map(([x, y]) => [x, y + down * k * (letter + 2 * CLEAR)]));
  return { colour, shape, labels: [labelled(beside), ...[opposite, ...lines].map(labelled)] };
}

const within = (value: number, low: number, high: number): number => (low > high ? (low + high) / 2 : Math.min(Math.max(value, low), high));

/** What is not to be covered: the marks with their labels. */
export function boxesOf({ marks }: Model, sight: Sight, labels: readonly Placed[], pointers: readonly Pointer[]): Box[] {
  const own = new Set(marks.map(({ label }) => label));
  return [
    ...marks.filter(({ drawn }) => drawn).flatMap(({ at }): Box[] => {
      const [x, y, depth] = sight.place(at);
      return depth > sight.near && x >= 0 && y >= 0 && x <= sight.width && y <= sight.height ? [around(x, y, 10, 10)] : [];
    }),
    ...labels.filter(({ tag }) => tag.look === "construction" && own.has(tag.text)).map(boxOf),
    ...pointers.flatMap(({ shape, label }) => [boxOf(label), ...shape.map(([x, y]) => around(x, y, 2, 2))]),
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
