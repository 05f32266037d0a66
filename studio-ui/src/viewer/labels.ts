// Labels beside their points, kept clear of each other and of what is drawn, by search over fixed offsets.

export interface Wish {
  /** The point on the screen, and a disc around it to stay outside of. */
  x: number;
  y: number;
  radius: number;
  /** The size of the text. */
  width: number;
  height: number;
  /** Where the label would rather be, seen from the point. */
  toward: [number, number];
  /** Those of higher rank are placed first. */
  rank: number;
}

export interface Place {
  /** The centre of the label. */
  x: number;
  y: number;
  /** How much it still covers, in square pixels. */
  covered: number;
}

/** Left, top, right, bottom, in CSS pixels from the upper left corner. */
export type Box = readonly [number, number, number, number];

const DIRECTIONS = Array.from({ length: 16 }, (_, k): [number, number] => [
  Math.cos((Math.PI * k) / 8),
  Math.sin((Math.PI * k) / 8),
]);
const GAPS = [2, 8, 16, 30];
const EDGE = 2; // pixels between a label and the side of the picture

/** One place for each wish, in order; discs are (x, y, radius), strokes pairs of ends; boxes are taken already. */
export function placed(
  wishes: readonly Wish[],
  discs: readonly [number, number, number][],
  strokes: readonly [number, number, number, number][],
  boxes: readonly Box[],
  width: number,
  height: number,
): Place[] {
  const taken = [...boxes];
  const found = new Array<Place>(wishes.length);
  const order = wishes.map((_, i) => i).sort((i, j) => wishes[j]!.rank - wishes[i]!.rank || i - j);
  for (const i of order) {
    const wish = wishes[i]!;
    const size = Math.hypot(...wish.toward) || 1;
    let best: (Place & { cost: number; box: Box }) | null = null;
    for (const gap of GAPS)
      for (const [dx, dy] of DIRECTIONS) {
        const reach =
          wish.radius + gap + Math.min(wish.width / 2 / Math.max(Math.abs(dx), 1e-9), wish.height / 2 / Math.max(Math.abs(dy), 1e-9));
        const x = within(wish.x + dx * reach, wish.x, wish.width / 2, width);
        const y = within(wish.y + dy * reach, wish.y, wish.height / 2, height);
        const box: Box = [x - wish.width / 2, y - wish.height / 2, x + wish.width / 2, y + wish.height / 2];
        const wished = (dx * wish.toward[0] + dy * wish.toward[1]) / size;
        const texts = taken.reduce((sum, other) => sum + overlap(box, other, 3), 0);
        let cost = 7 * (1 - wished) + 1.4 * gap + 8 * texts;
        for (const [cx, cy, r] of discs) cost += 3 * overlap(box, [cx - r, cy - r, cx + r, cy + r], 1);
        for (const stroke of strokes) cost += 0.9 * inside(box, stroke);
        cost += 60 * (Math.max(0, 2 - box[0]) + Math.max(0, 2 - box[1]));
        cost += 60 * (Math.max(0, box[2] - width + 2) + Math.max(0, box[3] - height + 2));
        if (!best || cost < best.cost - 1e-6) best = { x, y, covered: texts, cost, box };
      }
    taken.push(best!.box);
    found[i] = { x: best!.x, y: best!.y, covered: best!.covered };
  }
  return found;
}

/** Where the middle of a label may be along one side of the picture: inside, if its point is and there is room for it. */
function within(at: number, point: number, half: number, side: number): number {
  if (point < 0 || point > side || 2 * (half + EDGE) > side) return at;
  return Math.min(Math.max(at, half + EDGE), side - half - EDGE);
}

/** The area that two boxes share, the second widened by a margin. */
export function overlap(a: Box, b: Box, margin: number): number {
  const w = Math.min(a[2], b[2] + margin) - Math.max(a[0], b[0] - margin);
  const h = Math.min(a[3], b[3] + margin) - Math.max(a[1], b[1] - margin);
  return Math.max(w, 0) * Math.max(h, 0);
}

/** The length of a stroke inside a box (Liang and Barsky's clipping). */
function inside(box: Box, [x0, y0, x1, y1]: readonly [number, number, number, number]): number {
  let [low, high] = [0, 1];
  const [dx, dy] = [x1 - x0, y1 - y0];
  for (const [p, q] of [[-dx, x0 - box[0]], [dx, box[2] - x0], [-dy, y0 - box[1]], [dy, box[3] - y0]] as const) {
    if (Math.abs(p) < 1e-12) {
      if (q < 0) return 0;
    } else if (p < 0) low = Math.max(low, q / p);
    else high = Math.min(high, q / p);
  }
  return high > low ? (high - low) * Math.hypot(dx, dy) : 0;
}
