// The robot in 3D: makes the viewer, tells it of every change, and hears from it.
import { useEffect, useRef } from "preact/hooks";
import { useStore } from "../parts/context";
import { EntityChip } from "../parts/entity-chip";
import { Icon } from "../parts/icon";
import { CrossingAlert } from "../pose/crossings";
import { Toolbar } from "./toolbar";
import { connect, foundNow } from "./viewer-link";
import { Warning } from "./warning";

export function ViewerPane() {
  const store = useStore();
  const box = useRef<HTMLDivElement>(null);
  const paper = useRef<HTMLDivElement>(null);
  useEffect(() => (box.current ? connect(box.current, store) : undefined), [store]);
  const { large, viewer } = store.space;
  useEffect(() => {
    const draw = () => void (paper.current && (paper.current.innerHTML = viewer.peek()?.svg() ?? "")); // in the colours of paper by now
    addEventListener("beforeprint", draw);
    return () => removeEventListener("beforeprint", draw);
  }, [viewer]);
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
      <div class="paper" ref={paper} data-testid="paper" />
      <Toolbar />
      <CrossingAlert />
      <Legend />
    </section>
  );
}

/** The waypoint that is held in the picture, and what can be done with it. */
function ChosenWaypoint() {
  const { timeline, space, study } = useStore();
  const [index, count] = [timeline.chosen.value, timeline.stops.value.length];
  if (index === null || !timeline.given.value || !space.layers.value.way) return null;
  const last = index + 1 === count;
  const freedoms = study.value?.kind === "robot" ? study.value.freedoms.map(({ name }) => name) : [];
  const fault = timeline.fault.value;
  return (
    <span class="waypoint" role="group" aria-label={`Waypoint ${index + 1}`} data-testid="waypoint">
      <b>
        Waypoint {index + 1} of {count}
      </b>
      {fault ? (
        <span class="stays" role="status" title={fault.message} data-testid="waypoint-note">
          It stays: {fault.message}
        </span>
      ) : (
        freedoms.length > 0 && freedoms.length < 6 && <span data-testid="waypoint-note">goes in {listed(freedoms)} only</span>
      )}
      <button type="button" class="small" disabled={!timeline.proof.value} data-testid="waypoint-go" onClick={() => timeline.lead(index)}>
        Go there
      </button>
      <button type="button" class="small" title="The pose on show takes its place" data-testid="waypoint-put" onClick={() => timeline.put(index)}>
        Put here
      </button>
      <button
        type="button"
        class="small"
        title="One in the middle between this waypoint and the next"
        disabled={last || !timeline.proof.value}
        data-testid="waypoint-insert"
        onClick={() => (timeline.insert(index), timeline.done())}
      >
        One after it
      </button>
      <button type="button" class="small" data-testid="waypoint-remove" onClick={() => timeline.remove(index)}>
        Take it out
      </button>
      <button type="button" class="quiet tool" aria-label="Let the waypoint go" onClick={() => timeline.choose(null)}>
        <Icon name="close" size={14} />
      </button>
    </span>
  );
}

const listed = (names: readonly string[]): string => [names.slice(0, -1).join(", "), ...names.slice(-1)].filter(Boolean).join(" and ");

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
      <ChosenWaypoint />
      {own.length === 0 && store.timeline.chosen.value === null && "Drag to look around. Point at a joint, a leg or a bracket: it lights up everywhere."}
      {own.map((entity) => (
        <EntityChip key={entity.id} entity={entity} named={false} />
      ))}
    </div>
  );
}
