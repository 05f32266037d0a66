// The state of the 3D pane that is no part of the document: what the mouse does, what is shown, what panels add.
import { signal, type Signal } from "@preact/signals";
import type { Layer, Mode, Vec3, Viewer } from "../../viewer";
import type { Overlay } from "./scene";

/** Left, top, right, bottom. */
export type Box = readonly [number, number, number, number];

export interface Space {
  /** The viewer, while it is on show; tests reach it as `window.gcrules.viewer`. */
  viewer: Signal<Viewer | null>;
  mode: Signal<Mode>;
  /** From where the robot is looked at; null before it is seen. */
  from: Signal<Vec3 | null>;
  layers: Signal<Record<Layer, boolean>>;
  /** Whether the picture takes the whole window. */
  large: Signal<boolean>;
  /** Whether the gained motion is being played. */
  playing: Signal<boolean>;
  /** Where the points are seen in which planes meet, in pixels of the picture; see `onMarks` of the viewer. */
  marks: Signal<readonly Box[]>;
  /** What the panel that is open adds to the picture; it takes it back when it closes. */
  overlay: Signal<Overlay | null>;
  /** Points picked in 3D (mode "pick") and in the schematic go to the one that asked last. Returns how to stop. */
  onPick(take: (name: string) => void): () => void;
  pick(name: string): boolean;
}

export function createSpace(): Space {
  let takers: ((name: string) => void)[] = [];
  return {
    viewer: signal(null),
    mode: signal<Mode>("orbit"),
    from: signal<Vec3 | null>(null),
    layers: signal({ entities: true, labels: true, legs: true, wrenches: true, grid: true, motion: true, surface: true, way: true }),
    large: signal(false),
    playing: signal(false),
    marks: signal<readonly Box[]>([]),
    overlay: signal(null),
    onPick(take) {
      takers = [...takers, take];
      return () => void (takers = takers.filter((other) => other !== take));
    },
    pick(name) {
      const take = takers.at(-1);
      take?.(name);
      return take !== undefined;
    },
  };
}
