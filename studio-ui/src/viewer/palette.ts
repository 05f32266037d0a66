// Colours by role, for light and dark surroundings: those of gcrules/views/drawing/palette.py (a test compares them).
import type { Theme } from "./types";

export const ROLES = {
  paper: ["#FFFFFF", "#15181C"],
  ink: ["#1A1D21", "#ECEEF0"],
  leg: ["#3A4048", "#C3CAD2"],
  muted: ["#6A727C", "#98A1AC"],
  base: ["#8B94A0", "#7C8793"],
  platform: ["#8B94A0", "#A7B1BD"],
  mark: ["#B00020", "#FF6B7A"],
  drive: ["#F5B400", "#FFC93C"],
  entity1: ["#0072B2", "#56B4E9"],
  entity2: ["#D55E00", "#F0803C"],
  entity3: ["#009E73", "#2FC49B"],
  entity4: ["#A3327E", "#D65DB1"],
  entity5: ["#8F5B00", "#F0E442"],
  entity6: ["#6A3FB5", "#B79CF2"],
} as const satisfies Record<string, readonly [string, string]>;

export type Role = keyof typeof ROLES;
const ENTITIES = Object.keys(ROLES).filter((role) => role.startsWith("entity")) as Role[];

export const colourOf = (role: Role, theme: Theme): string => ROLES[role][theme === "dark" ? 1 : 0];

/** The role of the entity with this number, counted from 0; after six they repeat. */
export const entityRole = (number: number): Role => ENTITIES[((number % 6) + 6) % 6]!;

const CONTRAST = 4.5; // of words to what is behind them

function luminance(colour: string): number {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const share = parseInt(colour.slice(at, at + 2), 16) / 255;
    return share <= 0.03928 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

export function contrast(a: string, b: string): number {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

/** A colour for words, as much nearer to that of ink as they need to be read on paper. */
export function legible(colour: string, theme: Theme): string {
  const steps = [0, 0.1, 0.2, 0.3, 0.4, 0.5].map((t) => blend(colour, colourOf("ink", theme), t));
  return steps.find((one) => contrast(one, colourOf("paper", theme)) >= CONTRAST) ?? steps.at(-1)!;
}

/** A colour between two, 0 for the first. */
export function blend(a: string, b: string, t: number): string {
  const part = (c: string, i: number) => parseInt(c.slice(1 + 2 * i, 3 + 2 * i), 16);
  const mixed = [0, 1, 2].map((i) => Math.round(part(a, i) + (part(b, i) - part(a, i)) * t));
  return `#${mixed.map((c) => c.toString(16).padStart(2, "0")).join("")}`;
}
