// Whether points are seen in a picture.
import type { Viewer } from "../../viewer";

export function inSight(viewer: Viewer, { clientWidth, clientHeight }: HTMLElement, names: readonly string[]): boolean {
  if (clientWidth === 0) return true; // the picture is not on show
  const within = (at: readonly [number, number] | null) =>
    at !== null && at[0] >= 0 && at[1] >= 0 && at[0] <= clientWidth && at[1] <= clientHeight;
  return names.every((name) => within(viewer.toScreen(name)));
}
