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

/** A plain text with its terms; the sign that follows a term stays in its line. */
export function Termed({ text, seen }: { text: string; seen?: Set<string> }) {
  const pieces = inTerms(text, seen);
  const signOf = (at: number): string => (pieces[at - 1]?.entry && /^[^\p{L}\p{N}\s]+/u.exec(pieces[at]?.text ?? "")?.[0]) || "";
  return (
    <>
      {pieces.map(({ text: word, entry }, at) =>
        entry ? (
          <span class="term-and-sign">
            <Term name={entry.term}>{word}</Term>
            {signOf(at + 1)}
          </span>
        ) : (
          word.slice(signOf(at).length)
        ),
      )}
    </>
  );
}
