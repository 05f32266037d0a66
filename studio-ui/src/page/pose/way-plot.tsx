// The margin along the way that the platform has gone, on the scale of the gauge, with the line of the threshold.
import { along } from "../lib/scale";
import { useStore } from "../parts/context";
import { LONGEST, type Passed } from "../state/trail";

const [W, H] = [480, 120];
const y = (sigma: number): number => H - along(sigma) * (H - 4) - 2;

export function WayPlot() {
  const { posing, moving, settle } = useStore();
  const way = posing.trail.value;
  const epsilon = posing.close.value;
  const spread = Math.max(way.length - 1, Math.min(LONGEST, 30));
  const x = (i: number): number => (W * i) / spread;
  const last = way.at(-1);
  const path = way.map(({ margin }, i) => `${i ? "L" : "M"}${x(i).toFixed(1)} ${y(margin).toFixed(1)}`).join("");
  const lowest = way.reduce<Passed | undefined>((a, b) => (a && a.margin <= b.margin ? a : b), undefined);
  return (
    <figure class="way" data-testid="way" data-length={way.length}>
      <div class="chart">
      <svg viewBox={`0 0 ${W} ${H}`} preserveAspectRatio="none" role="img" aria-label={`margin over the last ${way.length} moves`}>
        {[1e-3, 1e-2, 1e-1].map((tick) => (
          <line key={tick} class="grid" x1="0" x2={W} y1={y(tick)} y2={y(tick)} />
        ))}
        {epsilon !== null && <rect class="danger" x="0" width={W} y={y(epsilon)} height={H - y(epsilon)} />}
        {epsilon !== null && <line class="epsilon" x1="0" x2={W} y1={y(epsilon)} y2={y(epsilon)} />}
        <path class="line" d={path} />
      </svg>
      {last && <span class={`dot ${last.verdict}`} style={place(x(way.length - 1), y(last.margin))} />}
      <span class="scale" style={place(0, y(1e-1))}>0.1</span>
      <span class="scale" style={place(0, y(1e-2))}>0.01</span>
      <span class="scale" style={place(0, y(1e-3))}>10⁻³</span>
      {epsilon !== null && <span class="scale eps" style={place(W, y(epsilon))}>ε</span>}
      </div>
      <figcaption>
        σ over the last {way.length} {way.length === 1 ? "pose" : "poses"}
        <span>
          <button
            type="button"
            class="quiet"
            disabled={!lowest || way.length < 2}
            onClick={() => lowest && moving.to(lowest.pose)}
            title="Back to the pose of least margin on this way"
          >
            To the lowest
          </button>
          <button type="button" class="quiet" disabled={way.length < 2} onClick={() => (settle(), posing.forget())}>
            Clear
          </button>
        </span>
      </figcaption>
    </figure>
  );
}

const place = (left: number, top: number) => ({ left: `${(100 * left) / W}%`, top: `${(100 * top) / H}%` });
