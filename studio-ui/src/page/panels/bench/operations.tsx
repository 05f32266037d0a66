// What can be asked of the statement under the cursor, and what can be declared.
import type { EditorView } from "@codemirror/view";
import type { BenchResult } from "../../../protocol";
import { askedAt, declare, DECLARATIONS, OPERATIONS, put, type Operation } from "./asking";

interface Props {
  view(): EditorView | null;
  results: readonly BenchResult[];
  /** Those of the robot that is open. */
  legs: string;
  say(words: string): void;
}

export function Operations({ view, results, legs, say }: Props) {
  function ask({ title, line }: Operation): void {
    const editor = view();
    if (!editor) return;
    const found = line(askedAt(editor, results, legs));
    if (found) put(editor, results, found);
    else say(title === "Transversals" || title === "Analyze" ? "Put the cursor on a superbracket [[Aa, Bb, …]], or open a robot on six legs." : `Put the cursor on an expression: ${title} works on the statement there.`);
  }
  return (
    <div class="bench-operations" role="toolbar" aria-label="Of the statement under the cursor">
      {OPERATIONS.map((one) => (
        <button type="button" key={one.id} title={one.words} onClick={() => ask(one)} data-testid={`bench-${one.id}`}>
          {one.title}
        </button>
      ))}
      <label>
        <span class="sr-only">Declare</span>
        <select
          value=""
          data-testid="bench-declare"
          onChange={(event) => {
            const chosen = DECLARATIONS.find(({ id }) => id === event.currentTarget.value);
            const editor = view();
            event.currentTarget.value = "";
            if (chosen && editor) declare(editor, chosen);
          }}
        >
          <option value="">Declare …</option>
          {DECLARATIONS.map(({ id, title }) => (
            <option key={id} value={id}>
              {id}: {title}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}
