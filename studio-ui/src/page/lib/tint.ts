// The colours of entities, and which letters of a monomial belong to which entity: each entity colours one bracket that holds all of its points.
import type { Entity, Monomial } from "../../protocol";

/** For each bracket, point → colour number. */
export type Tint = readonly ReadonlyMap<string, number>[];

export function tintOf(monomial: Monomial, entities: readonly Entity[]): Tint {
  const tint = monomial.brackets.map(() => new Map<string, number>());
  for (const { points, colour } of entities) {
    const free = monomial.brackets.findIndex(
      (bracket, i) => points.every((p) => bracket.points.includes(p)) && !points.some((p) => tint[i]?.has(p)),
    );
    if (free >= 0) points.forEach((p) => tint[free]?.set(p, colour));
  }
  return tint;
}

/** The colour of an entity, and that of words about it, as custom properties that styles refer to. */
export function tone(entity: Pick<Entity, "colour"> | undefined): { "--tone": string; "--tone-text": string } | undefined {
  if (!entity) return undefined;
  const role = `--entity${(entity.colour % 6) + 1}`;
  return { "--tone": `var(${role})`, "--tone-text": `var(${role}-text)` };
}
