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
  const numbers = posing.numbers.value;
  const far = known && numbers !== null && !isDrawn(numbers, entity);
  const infinite = far && entity.points.every((name) => numbers.directions[name]);
  const why = infinite ? "at infinity" : "a point of it has no place here";
  const on = lit.current.value?.entity === id;
  return (
    <button
      type="button"
      class={`chip${on ? " lit" : ""}${far ? " far" : ""}`}
      style={tone(entity)}
      data-entity={id}
      data-testid={`entity-${id}`}
      aria-pressed={lit.pinned.value?.entity === id}
      aria-label={`${kind} ${label}${far ? `, ${why}, not drawn` : ""}`}
      title={infinite ? "At infinity: there is nothing of it to be drawn" : far ? "Not drawn: a point of it has no place in this pose" : undefined}
    >
      <span class={`swatch ${kind}`} aria-hidden="true" />
      {named && <span class="kind">{kind}</span>}
      <span class="math">
        <PointNames label={label} />
      </span>
    </button>
  );
}
