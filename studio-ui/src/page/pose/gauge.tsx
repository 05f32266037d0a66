// The margin on a logarithmic scale, and the threshold ε below which the page warns: drag it, or type it.
import { useComputed } from "@preact/signals";
import { useState } from "preact/hooks";
import { THRESHOLD } from "../../protocol";
import { short } from "../lib/format";
import { along, degreesOf, LEAST } from "../lib/scale";
import { useStore } from "../parts/context";
import { Term } from "../parts/term";

const TICKS = [1e-4, 1e-3, 1e-2, 1e-1, 1];
const WORDS = ["0", "10⁻³", "0.01", "0.1", "1"];

export function Gauge() {
  const { posing, threshold$, edit, settle } = useStore();
  const threshold = threshold$.value;
  const sigma = posing.close.value;
  const [held, hold] = useState<number | null>(null); // where the mark is dragged, ahead of the server
  const width = useComputed(() => `width: ${100 * along(posing.headline.value?.margin ?? 0)}%`);
  const at = held ?? (sigma === null ? null : along(sigma));

  function drag(share: number): void {
    hold(share);
    const degrees = degreesOf(LEAST ** (1 - share));
    edit({ threshold: `${Number(degrees.toPrecision(2))} deg` }, "threshold");
  }

  function release(): void {
    hold(null);
    settle();
  }

  return (
    <div class="gauge">
      <div class="track">
        {at !== null && <span class="danger" style={{ width: `${100 * at}%` }} />}
        <span class="fill" style={width} />
        {at !== null && (
          <input
            type="range"
            class="epsilon"
            min={0.02}
            max={0.98}
            step={0.005}
            value={at}
            aria-label="Threshold of the warning"
            aria-valuetext={threshold}
            title={`Warns below ε: ${threshold}, σ = ${short(sigma ?? 0, 2)}`}
            data-testid="epsilon"
            onInput={(event) => drag(Number(event.currentTarget.value))}
            onPointerUp={release}
            onBlur={release}
          />
        )}
      </div>
      <div class="ticks" aria-hidden="true">
        {TICKS.map((tick, i) => (
          <span key={tick} style={{ left: `${100 * along(tick)}%` }}>
            {WORDS[i]}
          </span>
        ))}
      </div>
      <div class="threshold">
        <Term name="threshold">ε</Term>
        <input
          type="text"
          value={threshold}
          data-testid="threshold"
          aria-label="Threshold: an angle such as 0.5 deg, or a length"
          title="Closer than this is close: how far a leg may turn (0.5 deg), or how far the platform may shift (20 mm; slower)"
          onChange={(event) => edit({ threshold: event.currentTarget.value.trim() || THRESHOLD })}
        />
      </div>
    </div>
  );
}
