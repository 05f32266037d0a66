// What is pointed at: the same point, leg, bracket or entity lights up in every monomial, in the schematic and in 3D.
import { computed, signal, type ReadonlySignal } from "@preact/signals";
import type { Entity } from "../../protocol";
import { sideBySide } from "../../viewer/names";

export interface Target {
  kind: "point" | "leg" | "bracket" | "entity";
  points: string[];
  /** In words: "plane abc". */
  label: string;
  entity?: string;
  /** Number of its colour in the palette. */
  colour?: number;
}

export interface Lit {
  current: ReadonlySignal<Target | null>;
  pinned: ReadonlySignal<Target | null>;
  hover(target: Target | null): void;
  /** Keeps the target lit until it is pinned again or another one is. */
  pin(target: Target | null): void;
}

export const pointTarget = (name: string): Target => ({ kind: "point", points: [name], label: `point ${name}` });

export const legTarget = ([a, b]: readonly [string, string]): Target => ({
  kind: "leg",
  points: [a, b],
  label: `leg ${sideBySide([a, b])}`,
});

export const bracketTarget = (points: string[]): Target => ({ kind: "bracket", points, label: `bracket [${sideBySide(points)}]` });

export const entityTarget = ({ id, kind, points, label, colour }: Entity): Target => ({
  kind: "entity",
  points,
  label: `${kind} ${label}`,
  entity: id,
  colour,
});

function sameTarget(a: Target | null, b: Target | null): boolean {
  return a?.kind === b?.kind && a?.entity === b?.entity && a?.points.join(" ") === b?.points.join(" ");
}

/** The points of these that light up: a point and a leg wherever they stand, brackets and entities where all is there. */
export function litPoints(points: readonly string[], target: Target | null): readonly string[] {
  if (!target) return [];
  const there = target.points.filter((point) => points.includes(point));
  const together = target.kind === "bracket" || target.kind === "entity";
  return together && there.length < target.points.length ? [] : there;
}

export function createLit(): Lit {
  const hovered = signal<Target | null>(null);
  const pinned = signal<Target | null>(null);
  return {
    current: computed(() => hovered.value ?? pinned.value),
    pinned,
    hover(target) {
      if (!sameTarget(target, hovered.peek())) hovered.value = target;
    },
    pin(target) {
      pinned.value = sameTarget(target, pinned.peek()) ? null : target;
    },
  };
}
