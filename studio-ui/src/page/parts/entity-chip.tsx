// An entity by name, in its colour: pointing at it lights it up everywhere.
import type { Entity } from "../../protocol";
import { tone } from "../lib/tint";
import { useStore } from "./context";
import { PointNames } from "./point-name";

export function EntityChip({ entity, named = true }: { entity: Entity; named?: boolean }) {
  const { lit } = useStore();
  const { kind, id, label } = entity;
  const on = lit.current.value?.entity === id;
  return (
    <button
      type="button"
      class={on ? "chip lit" : "chip"}
      style={tone(entity)}
      data-entity={id}
      data-testid={`entity-${id}`}
      aria-pressed={lit.pinned.value?.entity === id}
      aria-label={`${kind} ${label}`}
    >
      <span class={`swatch ${kind}`} aria-hidden="true" />
      {named && <span class="kind">{kind}</span>}
      <span class="math">
        <PointNames label={label} />
      </span>
    </button>
  );
}
