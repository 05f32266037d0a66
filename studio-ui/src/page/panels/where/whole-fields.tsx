// What is asked of whole ranges: a map or a certificate, the ranges, margin and limits, of a certificate cones of joints and a tilt too.
import type { Axis, Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { NumberField } from "../../parts/number-field";
import { digitsOf } from "../../pose/axis-slider";
import type { Range } from "../../state/doc";
import { BOXES, type Whole } from "../../state/roaming";
import { rangeOf } from "../../state/touring";

const ANSWERS: readonly [Whole["kind"], string, string][] = [
  ["map", "Map", "Which part of the range is free"],
  ["certificate", "Certificate", "Whether the whole range is free, with a file that can be checked again"],
];

export function WholeFields({ study, ranges }: { study: Study; ranges: readonly (Range | null)[] }) {
  const { whole$ } = useStore().roaming;
  const whole = whole$.value;
  const set = (part: Partial<Whole>) => (whole$.value = { ...whole$.peek(), ...part });
  const names = study.wholes.map(({ name }) => name);
  const tilts = names.includes("roll") && names.includes("pitch");

  function change(name: string, range: Range | null): void {
    set({ ranges: { ...Object.fromEntries(names.map((n, i) => [n, ranges[i] ?? null])), [name]: range } });
  }

  return (
    <>
      <div class="segments" role="group" aria-label="What is asked">
        {ANSWERS.map(([kind, label, title]) => (
          <button key={kind} type="button" title={title} aria-pressed={kind === whole.kind} onClick={() => set({ kind })} data-testid={`whole-${kind}`}>
            {label}
          </button>
        ))}
      </div>
      <fieldset class="wholes">
        <legend class="label">over</legend>
        {study.wholes.map((axis, i) => (
          <WholeRow key={axis.name} axis={axis} range={ranges[i] ?? null} onChange={(range) => change(axis.name, range)} />
        ))}
      </fieldset>
      <div class="row">
        <label title="Free poses are to have at least this margin σ">
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
      <Words label="limits" example={study.kind === "platform" ? "leg lengths 300..600" : "actuators -30..30 deg"} name="limits" />
      {whole.kind === "certificate" && (
        <>
          <Words label="cones" example="40 deg, or base 30 deg, platform 40 deg" name="cone" title="Joints at the ends of rods keep to cones around the rods' directions at home, as the bodies there carry them" />
          {tilts && <Words label="tilt" example="25 deg" name="tilt" title="The platform tilts this far in any direction" />}
        </>
      )}
    </>
  );
}

interface WordsProps {
  label: string;
  example: string;
  name: "limits" | "cone" | "tilt";
  title?: string;
}

function Words({ label, example, name, title }: WordsProps) {
  const { whole$ } = useStore().roaming;
  return (
    <label class="row" title={title}>
      <span class="label">{label}</span>
      <input
        type="text"
        class="mono"
        spellcheck={false}
        placeholder={example}
        value={whole$.value[name]}
        data-testid={`boxes-${name}`}
        onInput={(event) => (whole$.value = { ...whole$.peek(), [name]: event.currentTarget.value.trim() })}
      />
    </label>
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
