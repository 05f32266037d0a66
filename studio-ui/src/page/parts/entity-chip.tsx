// An entity by name, in its colour: pointing at it lights it up everywhere.
import type { Entity } from "../../protocol";
import { isDrawn } from "../../viewer/model";
import { tone } from "../lib/tint";
import { useStore } from "./context";
import { PointNames } from "./point-name";

interface Props {
  entity: Entity;
  /** With its kind in words. */
  named?: boolean;
  /** With the stars of the steps that find entities. */
  starred?: boolean;
}

export function EntityChip({ entity, named = true, starred = false }: Props) {
  const { lit, study, posing } = useStore();
  const { kind, id } = entity;
  const label = starred ? entity.starred : entity.label;
  const known = study.value?.entities.some((own) => own.id === id); // others are those of a panel
  const directions = posing.numbers.value?.directions;
  const far = known && posing.numbers.value !== null && !isDrawn({ points: study.value!.points, directions }, entity);
  const on = lit.current.value?.entity === id;
  return (
    <button
      type="button"
      class={`chip${on ? " lit" : ""}${far ? " far" : ""}`}
      style={tone(entity)}
      data-entity={id}
      data-testid={`entity-${id}`}
      aria-pressed={lit.pinned.value?.entity === id}
      aria-label={`${kind} ${label}${far ? ", at infinity, not drawn" : ""}`}
      title={far ? "At infinity: there is nothing of it to be drawn" : undefined}
    >
      <span class={`swatch ${kind}`} aria-hidden="true" />
      {named && <span class="kind">{kind}</span>}
      <span class="math">
        <PointNames label={label} />
      </span>
    </button>
  );
}
