// What the legs reach, as the file writes it.
import { useState } from "preact/hooks";
import { useStore } from "../../parts/context";

export function Limits() {
  const { study, resizing } = useStore();
  const [text, type] = useState<string | null>(null);
  const given = study.value?.limits ?? "";
  const unit = study.value?.unit ? ` ${study.value.unit}` : "";
  const [what, example] = study.value?.kind === "robot" ? ["actuators, from home", "q1 -30..30 deg"] : ["legs", `300..600${unit}`];
  function take(): void {
    if (text !== null && text.trim() !== given) {
      resizing.limit(text.trim());
      resizing.done();
    }
    type(null);
  }
  return (
    <label class="limits-field">
      Limits of the {what}
      <input
        type="text"
        value={text ?? given}
        placeholder={`none, or: ${example}`}
        autocomplete="off"
        spellcheck={false}
        data-testid="dimension-limits"
        onInput={(event) => type(event.currentTarget.value)}
        onBlur={take}
        onKeyDown={(event) => {
          if (event.key === "Enter") take();
          if (event.key === "Escape") type(null);
        }}
      />
    </label>
  );
}
