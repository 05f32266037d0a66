// One thing to take away: looked at, or downloaded.
import { useEffect, useRef, useState } from "preact/hooks";
import type { Fault } from "../../../protocol";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { faultOf } from "../../state/studying";
import { UNSEEN, type Offer } from "./formats";
import { download } from "../../lib/download";
import { ALWAYS_NEW, keyOf, make, sizeOf, type Made } from "./making";
import { Preview } from "./preview";

type State =
  | { state: "idle" }
  | { state: "busy"; words: string }
  | { state: "made"; key: string; made: Made }
  | { state: "failed"; fault: Fault };

export function OfferRow({ offer }: { offer: Offer }) {
  const { thing, title, badge, words } = offer;
  const store = useStore();
  const [now, set] = useState<State>({ state: "idle" });
  const [open, show] = useState(false);
  const stop = useRef<AbortController | null>(null);
  const key = keyOf(store.doc.value);
  const made = now.state === "made" && now.key === key ? now.made : null;
  useEffect(() => () => stop.current?.abort(), []);
  useEffect(() => show(false), [key]);

  async function get(): Promise<Made | null> {
    if (made && !ALWAYS_NEW.includes(thing)) return made;
    const mine = new AbortController();
    stop.current = mine;
    set({ state: "busy", words: "Making it" });
    try {
      const found = await make(store, thing, mine.signal, (said) => set({ state: "busy", words: said }));
      set({ state: "made", key, made: found });
      return found;
    } catch (error) {
      const fault = faultOf(error);
      set(fault.kind === "cancelled" ? { state: "idle" } : { state: "failed", fault });
      return null;
    }
  }

  async function take(): Promise<void> {
    const found = await get();
    if (found) download(found);
  }

  async function look(): Promise<void> {
    if (open) return show(false);
    if (await get()) show(true);
  }

  const busy = now.state === "busy";
  const label = `${title} (${badge})`;
  return (
    <li class="offer" data-testid={`offer-${thing}`}>
      <span class="badge" aria-hidden="true">
        {badge}
      </span>
      <div class="words">
        <h4>
          {title} {made && <span class="size">{sizeOf(made.blob.size)}</span>}
        </h4>
        <p>{words}</p>
      </div>
      <div class="acts">
        {busy && (
          <span class="busy" role="status" title={now.words}>
            <span class="spinner" aria-hidden="true" />
            <button type="button" class="quiet" onClick={() => stop.current?.abort()} data-testid={`stop-${thing}`}>
              Stop
            </button>
          </span>
        )}
        {!busy && !UNSEEN.includes(thing) && (
          <button type="button" class="quiet" aria-expanded={open} aria-label={`Preview: ${label}`} onClick={() => void look()} data-testid={`look-${thing}`}>
            {open ? "Hide" : "Preview"}
          </button>
        )}
        {!busy && (
          <button type="button" aria-label={`Download: ${label}`} onClick={() => void take()} data-testid={`take-${thing}`}>
            <Icon name="take-away" size={15} /> <span class="wide">Download</span>
          </button>
        )}
      </div>
      {now.state === "failed" && <FaultBox fault={now.fault} />}
      {open && made && <Preview thing={thing} made={made} />}
    </li>
  );
}
