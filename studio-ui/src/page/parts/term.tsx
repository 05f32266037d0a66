// A word whose meaning is shown when it is pointed at, has the focus, or is pressed.
import type { ComponentChildren } from "preact";
import { inTerms } from "../lib/terms";
import { useStore } from "./context";

export function Term({ name, children }: { name: string; children: ComponentChildren }) {
  const shown = useStore().front.term.value;
  return (
    <button type="button" class="term" data-term={name} aria-describedby={shown?.name === name ? "term-tip" : undefined}>
      {children}
    </button>
  );
}

/** A plain text with its terms. */
export function Termed({ text, seen }: { text: string; seen?: Set<string> }) {
  return <>{inTerms(text, seen).map(({ text: word, entry }) => (entry ? <Term name={entry.term}>{word}</Term> : word))}</>;
}
