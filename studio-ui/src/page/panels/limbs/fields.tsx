// What is typed in the table: taken over at Enter and when the field is left; Escape brings back what was there.
import { useEffect, useState } from "preact/hooks";

interface Props {
  value: string;
  label: string;
  testid?: string;
  list?: string;
  class?: string;
  invalid?: boolean;
  placeholder?: string;
  size?: number;
  onTake(text: string): void;
  /** For numbers: the arrow keys, with the shift key by ten. */
  onStep?(by: number): void;
}

export function TextField({ value, label, testid, list, class: c, invalid = false, placeholder, size, onTake, onStep }: Props) {
  const [text, type] = useState<string | null>(null);
  useEffect(() => type(null), [value]);
  function take(): void {
    if (text === null) return;
    type(null);
    if (text.trim() !== value) onTake(text.trim());
  }
  return (
    <input
      type="text"
      class={c}
      aria-label={label}
      title={value.length > 9 ? value : undefined}
      aria-invalid={invalid}
      data-testid={testid}
      data-untouched={text === null}
      list={list}
      placeholder={placeholder}
      size={size}
      autocomplete="off"
      autocapitalize="off"
      spellcheck={false}
      value={text ?? value}
      onInput={(event) => type(event.currentTarget.value)}
      onBlur={take}
      onKeyDown={(event) => {
        if (event.key === "Enter") take();
        if (event.key === "Escape") type(null);
        const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (by === undefined || !onStep) return;
        event.preventDefault();
        type(null);
        onStep(event.shiftKey ? 10 * by : by);
      }}
    />
  );
}
