// What is under the pointer: the nearest point within reach, else the frontmost entity.
import { painted, type Tree } from "./bsp";
import type { Face, Model, Rod } from "./drawing";
import type { Sight } from "./sight";
import type { Scene } from "./types";

/** The point nearest to a place on the screen, of those within reach (in pixels). */
export function pointAt(scene: Scene, sight: Sight, x: number, y: number, reach: number): string | null {
  let best: { name: string; far: number } | null = null;
  for (const [name, at] of Object.entries(scene.points)) {
    const [px, py, depth] = sight.place(at);
    const far = Math.hypot(px - x, py - y);
    if (depth > sight.near && far <= reach && (!best || far < best.far - 1e-6)) best = { name, far };
  }
  return best?.name ?? null;
}

export function entityAt(model: Model, split: Tree<{ face: Face } | { rod: Rod }> | null, sight: Sight, x: number, y: number): string | null {
  for (const rod of model.rods)
    if (rod.entity) {
      const [a, b] = [sight.place(rod.a), sight.place(rod.b)];
      if (toStroke(x, y, a[0], a[1], b[0], b[1]) < 7) return rod.entity;
    }
  for (const piece of painted(split, sight.eye).reverse())
    if ("face" in piece.tag && piece.tag.face.entity && within(piece.corners.map((c) => sight.place(c)), x, y)) return piece.tag.face.entity;
  return null;
}

function toStroke(x: number, y: number, x0: number, y0: number, x1: number, y1: number): number {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const t = Math.max(0, Math.min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - x0 - t * dx, y - y0 - t * dy);
}

function within(corners: readonly (readonly [number, number, number])[], x: number, y: number): boolean {
  let inside = false;
  corners.forEach(([ax, ay], i) => {
    const [bx, by] = corners[(i + 1) % corners.length]!;
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  });
  return inside;
}
