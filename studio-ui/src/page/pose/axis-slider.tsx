// One freedom: a slider and a number that is typed, with the unit. Both send every change at once.
import { NumberField, plain } from "../parts/number-field";

interface Props {
  name: string;
  label: string;
  unit: string;
  value: number;
  low: number;
  high: number;
  step: number;
  testid: string;
  onChange(value: number): void;
  /** The hand has let go. */
  onDone(): void;
}

export function AxisSlider({ name, label, unit, value, low, high, step, testid, onChange, onDone }: Props) {
  const digits = digitsOf(step);
  const [least, most] = [Math.ceil(low / step) * step, Math.floor(high / step) * step]; // steps count from the least
  const share = (100 * (Math.min(Math.max(value, low), high) - low)) / (high - low || 1);
  const zero = (100 * (Math.min(Math.max(0, low), high) - low)) / (high - low || 1);
  const spoken = `${plain(value, digits)} ${unit === "°" || unit === "deg" ? "degrees" : unit}`;
  return (
    <div class="axis">
      <span class="name" aria-hidden="true" title={name.length > 2 ? name : undefined}>
        {name}
      </span>
      <input
        type="range"
        class="slider"
        min={least}
        max={most}
        step={step}
        value={value}
        aria-label={label}
        aria-valuetext={spoken}
        data-testid={testid}
        style={{ "--from": `${Math.min(zero, share)}%`, "--to": `${Math.max(zero, share)}%` }}
        onInput={(event) => onChange(Number(Number(event.currentTarget.value).toFixed(digits)))}
        onPointerUp={onDone}
        onBlur={onDone}
      />
      <NumberField
        value={value}
        step={step * 10}
        digits={digits}
        label={`${label}, typed`}
        testid={`${testid}-number`}
        onChange={onChange}
        onDone={onDone}
      />
      <span class="unit" aria-hidden="true">
        {unit === "deg" ? "°" : unit}
      </span>
    </div>
  );
}

export const digitsOf = (step: number): number => Math.min(Math.max(Math.ceil(-Math.log10(step) - 1e-9), 0), 6);
