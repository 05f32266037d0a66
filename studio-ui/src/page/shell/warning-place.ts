// Where the warning stands so that it covers none of the marks of the picture.

export type Place = "top" | "bottom" | "below";
type Box = readonly [number, number, number, number];

const [LEFT, GAP] = [10, 5]; // pixels to the edges of the picture, as in viewer.css
const [KEEP, BACK] = [2, 16]; // pixels between it and a mark: to stay where it is, and to come back to the picture

/** The place that it has, as long as it covers no mark there; else the first one where it does not. */
export function placeOf(now: Place, width: number, height: number, across: number, down: number, marks: readonly Box[]): Place {
  const boxes: Record<Exclude<Place, "below">, Box> = {
    top: [LEFT, GAP, LEFT + width, GAP + height],
    bottom: [across - LEFT - width, down - GAP - height, across - LEFT, down - GAP],
  };
  const free = (place: Place, gap: number) => place === "below" || marks.every((mark) => apart(boxes[place], mark, gap));
  if (now !== "below" && free(now, KEEP)) return now;
  return (["top", "bottom"] as const).find((place) => free(place, BACK)) ?? "below";
}

const apart = (a: Box, b: Box, gap: number): boolean =>
  a[2] + gap <= b[0] || b[2] + gap <= a[0] || a[3] + gap <= b[1] || b[3] + gap <= a[1];
