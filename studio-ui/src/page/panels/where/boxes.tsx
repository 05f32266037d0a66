// Whole ranges of poses: how much of them is proved free of singular poses, how much is not, and the boxes as a picture.
import type { Axis, BoxesAnswer, Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { Icon } from "../../parts/icon";
import { NumberField } from "../../parts/number-field";
import { digitsOf } from "../../pose/axis-slider";
import { samePose, type Range } from "../../state/doc";
import { BOXES, wholeInWords, wholeOf, type Whole } from "../../state/roaming";
import { rangeOf } from "../../state/touring";
import { Question } from "./section";

export function BoxesSection({ study }: { study: Study }) {
  const { roaming, doc, pose$ } = useStore();
  const { boxes, whole$ } = roaming;
  const whole = whole$.value;
  const ranges = wholeOf(study, whole);
  const busy = boxes.now.value.state === "busy";
  const set = (part: Partial<Whole>) => (whole$.value = { ...whole$.peek(), ...part });

  function change(name: string, range: Range | null): void {
    set({ ranges: { ...Object.fromEntries(study.wholes.map((axis, i) => [axis.name, ranges[i] ?? null])), [name]: range } });
  }

  function ask(): void {
    const { source, pose } = doc.peek();
    const over = study.wholes.flatMap(({ unit }, i) => (ranges[i] ? [wholeInWords(ranges[i], unit)] : []));
    const { margin, limits, boxes: most } = whole;
    if (source) void boxes.start({ source, pose, over, margin, boxes: most, ...(limits && { limits }) });
  }

  return (
    <Question
      title="Whole ranges"
      why="Which part of all poses in these ranges is free of singular ones, proved; the other coordinates stay as they are."
      name="boxes"
      runner={boxes}
      fields={
        <>
          <fieldset class="wholes">
            <legend class="label">over</legend>
            {study.wholes.map((axis, i) => (
              <WholeRow key={axis.name} axis={axis} range={ranges[i] ?? null} onChange={(range) => change(axis.name, range)} />
            ))}
          </fieldset>
          <div class="row">
            <label title="Free poses are to have this margin σ at least">
              <span class="label">margin σ</span>
              <NumberField value={whole.margin} step={0.01} digits={2} label="margin" testid="boxes-margin" onChange={(margin) => set({ margin })} />
            </label>
            <label title="How many boxes are looked at, at most: more decide more, and take longer">
              <span class="label">boxes</span>
              <select value={whole.boxes} data-testid="boxes-most" onChange={(event) => set({ boxes: Number(event.currentTarget.value) })}>
                {BOXES.map((n) => (
                  <option key={n} value={n}>
                    up to {n.toLocaleString("en")}
                  </option>
                ))}
              </select>
            </label>
          </div>
          <label class="row">
            <span class="label">limits</span>
            <input
              type="text"
              class="mono"
              spellcheck={false}
              placeholder={study.kind === "platform" ? "leg lengths 300..600" : "actuators -30..30 deg"}
              value={whole.limits}
              data-testid="boxes-limits"
              onInput={(event) => set({ limits: event.currentTarget.value.trim() })}
            />
          </label>
        </>
      }
      ask={
        <button type="button" class="primary" disabled={busy || !ranges.some(Boolean)} onClick={ask} data-testid="boxes-go">
          <Icon name="where" size={14} /> Prove
        </button>
      }
    >
      {(result, asked) => (
        <>
          <Shares result={result} />
          {result.picture && (
            <div class="plot">
              <img src={`data:image/svg+xml;base64,${result.picture}`} alt={result.seen} data-testid="boxes-picture" />
            </div>
          )}
          {!samePose(asked.pose, pose$.value) && <p class="tip">The robot has moved since: the coordinates without a range are those of the pose that was asked about.</p>}
        </>
      )}
    </Question>
  );
}

interface RowProps {
  axis: Axis;
  range: Range | null;
  onChange(range: Range | null): void;
}

function WholeRow({ axis, range, onChange }: RowProps) {
  const { name, unit } = axis;
  const step = axis.step * 10;
  const digits = digitsOf(step);
  const end = (which: "low" | "high", word: string) =>
    range && <NumberField value={range[which]} step={step} digits={digits} label={`${name} ${word}`} testid={`boxes-${which}-${name}`} onChange={(value) => onChange({ ...range, [which]: value })} />;
  return (
    <div class="row">
      <label class="whole">
        <input
          type="checkbox"
          checked={range !== null}
          data-testid={`boxes-over-${name}`}
          onChange={(event) => onChange(event.currentTarget.checked ? rangeOf(axis) : null)}
        />
        {name}
      </label>
      {range && (
        <>
          {end("low", "from")}
          <span>to</span>
          {end("high", "to")}
          <span class="unit">{unit === "deg" ? "°" : unit}</span>
        </>
      )}
    </div>
  );
}

/** How much of the volume is what, as one bar and in words. */
function Shares({ result: { shares, decided, so_much } }: { result: BoxesAnswer }) {
  return (
    <div class="shares">
      <div class="volume" aria-hidden="true">
        {shares.map(({ kind, share }) => (
          <span key={kind} class={kind} style={{ width: `${100 * share}%` }} />
        ))}
      </div>
      <ul aria-label="Parts of the volume">
        {shares.map(({ kind, words }) => (
          <li key={kind} class={kind} data-testid="boxes-share" data-kind={kind}>
            {words}
          </li>
        ))}
      </ul>
      <p class="tip" data-testid="boxes-decided" data-decided={decided}>
        {so_much}
      </p>
    </div>
  );
}
