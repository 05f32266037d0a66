// What the drawing is: what it lacks, in words, or its condition, and the way to the study of it.
import { useEffect, useRef, useState } from "preact/hooks";
import type { Fault, Sketch, Source, Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { faultOf } from "../../state/studying";
import { idle, missing } from "./sketch";

const PAUSE = 500; // milliseconds of rest before a drawing is looked at

interface Known {
  sketch: Sketch;
  source: Source;
  study: Study;
}

export function Verdict({ sketch }: { sketch: Sketch }) {
  const { client, open } = useStore();
  const [known, know] = useState<Known | null>(null);
  const [fault, tell] = useState<Fault | null>(null);
  const latest = useRef(sketch);
  latest.current = sketch;
  const lacking = missing(sketch);
  const ready = lacking.length === 0;
  const current = known !== null && known.sketch === sketch;

  useEffect(() => {
    tell(null);
    if (!ready) return undefined;
    const stop = new AbortController();
    const timer = window.setTimeout(async () => {
      try {
        const { text } = await client.ask("compose", { drawing: sketch }, { signal: stop.signal });
        const source: Source = { kind: "file", text, name: "drawing.yaml" };
        const study = await client.ask("open", { source }, { channel: "drawing", signal: stop.signal });
        if (latest.current === sketch) know({ sketch, source, study });
      } catch (error) {
        const said = faultOf(error);
        if (latest.current === sketch && said.kind !== "cancelled" && said.kind !== "superseded") tell(said);
      }
    }, PAUSE);
    return () => {
      window.clearTimeout(timer);
      stop.abort();
    };
  }, [client, sketch, ready]);

  async function analyse(): Promise<void> {
    if (current && known) return open(known.source);
    try {
      const { text } = await client.ask("compose", { drawing: sketch });
      open({ kind: "file", text, name: "drawing.yaml" });
    } catch (error) {
      tell(faultOf(error));
    }
  }

  const loose = idle(sketch);
  return (
    <section class="draw-verdict" aria-live="polite">
      {lacking.map((words) => (
        <p key={words} class="lacking" data-testid="draw-missing">
          {words}
        </p>
      ))}
      {ready && fault && <FaultBox fault={fault} />}
      {ready && !fault && !known && (
        <p class="busy">
          <span class="spinner" aria-hidden="true" /> Six legs: looking for the condition …
        </p>
      )}
      {ready && !fault && known && (
        <div class={current ? "statement" : "statement old"} data-testid="draw-statement">
          <p class="over">{known.study.entry ? `Class ${known.study.entry.id}` : "Condition"}</p>
          <p>{known.study.condition.statement}</p>
        </div>
      )}
      {ready && loose.length > 0 && <p class="loose">Without legs, and left out: {loose.join(", ")}.</p>}
      <button type="button" class="primary" disabled={!ready} onClick={() => void analyse()} data-testid="draw-open">
        Analyse <Icon name="next" size={16} />
      </button>
    </section>
  );
}
