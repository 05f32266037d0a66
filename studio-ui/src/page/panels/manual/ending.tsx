// The condition: proposed of the entities or as an expression of one's own; once confirmed, set large.
import { useEffect, useState } from "preact/hooks";
import type { Condition, Entity } from "../../../protocol";
import { useStore } from "../../parts/context";
import { Formula } from "../../parts/formula";
import { Icon } from "../../parts/icon";
import { Prose } from "../../parts/prose";
import type { Hand } from "./session";

export function ProposeCondition({ hand }: { hand: Hand }) {
  const [expression, write] = useState("");
  const [cofactor, times] = useState("");
  const command = ["condition", expression.trim(), cofactor.trim() && expression.trim() ? `cofactor ${cofactor.trim()}` : ""];
  return (
    <form
      class="propose-condition"
      onSubmit={(event) => {
        event.preventDefault();
        hand.propose(command.filter(Boolean).join(" "));
      }}
    >
      <button type="submit" data-testid="manual-condition">
        Propose the condition
      </button>
      <details>
        <summary>as an expression of your own</summary>
        <div class="line">
          <input
            type="text"
            class="mono"
            placeholder="abc /\ bdf /\ cde /\ aef"
            aria-label="Expression of the condition"
            spellcheck={false}
            value={expression}
            onInput={(event) => write(event.currentTarget.value)}
            data-testid="manual-expression"
          />
          <input
            type="text"
            class="mono cofactor"
            placeholder="cofactor"
            aria-label="Cofactor"
            spellcheck={false}
            value={cofactor}
            onInput={(event) => times(event.currentTarget.value)}
          />
        </div>
      </details>
    </form>
  );
}

export function Ending({ condition, entities }: { condition: Condition; entities: readonly Entity[] }) {
  const { space } = useStore();
  useEffect(() => void (space.overlay.value = { entities: [...entities], alone: true }), [space, entities]);
  return (
    <section class="condition ending" data-testid="manual-confirmed">
      <blockquote class="sentence" data-testid="manual-statement">
        <Prose text={condition.statement} />
      </blockquote>
      <Formula left={condition.left} right={condition.right} display />
      <p class="certificate">
        <Icon name="ok" size={16} />
        <span>
          {condition.certificate.detail} <span class="tag">{condition.certificate.method}</span>
        </span>
      </p>
    </section>
  );
}
