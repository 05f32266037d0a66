// A robot with limbs: singular poses around the pose, by a search along the coordinates of its platform.
import { useComputed } from "@preact/signals";
import { useStore } from "../parts/context";
import { FaultBox } from "../parts/fault-box";
import { isKnown, lengthOf, Seeks } from "./nearest-view";
import { Termed } from "../parts/term";

export function SearchView() {
  const { seeker, moving, pose$ } = useStore();
  const seeking = seeker.seeking.value;
  const known = useComputed(() => isKnown(seeker.seeking.value, pose$.value, moving.active.value)).value;
  const busy = seeking.state === "busy";
  const nearest = known && seeking.state === "found" ? seeking.result : null;

  async function search(): Promise<void> {
    const [first] = (await seeker.start())?.found ?? [];
    if (first) moving.to(first.pose);
  }

  return (
    <section class="nearest" aria-label="Singular poses around">
      <h3>
        <Termed text="Singular poses around" />
      </h3>
      <div class="buttons">
        {!nearest && (
          <button
            type="button"
            disabled={busy}
            title="Searches along one coordinate of the platform at a time and moves to the closest singular pose that is found"
            data-testid="nearest-search"
            onClick={() => void search()}
          >
            <strong>Search</strong>
          </button>
        )}
        {nearest?.found.map((one) => (
          <button type="button" key={one.kind} title={one.text} data-testid="nearest-found" onClick={() => moving.to(one.pose)}>
            <span>{one.kind}</span>
            <strong>{lengthOf(one)}</strong>
          </button>
        ))}
        {nearest?.found.length === 0 && <strong data-testid="nearest-none">none found</strong>}
      </div>
      {nearest?.note && (
        <p class="tip" role="status" data-testid="nearest-note">
          {nearest.note}
        </p>
      )}
      {busy && <Seeks words={seeking.words} stop={seeker.stop} />}
      {seeking.state === "failed" && <FaultBox fault={seeking.fault} />}
    </section>
  );
}
