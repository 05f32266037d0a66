// A map over two coordinates; the others stay as they are at the pose on show.
import { useEffect, useRef } from "preact/hooks";
import type { Axis, Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { NumberField } from "../../parts/number-field";
import { useSight } from "../../parts/sight";
import { digitsOf } from "../../pose/axis-slider";
import { Seeks } from "../../pose/nearest-view";
import { NODES, type Range } from "../../state/doc";
import { changed, inWords, measureOf, rangeOf, rangesOf, spoken } from "../../state/touring";
import { MapResult } from "./map-result";

const SOON = 400; // milliseconds after a change until the map follows

export function MapSection({ study }: { study: Study }) {
  const { touring, doc, tour$ } = useStore();
  const { map, change } = touring;
  const { nodes } = tour$.value;
  const ranges = rangesOf(study, tour$.value);
  const measure = measureOf(study, tour$.value);
  const now = map.now.value;
  const shown = map.shown.value;
  const sight = useSight(shown !== null);
  const words = (range: Range, n: number) =>
    inWords(range, study.ranges.find(({ name }) => name === range.name)?.unit ?? "", n);

  function go([across, upwards]: [Range, Range]): void {
    const { source, pose, threshold } = doc.peek();
    if (!source) return;
    void map.start((n) => ({ source, pose, threshold, over: [words(across, n), words(upwards, n)], measure }), nodes);
  }

  useEffect(() => map.stop, [map]); // nobody looks any more

  const wanted = JSON.stringify([ranges, measure, nodes]);
  const asked = useRef(wanted);
  useEffect(() => {
    if (asked.current === wanted || !ranges) return;
    asked.current = wanted;
    if (!map.shown.peek() && map.now.peek().state !== "busy") return;
    const soon = setTimeout(() => go(ranges), SOON);
    return () => clearTimeout(soon);
  }, [wanted]);

  if (!ranges) return null;
  return (
    <section class="map" aria-label="Map" ref={sight}>
      <h3>Over two coordinates</h3>
      <form
        class="ask"
        onSubmit={(event) => {
          event.preventDefault();
          go(ranges);
        }}
      >
        {([0, 1] as const).map((i) => (
          <RangeRow key={i} index={i} range={ranges[i]} axes={study.ranges} onChange={(range) => change({ over: changed(ranges, i, range) })} />
        ))}
        <div class="row">
          <label>
            <span class="label">shade</span>
            <select
              value={measure}
              title={study.measures.find(({ name }) => name === measure)?.meaning}
              data-testid="map-measure"
              onChange={(event) => change({ measure: event.currentTarget.value })}
            >
              {study.measures.map(({ name, meaning }) => (
                <option key={name} value={name} title={meaning}>
                  {spoken(name)}
                </option>
              ))}
            </select>
          </label>
          <label>
            <span class="label">poses</span>
            <select value={nodes} data-testid="map-nodes" onChange={(event) => change({ nodes: Number(event.currentTarget.value) })}>
              {NODES.map((n) => (
                <option key={n} value={n}>
                  {n} × {n}
                </option>
              ))}
            </select>
          </label>
          <button type="submit" class="primary" disabled={now.state === "busy"} data-testid="map-go">
            <Icon name="map" size={14} /> Map
          </button>
        </div>
      </form>
      {now.state === "busy" && <Seeks words={now.words} stop={map.stop} testid="map-stop" />}
      {now.state === "failed" && <FaultBox fault={now.fault} />}
      {shown && <MapResult asked={shown.asked} result={shown.result} measures={study.measures} again={() => go(ranges)} />}
    </section>
  );
}

interface RowProps {
  index: number;
  range: Range;
  axes: readonly Axis[];
  onChange(range: Range): void;
}

function RangeRow({ index, range, axes, onChange }: RowProps) {
  const axis = axes.find((one) => one.name === range.name);
  const step = (axis?.step ?? 0.01) * 10;
  const digits = digitsOf(step);
  const word = index === 0 ? "across" : "upwards";
  return (
    <div class="row">
      <span class="label">{word}</span>
      <select
        value={range.name}
        aria-label={`Coordinate ${word}`}
        data-testid={`map-axis-${index}`}
        onChange={(event) => {
          const chosen = axes.find((one) => one.name === event.currentTarget.value);
          if (chosen) onChange(rangeOf(chosen));
        }}
      >
        {axes.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
      <NumberField
        value={range.low}
        step={step}
        digits={digits}
        label={`${range.name} from`}
        testid={`map-low-${index}`}
        onChange={(low) => onChange({ ...range, low })}
      />
      <span>to</span>
      <NumberField
        value={range.high}
        step={step}
        digits={digits}
        label={`${range.name} to`}
        testid={`map-high-${index}`}
        onChange={(high) => onChange({ ...range, high })}
      />
      <span class="unit">{axis?.unit === "deg" ? "°" : axis?.unit}</span>
    </div>
  );
}
