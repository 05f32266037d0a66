// Six legs, typed: the schematic appears at once, or what is wrong.
import { useMemo, useRef, useState } from "preact/hooks";
import type { Fault, Study } from "../../protocol";
import { latest } from "../net/latest";
import { useStore } from "../parts/context";
import { Drawing } from "../parts/drawing";
import { FaultBox } from "../parts/fault-box";
import { Icon } from "../parts/icon";
import { faultOf } from "../state/studying";

const PAUSE = 350; // milliseconds of rest before a fault is told
const EXAMPLE = "ab af cb cd ed ef";

export function TypeLegs() {
  const { open, client, doc } = useStore();
  const source = doc.peek().source;
  const [legs, type] = useState(source?.kind === "legs" ? source.legs : "");
  const [study, show] = useState<Study | null>(null);
  const [fault, tell] = useState<Fault | null>(null);

  const timer = useRef(0);

  /** Not while the hand is still at a leg. */
  function tellLater(said: Fault | null): void {
    window.clearTimeout(timer.current);
    if (said) timer.current = window.setTimeout(() => tell(said), PAUSE);
    else tell(null);
  }

  const preview = useMemo(
    () =>
      latest(
        (text: string) => client.ask("open", { source: { kind: "legs", legs: text } }, { channel: "preview" }),
        (found) => {
          show(found);
          tellLater(null);
        },
        (error) => {
          const said = faultOf(error);
          if (said.kind !== "superseded") tellLater(said);
        },
      ),
    [client],
  );

  function typed(text: string): void {
    type(text);
    if (text.trim()) return preview(text);
    show(null);
    tellLater(null);
  }

  return (
    <form
      class="type-legs"
      onSubmit={(event) => {
        event.preventDefault();
        if (legs.trim() && !fault) open({ kind: "legs", legs: legs.trim() });
      }}
    >
      <label for="legs">Six legs, each by its two joints</label>
      <div class="line">
        <input
          id="legs"
          type="text"
          class="mono"
          value={legs}
          placeholder={EXAMPLE}
          autoComplete="off"
          spellcheck={false}
          aria-invalid={fault !== null}
          data-testid="legs"
          onInput={(event) => typed(event.currentTarget.value)}
        />
        <button type="submit" class="primary" disabled={!legs.trim() || fault !== null} data-testid="legs-open">
          Analyse <Icon name="next" size={16} />
        </button>
      </div>
      <div class="answer" aria-live="polite">
        {fault && legs.trim() && <FaultBox fault={fault} text={legs} />}
        {!fault && study && legs.trim() && (
          <div class="preview" data-testid="legs-preview">
            <Drawing svg={study.schematic} />
            <p>{study.condition.statement}</p>
          </div>
        )}
        {!legs.trim() && (
          <p class="hint">
            Joints that coincide share a letter: <code>ab af</code> meet in <code>a</code>.{" "}
            <button type="button" class="quiet" onClick={() => typed(EXAMPLE)}>
              Try {EXAMPLE}
            </button>
          </p>
        )}
      </div>
    </form>
  );
}
