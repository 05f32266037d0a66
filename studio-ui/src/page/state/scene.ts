// What the viewer shows, from what is known of the structure, the numbers at the pose and the panels' own additions.
import type { Numbers, Stage, StageId, Study } from "../../protocol";
import type { Scene } from "../../viewer";

/** What a panel adds to the picture while it is open: a counterexample, extensors of the bench … */
export interface Overlay {
  entities?: Scene["entities"];
  constructed?: Scene["constructed"];
  planes?: Scene["planes"];
  ghost?: Scene["ghost"];
  /** Shows the panel's entities only, not those of the condition. */
  alone?: boolean;
}

export function sceneOf(study: Study): Scene {
  const { points, base, platform, legs, about, size, unit, entities, recipe } = study;
  return { points, base, platform, legs, about, size, unit, entities, limbs: study.robot?.limbs ?? [], ...(recipe && { recipe }) };
}

/** The entities that the stages up to this one have found; null for all of them, from the condition on. */
export function foundBy(stages: readonly Stage[], stage: StageId | null): string[] | null {
  const upTo = Math.max(stages.findIndex(({ id }) => id === stage), 0);
  const listed = (part: readonly Stage[]) =>
    part.flatMap(({ items }) => items.flatMap((item) => (item.kind === "entities" ? item.entities : [])));
  return stages.findIndex(({ id }) => id === "condition") <= upTo ? null : listed(stages.slice(0, upTo + 1));
}

/** What changes with the pose. Points are left out when the numbers belong to an older pose than the one on show. */
export function posedPart(numbers: Numbers, current: boolean): Partial<Scene> {
  const { motion, limbs, skeleton, directions, platform } = numbers;
  return { motion, skeleton, directions, ...(platform && { handles: platform }), ...(limbs.length > 0 && { limbs }), ...(current && { points: numbers.points }) };
}

export function withOverlay(scene: Scene, found: readonly string[] | null, extra: Overlay | null): Scene["entities"] {
  if (extra?.alone) return extra.entities ?? [];
  const own = found ? scene.entities.filter(({ id }) => found.includes(id)) : scene.entities;
  return [...own, ...(extra?.entities ?? [])];
}
