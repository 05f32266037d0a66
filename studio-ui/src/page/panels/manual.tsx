// Manual mode: the condition found by hand. What is proposed is confirmed or refused, with the reason.
import { useEffect, useMemo, useState } from "preact/hooks";
import { EntityChip } from "../parts/entity-chip";
import { FaultBox } from "../parts/fault-box";
import { Icon } from "../parts/icon";
import { PointName } from "../parts/point-name";
import { Schematic } from "../parts/drawing";
import { Answer } from "./manual/answer";
import { Board } from "./manual/board";
import { Ending, ProposeCondition } from "./manual/ending";
import { CommandLine, HandHistory } from "./manual/history";
import { ownEntities } from "./manual/proposals";
import { Proposing } from "./manual/proposing";
import { createHand, type Hand } from "./manual/session";
import type { PanelProps } from "./index";
import "./manual/manual.css";

export function ManualPanel({ store }: PanelProps) {
  const hand = useMemo(() => createHand(store), [store]);
  useEffect(() => {
    const { space } = store;
    const before = space.mode.peek();
    space.mode.value = "pick";
    return () => {
      hand.dispose();
      space.overlay.value = null;
      space.mode.value = before;
    };
  }, [store, hand]);

  const study = store.study.value;
  const manual = hand.manual.value;
  const entities = useMemo(() => (manual ? ownEntities(manual) : []), [manual]);
  if (!study) return null;
  return (
    <div class="manual">
      <header>
        <h2>By hand</h2>
        <p class="why">
          Find the condition yourself: pick points that belong together and propose what they make. Every proposal is confirmed, or
          refused with the reason.
        </p>
      </header>
      {!manual && !hand.fault.value && <p class="busy"><span class="spinner" aria-hidden="true" /> Setting up the board …</p>}
      {manual?.condition && <Ending condition={manual.condition} entities={entities} />}
      {manual && <Board manual={manual} entities={entities} hand={hand} />}
      {manual && !manual.condition && <Answer study={study} manual={manual} />}
      {manual && !manual.condition && <Proposing study={study} manual={manual} hand={hand} />}
      {!manual && hand.fault.value && <FaultBox fault={hand.fault.value.fault} />}
      {manual && (
        <dl class="bodies found" data-testid="manual-found">
          <dt>Found</dt>
          <dd class="chips">
            {entities.length === 0 && <span class="none">nothing yet</span>}
            {entities.map((entity) => (
              <EntityChip key={entity.id} entity={entity} starred />
            ))}
          </dd>
          <dt>Left over</dt>
          <dd class="math" data-testid="manual-left">
            {manual.left.length === 0 && <span class="none">none</span>}
            {manual.left.map((name, i) => (
              <PointName key={i} name={name} />
            ))}
          </dd>
        </dl>
      )}
      {manual && !manual.condition && <ProposeCondition hand={hand} />}
      {manual && <Moves hand={hand} />}
      {manual && !manual.condition && <CommandLine hand={hand} />}
      {study.schematic && (
        <details class="hand-schematic">
          <summary>Schematic</summary>
          <Schematic svg={study.schematic} />
        </details>
      )}
      {manual && <HandHistory manual={manual} />}
    </div>
  );
}

function Moves({ hand }: { hand: Hand }) {
  const [asked, ask] = useState(false);
  const manual = hand.manual.value;
  const hint = manual?.hint ?? null;
  useEffect(() => ask(false), [manual]);
  const open = manual !== null && manual.condition === null;
  return (
    <section class="moves" aria-label="Help and history">
      <div class="line">
        {open && (
          <button type="button" disabled={!hint} aria-expanded={asked} onClick={() => ask(!asked)} data-testid="manual-hint">
            Hint
          </button>
        )}
        {open && (
          <button type="button" onClick={() => hand.propose("auto")} data-testid="manual-auto">
            <Icon name="play" size={13} /> Do the rest
          </button>
        )}
        <span class="space" />
        <button type="button" class="quiet" disabled={!hand.canBack.value} onClick={hand.back} data-testid="manual-back">
          <Icon name="undo" size={15} /> Take back
        </button>
        <button type="button" class="quiet" disabled={!hand.canAgain.value} onClick={hand.again} data-testid="manual-again">
          <Icon name="redo" size={15} /> Again
        </button>
        <button
          type="button"
          class="quiet"
          disabled={!manual || manual.history.length === 0}
          onClick={hand.restart}
          data-testid="manual-restart"
        >
          Start over
        </button>
      </div>
      {hand.busy.value !== null && (
        <p class="busy" role="status" data-testid="manual-busy">
          <span class="spinner" aria-hidden="true" /> {hand.busy.value || "Working"} …
          <button type="button" class="quiet small" onClick={hand.stop}>
            Stop
          </button>
        </p>
      )}
      {asked && hint && (
        <p class="hinted" role="status" data-testid="manual-hinted">
          <code>{hint.command}</code>
          <span>{hint.words}</span>
          <button type="button" class="small" onClick={() => (hint.command === "undo" ? hand.back() : hand.propose(hint.command))}>
            Propose it
          </button>
        </p>
      )}
    </section>
  );
}
