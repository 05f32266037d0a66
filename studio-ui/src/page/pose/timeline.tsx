// The way that was driven or given: σ along it, every singular pose that the exact check finds, and the way led along.
import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import type { PathAnswer } from "../../protocol";
import { short } from "../lib/format";
import { along } from "../lib/scale";
import { useStore } from "../parts/context";
import { FaultBox } from "../parts/fault-box";
import { Icon } from "../parts/icon";
import { SPEEDS } from "../state/timeline";
import { LONGEST } from "../state/trail";
import { Crossings } from "./crossings";
import { Stops } from "./stops";

const [W, H] = [480, 120];
const y = (sigma: number): number => H - along(sigma) * (H - 4) - 2;
const place = (left: number, top: number) => ({ left: `${(100 * left) / W}%`, top: `${(100 * top) / H}%` });
const line = (points: readonly (readonly [number, number])[]): string =>
  points.map(([x, sigma], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y(sigma).toFixed(1)}`).join("");

export function Timeline() {
  const { timeline } = useStore();
  const proof = timeline.proof.value;
  return (
    <figure class="way" data-testid="way" data-length={useLength()} data-proved={proof !== null}>
      {proof ? <ProvedChart proof={proof} /> : <PassedChart />}
      <Player />
      <Stops />
      {timeline.fault.value && <FaultBox fault={timeline.fault.value} {...(timeline.tableRead.value && { text: timeline.tableRead.value })} />}
      {timeline.notes.value.map((note) => (
        <p key={note} class="tip" role="status" data-testid="way-note">
          {note}
        </p>
      ))}
      <State />
      {proof && <Crossings proof={proof} />}
    </figure>
  );
}

const useLength = (): number => useStore().posing.trail.value.length;

/** σ at the poses that were answered, until the way is proved. */
function PassedChart() {
  const { posing } = useStore();
  const way = posing.trail.value;
  const spread = Math.max(way.length - 1, Math.min(LONGEST, 30));
  const x = (i: number): number => (W * i) / spread;
  const last = way.at(-1);
  return (
    <Chart label={`margin over the last ${way.length} moves`} path={line(way.map(({ margin }, i) => [x(i), margin]))}>
      {last && <span class={`dot ${last.verdict}`} style={place(x(way.length - 1), y(last.margin))} />}
    </Chart>
  );
}

function ProvedChart({ proof }: { proof: PathAnswer }) {
  const { timeline } = useStore();
  const { samples, places, stretches, end } = proof;
  const x = (parameter: number): number => (W * parameter) / (end || 1);
  const at = timeline.at.value;
  const words = `margin along the way, ${places.length} singular ${places.length === 1 ? "pose" : "poses"}`;
  return (
    <Chart
      label={words}
      path={line(samples.map(({ parameter, margin }) => [x(parameter), margin]))}
      onPress={(share) => timeline.lead(share * end)}
    >
      {stretches.map((s, i) => (
        <span key={`s${i}`} class={s.singular ? "stretch singular" : "stretch"} style={{ left: `${(100 * s.start) / end}%`, width: `${(100 * (s.end - s.start)) / end}%` }} />
      ))}
      {Array.from({ length: Math.round(end) + 1 }, (_, k) => (
        <span key={`k${k}`} class="stop" style={{ left: `${(100 * k) / end}%` }} />
      ))}
      {places.map((p, i) => (
        <span key={i} class="crossing" data-testid="way-mark" style={{ left: `${(100 * p.parameter) / end}%` }} />
      ))}
      <span class="cursor" style={{ left: `${(100 * Math.min(at, end)) / end}%` }} />
    </Chart>
  );
}

interface ChartProps {
  label: string;
  path: string;
  children?: ComponentChildren;
  onPress?(share: number): void;
}

function Chart({ label, path, children, onPress }: ChartProps) {
  const { posing, settle } = useStore();
  const box = useRef<HTMLDivElement>(null);
  const epsilon = posing.close.value;
  function press(event: PointerEvent): void {
    if (!box.current || !onPress || !(event.buttons & 1)) return;
    const { left, width } = box.current.getBoundingClientRect();
    onPress(Math.min(Math.max((event.clientX - left) / width, 0), 1));
  }
  return (
    <div class="chart">
      {([1e-1, 1e-2, 1e-3] as const).map((tick, i) => (
        <span key={tick} class="scale" style={{ top: `${(100 * y(tick)) / H}%` }}>
          {["0.1", "0.01", "10⁻³"][i]}
        </span>
      ))}
      {epsilon !== null && (
        <span class="scale eps" style={{ top: `${(100 * y(epsilon)) / H}%` }}>
          ε
        </span>
      )}
      <div
        class="area"
        ref={box}
        data-testid="way-chart"
        onPointerDown={(event) => (event.currentTarget.setPointerCapture(event.pointerId), press(event))}
        onPointerMove={press}
        onPointerUp={settle}
      >
        <svg viewBox={`0 0 ${W} ${H}`} preserveAspectRatio="none" role="img" aria-label={label}>
          {[1e-3, 1e-2, 1e-1].map((tick) => (
            <line key={tick} class="grid" x1="0" x2={W} y1={y(tick)} y2={y(tick)} />
          ))}
          {epsilon !== null && <rect class="danger" x="0" width={W} y={y(epsilon)} height={H - y(epsilon)} />}
          {epsilon !== null && <line class="epsilon" x1="0" x2={W} y1={y(epsilon)} y2={y(epsilon)} />}
          <path class="line" d={path} />
        </svg>
        {children}
      </div>
    </div>
  );
}

/** Leads along the way: by hand, or by itself. */
function Player() {
  const { timeline, settle } = useStore();
  const { playing, loop, speed, at } = timeline;
  const proof = timeline.proof.value;
  const end = proof?.end ?? 0;
  const ready = proof !== null && proof.samples.some(({ pose }) => pose !== null);
  return (
    <div class="player">
      <button
        type="button"
        disabled={!ready}
        aria-pressed={playing.value}
        data-testid="way-play"
        onClick={() => (playing.value ? timeline.pause() : timeline.play())}
      >
        <Icon name={playing.value ? "pause" : "play"} size={14} /> {playing.value ? "Stop" : "Play"}
      </button>
      <input
        type="range"
        class="slider"
        min={0}
        max={end || 1}
        step="any"
        value={ready ? at.value : 0}
        disabled={!ready}
        aria-label="Place on the way"
        aria-valuetext={`parameter ${short(at.value, 3)} of ${short(end, 3)}`}
        data-testid="way-lead"
        style={{ "--from": "0%", "--to": `${ready ? (100 * at.value) / (end || 1) : 0}%` }}
        onInput={(event) => (timeline.pause(), timeline.lead(Number(event.currentTarget.value)))}
        onPointerUp={settle}
        onBlur={settle}
      />
      <label class="loop">
        <input type="checkbox" checked={loop.value} data-testid="way-loop" onChange={(event) => (loop.value = event.currentTarget.checked)} />
        loop
      </label>
      <select
        value={speed.value}
        aria-label="Speed"
        data-testid="way-speed"
        onChange={(event) => (speed.value = Number(event.currentTarget.value))}
      >
        {SPEEDS.map((one) => (
          <option key={one} value={one}>
            {one}×
          </option>
        ))}
      </select>
    </div>
  );
}

/** What is known of the way: whether it is free, proved, or what the check is at. */
function State() {
  const { timeline } = useStore();
  const [proof, check, stops] = [timeline.proof.value, timeline.check.value, timeline.stops.value];
  if (stops.length < 2) return <p class="tip">Move the robot: the way that it goes is checked for singular poses, all along.</p>;
  if (proof) return null; // the list of crossings says it
  if (check.state === "failed") return <FaultBox fault={check.fault} />;
  return (
    <p class="busy" role="status">
      <span class="spinner" aria-hidden="true" /> {check.state === "busy" ? check.words : "Proving the way"} …
    </p>
  );
}
