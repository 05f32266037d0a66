// The form that the session works in: its monomials, and the choice of another form or order of the legs.
import { useEffect, useState } from "preact/hooks";
import type { Entity, Manual } from "../../../protocol";
import { MonomialTable } from "../../parts/monomial-table";
import type { Hand } from "./session";

interface Props {
  manual: Manual;
  entities: readonly Entity[];
  hand: Hand;
}

export function Board({ manual, entities, hand }: Props) {
  const { name, order, monomials } = manual.form;
  const last = manual.history.at(-1);
  const marked = last?.answer === "refused" ? last.monomial : null;
  const open = manual.condition === null;
  return (
    <section class="board" aria-label="Superbracket">
      <div class="line">
        <p data-testid="manual-form">
          <strong>{monomials.length}</strong> {monomials.length === 1 ? "monomial" : "monomials"}
          <span class="soft">
            {" "}
            · {name} · legs {order}
          </span>
        </p>
        <button type="button" class="small" disabled={!open} onClick={() => hand.propose("shortest")} data-testid="manual-shortest">
          Take the shortest
        </button>
      </div>
      <MonomialTable monomials={monomials} entities={entities} marked={marked} />
      {open && <Forms name={name} order={order} hand={hand} />}
    </section>
  );
}

function Forms({ name, order, hand }: { name: string; order: string; hand: Hand }) {
  const now = order.split(", ");
  const [draft, change] = useState(now);
  const [held, hold] = useState<number | null>(null);
  useEffect(() => {
    change(order.split(", "));
    hold(null);
  }, [order]);

  function press(at: number): void {
    if (held === null) return hold(at);
    hold(null);
    change(draft.map((word, i) => (i === at ? (draft[held] ?? word) : i === held ? (draft[at] ?? word) : word)));
  }

  return (
    <details class="forms">
      <summary data-testid="manual-forms">Choose the form and the order of the legs</summary>
      <p>
        Entities belong to one form of the superbracket; another one gives them up. Press two legs to exchange them.
      </p>
      <div class="line">
        <div class="segments" role="group" aria-label="Form">
          {["24", "16"].map((form) => (
            <button
              type="button"
              key={form}
              aria-pressed={name.startsWith(form)}
              onClick={() => hand.propose(`form ${form}`)}
              data-testid={`manual-form-${form}`}
            >
              {form} terms
            </button>
          ))}
        </div>
        <div class="segments" role="group" aria-label="Order of the legs">
          {draft.map((word, i) => (
            <button type="button" key={word} aria-pressed={held === i} onClick={() => press(i)} data-testid={`manual-leg-${i}`}>
              {word}
            </button>
          ))}
        </div>
        <button
          type="button"
          class="small"
          disabled={draft.join() === now.join()}
          onClick={() => hand.propose(`order ${draft.join(" ")}`)}
          data-testid="manual-order"
        >
          Use this order
        </button>
      </div>
    </details>
  );
}
