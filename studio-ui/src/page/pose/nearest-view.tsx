// The nearest singular poses: asked for once, then a button each that moves the platform there.
import { useComputed } from "@preact/signals";
import type { Nearest, Pose } from "../../protocol";
import { useStore } from "../parts/context";
import { FaultBox } from "../parts/fault-box";
import { short } from "../lib/format";
import { samePose } from "../state/doc";
import type { Seeking } from "../state/seeking";
import { Termed } from "../parts/term";

const KINDS = ["translation", "rotation", "combined"] as const;
const LABELS: Record<string, string> = { translation: "translation", rotation: "rotation", combined: "both" };

/** Whether what was found still holds: at the pose it was sought from, at what was found, and on the way between. */
export function isKnown(seeking: Seeking, pose: Pose, moves: boolean): boolean {
  if (seeking.state !== "found") return false;
  return moves || [seeking.asked.pose, ...seeking.result.found.map((one) => one.pose)].some((known) => samePose(known, pose));
}

export const lengthOf = ({ distance, unit }: Nearest["found"][number]): string =>
  `${short(distance, 3)}${unit === "deg" ? "°" : unit && ` ${unit}`}`;

/** How far the search is, with a way to stop. */
export function Seeks({ words, stop, testid = "nearest-stop" }: { words: string; stop(): void; testid?: string }) {
  return (
    <p class="busy" role="status">
      <span class="spinner" aria-hidden="true" /> {words} …
      <button type="button" class="quiet" onClick={stop} data-testid={testid}>
        Stop
      </button>
    </p>
  );
}

export function NearestView() {
  const { seeker, moving, pose$ } = useStore();
  const seeking = seeker.seeking.value;
  const known = useComputed(() => isKnown(seeker.seeking.value, pose$.value, moving.active.value)).value;
  const busy = seeking.state === "busy";
  const nearest = known && seeking.state === "found" ? seeking.result : null;
  const found = nearest?.found ?? [];

  async function toward(kind: string): Promise<void> {
    const ready = nearest ?? (await seeker.start());
    const target = ready?.found.find((one) => one.kind === kind);
    if (target) moving.to(target.pose);
  }

  return (
    <section class="nearest" aria-label="Nearest singular pose">
      <h3>
        <Termed text="Nearest singular pose by" />
      </h3>
      <div class="buttons">
        {KINDS.map((kind) => {
          const one = found.find((f) => f.kind === kind);
          const never = nearest !== null && !one;
          return (
            <button
              type="button"
              key={kind}
              disabled={busy || never}
              title={one?.text ?? (never ? "none was found" : undefined)}
              data-testid={`nearest-${kind}`}
              onClick={() => void toward(kind)}
            >
              <span>{LABELS[kind]}</span>
              <strong>{one ? lengthOf(one) : never ? "none" : "find"}</strong>
            </button>
          );
        })}
      </div>
      {busy && <Seeks words={seeking.words} stop={seeker.stop} />}
      {seeking.state === "failed" && <FaultBox fault={seeking.fault} />}
    </section>
  );
}
