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

/** What some legs are, or what is wrong with them. */
interface Found {
  legs: string;
  study: Study | null;
  fault: Fault | null;
}

export function TypeLegs() {
  const { open, client, doc } = useStore();
  const source = doc.peek().source;
  const [legs, type] = useState(source?.kind === "legs" ? source.legs : "");
  const [found, show] = useState<Found | null>(null);
  const timer = useRef(0);
  const answer = found?.legs === legs ? found : null;

  /** A fault not while the hand is still at a leg. */
  function arrived(now: Found): void {
    window.clearTimeout(timer.current);
    if (now.fault) timer.current = window.setTimeout(() => show(now), PAUSE);
    else show(now);
  }

  const preview = useMemo(
    () =>
      latest(
        (text: string) => client.ask("open", { source: { kind: "legs", legs: text } }, { channel: "preview" }),
        (study, text) => arrived({ legs: text, study, fault: null }),
        (error, text) => {
          const fault = faultOf(error);
          if (fault.kind !== "superseded") arrived({ legs: text, study: null, fault });
        },
      ),
    [client],
  );

  function typed(text: string): void {
    type(text);
    window.clearTimeout(timer.current);
    if (text.trim()) preview(text);
    else show(null);
  }

  return (
    <form
      class="type-legs"
      onSubmit={(event) => {
        event.preventDefault();
        if (legs.trim() && !answer?.fault) open({ kind: "legs", legs: legs.trim() });
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
          aria-invalid={!!answer?.fault}
          data-testid="legs"
          onInput={(event) => typed(event.currentTarget.value)}
        />
        <button type="submit" class="primary" disabled={!legs.trim() || !!answer?.fault} data-testid="legs-open">
          Analyse <Icon name="next" size={16} />
        </button>
      </div>
      <div class="answer" aria-live="polite">
        {found && legs.trim() && (
          <div class={answer ? "" : "earlier"}>
            {found.fault && <FaultBox fault={found.fault} text={found.legs} />}
            {found.study && (
              <div class="preview" data-testid="legs-preview">
                <Drawing svg={found.study.schematic} />
                <p>
                  {!answer && (
                    <>
                      Of <code>{found.legs}</code>:{" "}
                    </>
                  )}
                  {found.study.condition.statement}
                </p>
              </div>
            )}
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
