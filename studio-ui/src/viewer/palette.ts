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

/** A colour between two, 0 for the first. */
export function blend(a: string, b: string, t: number): string {
  const part = (c: string, i: number) => parseInt(c.slice(1 + 2 * i, 3 + 2 * i), 16);
  const mixed = [0, 1, 2].map((i) => Math.round(part(a, i) + (part(b, i) - part(a, i)) * t));
  return `#${mixed.map((c) => c.toString(16).padStart(2, "0")).join("")}`;
}
