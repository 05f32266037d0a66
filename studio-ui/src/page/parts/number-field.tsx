// A number that is typed: taken over at Enter and when the field is left; the arrow keys change it by a step.
import { useRef, useState } from "preact/hooks";

interface Props {
  value: number;
  step: number;
  label: string;
  digits: number;
  testid?: string;
  onChange(value: number): void;
  onDone?(): void;
}

export function NumberField({ value, step, label, digits, testid, onChange, onDone }: Props) {
  const [text, setText] = useState<string | null>(null);
  const field = useRef<HTMLInputElement>(null);
  const shown = text ?? fitting(value, digits);

  function take(typed: string): void {
    setText(null);
    const found = readNumber(typed);
    const far = found !== null && Math.abs(found) > FARTHEST;
    if (found !== null && !far && found !== value) onChange(found);
    else if (field.current) field.current.value = fitting(value, digits);
    if (far) refuse();
    onDone?.();
  }

  /** Says so at the field, until something is typed. */
  function refuse(): void {
    field.current?.setCustomValidity(TOO_LARGE);
    field.current?.reportValidity();
  }

  function key(event: KeyboardEvent): void {
    const by = { ArrowUp: step, ArrowDown: -step, PageUp: 10 * step, PageDown: -10 * step }[event.key];
    if (event.key === "Enter") return take(event.currentTarget instanceof HTMLInputElement ? event.currentTarget.value : "");
    if (event.key === "Escape") return setText(null);
    if (by === undefined) return;
    event.preventDefault();
    setText(null);
    const next = Number((value + by).toPrecision(12));
    if (Math.abs(next) <= FARTHEST) onChange(next);
  }

  return (
    <input
      ref={field}
      class="number"
      type="text"
      inputMode="decimal"
      aria-label={label}
      aria-invalid={text !== null && readNumber(text) === null}
      data-testid={testid}
      value={shown}
      onInput={(event) => {
        event.currentTarget.setCustomValidity("");
        setText(event.currentTarget.value);
      }}
      onBlur={(event) => (text === null ? onDone?.() : take(event.currentTarget.value))}
      onFocus={(event) => event.currentTarget.select()}
      onKeyDown={key}
    />
  );
}

/** The largest number that poses are computed for, as the protocol has it. */
export const FARTHEST = 1e12;
const TOO_LARGE = "This number is too large: numbers go up to 1 000 000 000 000, either way. The one before was kept.";

const DECIMAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** Reads 1.5, −2, 1e-3, 1,5 and 1/3; null if it is no number. */
export function readNumber(text: string): number | null {
  const plainText = text.trim().replace("−", "-").replace(/^([+-]?\d+),(\d+)$/, "$1.$2");
  const fraction = /^([+-]?\d+)\/(\d+)$/.exec(plainText);
  const number = fraction ? Number(fraction[1]) / Number(fraction[2]) : DECIMAL.test(plainText) ? Number(plainText) : NaN;
  return Number.isFinite(number) ? number : null;
}

/** With up to two digits more where the number has them. */
export function fitting(value: number, digits: number): string {
  const exact = [digits, digits + 1].find((d) => Math.abs(Number(value.toFixed(d)) - value) < 1e-9);
  return plain(value, exact ?? digits + 2);
}

export const plain = (value: number, digits: number): string => {
  const rounded = value.toFixed(digits);
  return Number(rounded) === 0 ? (0).toFixed(digits) : rounded.replace("-", "−");
};
