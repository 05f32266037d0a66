// What can be proposed of points, and how it is written as a command.
import type { Entity, Manual, Study, Vec3 } from "../../../protocol";
import type { Scene } from "../../../viewer";
import { sideBySide } from "../../../viewer/names";

export type Kind = "tetrahedron" | "plane" | "line" | "pair" | "lines";

interface Proposal {
  kind: Kind;
  title: string;
  /** How many points make it. */
  size: number;
  /** What must hold, for a non-expert. */
  words: string;
  drawn: Entity["kind"];
}

export const PROPOSALS: readonly Proposal[] = [
  {
    kind: "tetrahedron",
    title: "Tetrahedron",
    size: 4,
    words: "Four points whose bracket occurs in every monomial: it can be taken out as a factor.",
    drawn: "tetrahedron",
  },
  {
    kind: "plane",
    title: "Plane",
    size: 3,
    words: "Three points that stay together in one bracket of every monomial, or the three that are left over.",
    drawn: "plane",
  },
  {
    kind: "line",
    title: "Line",
    size: 2,
    words: "Two points that stay together in one bracket of every monomial.",
    drawn: "line",
  },
  {
    kind: "pair",
    title: "Left-over pair",
    size: 2,
    words: "Two left-over points that only change the sign when they change places: they make a line.",
    drawn: "line",
  },
  {
    kind: "lines",
    title: "Two pairs",
    size: 4,
    words: "Four left-over points as two lines at once: the first two make one, the last two the other.",
    drawn: "line",
  },
];

export const proposalOf = (kind: Kind): Proposal => PROPOSALS.find((p) => p.kind === kind) ?? (PROPOSALS[1] as Proposal);

const SHORT = /^[A-Za-z](_?\d+)?'*$/;

/** Points written together where the engine reads them so. */
const together = (points: readonly string[]): string => points.join(points.every((p) => SHORT.test(p)) ? "" : " ");

export function commandOf(kind: Kind, points: readonly string[]): string {
  const words = kind === "lines" ? [points.slice(0, 2), points.slice(2)].map(together).join(" ") : together(points);
  return `${kind} ${words}`;
}

/** The next picks: a point is taken once, a full hand is begun anew. */
export function picked(picks: readonly string[], name: string, size: number): readonly string[] {
  if (picks.includes(name)) return picks.filter((p) => p !== name);
  return picks.length >= size ? [name] : [...picks, name];
}

/** The points that a command names; [] where they cannot be told. */
function pointsOf(command: string, names: readonly string[]): string[] {
  const rest = command.split(/\s+/).slice(1);
  if (rest.every((word) => names.includes(word))) return rest;
  const letters = rest.join("").match(/[A-Za-z]_?\d*'*/g) ?? [];
  return letters.every((word) => names.includes(word)) ? letters : [];
}

export function draftOf(kind: Kind, picks: readonly string[]): Entity[] {
  const { size, drawn } = proposalOf(kind);
  const parts = kind === "lines" ? [picks.slice(0, 2), picks.slice(2)] : [picks];
  const wanted = kind === "lines" ? 2 : size;
  return parts
    .filter((part) => part.length === wanted)
    .map((points, i) => ({ id: `draft-${i}`, kind: drawn, points: [...points], label: sideBySide(points), starred: sideBySide(points), colour: 3 + i }));
}

/** Ids of their own, so that they are not taken for entities of the automatic analysis. */
export const ownEntities = (manual: Manual): Entity[] => manual.entities.map((e) => ({ ...e, id: `hand-${e.id}` }));

/** The robot at the points that refute a proposal, with what was proposed. */
export function counterScene(study: Study, points: Record<string, Vec3>, command: string): Scene {
  const all = Object.values(points);
  const mean = [0, 1, 2].map((i) => all.reduce((sum, p) => sum + (p[i] ?? 0), 0) / all.length) as Vec3;
  const square = all.reduce((sum, p) => sum + p.reduce((s, c, i) => s + (c - (mean[i] ?? 0)) ** 2, 0), 0);
  const kind = PROPOSALS.find((p) => command.startsWith(`${p.kind} `))?.kind;
  const entities = kind ? draftOf(kind, pointsOf(command, Object.keys(points))).map((e) => ({ ...e, colour: 1 })) : [];
  return {
    points,
    base: study.base,
    platform: study.platform,
    legs: study.legs,
    about: mean,
    size: Math.sqrt(square / all.length) || 1,
    unit: "",
    entities,
  };
}
