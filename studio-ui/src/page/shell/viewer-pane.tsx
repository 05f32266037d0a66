// The robot in 3D: makes the viewer, tells it of every change, and hears from it.
import { useEffect, useRef } from "preact/hooks";
import { useStore } from "../parts/context";
import { EntityChip } from "../parts/entity-chip";
import { CrossingAlert } from "../pose/crossings";
import { Toolbar } from "./toolbar";
import { connect, foundNow } from "./viewer-link";
import { Warning } from "./warning";

export function ViewerPane() {
  const store = useStore();
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => (box.current ? connect(box.current, store) : undefined), [store]);
  const { large, viewer } = store.space;
  const before = useRef(large.value);
  useEffect(() => {
    if (before.current === large.value) return;
    before.current = large.value;
    requestAnimationFrame(() => viewer.peek()?.setView("fit")); // once it has its new size
  }, [large.value]);
  return (
    <section class={store.space.large.value ? "viewer-pane large" : "viewer-pane"} aria-label="Robot in 3D">
      <div class="scene">
        <div class="viewer" ref={box} data-testid="viewer" />
        <Warning pane={box} />
      </div>
      <Toolbar />
      <CrossingAlert />
      <Legend />
    </section>
  );
}

function Legend() {
  const store = useStore();
  const { study, space } = store;
  const shown = study.value;
  if (!shown) return null;
  const found = foundNow(store);
  const extra = space.overlay.value;
  const own = extra?.alone ? [] : shown.entities.filter(({ id }) => found === null || found.includes(id));
  return (
    <div class="legend" role="group" aria-label="Entities" tabIndex={0}>
      {own.length === 0 && "Drag to look around. Point at a joint, a leg or a bracket: it lights up everywhere."}
      {own.map((entity) => (
        <EntityChip key={entity.id} entity={entity} named={false} />
      ))}
    </div>
  );
}
