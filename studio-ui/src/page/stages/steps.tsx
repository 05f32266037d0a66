// The steps of a derivation: rule, reason, before and after.
import type { Item } from "../../protocol";
import { Formula } from "../parts/formula";

type Step = Extract<Item, { kind: "steps" }>["steps"][number];

export function Steps({ steps }: { steps: readonly Step[] }) {
  return (
    <ol class="derivation" data-testid="derivation">
      {steps.map(({ rule, why, before, after }, i) => (
        <li key={i}>
          <h3>{rule}</h3>
          <p>{why}</p>
          {before.length > 0 && i === 0 && <Formula right={before} />}
          {after.length > 0 && (
            <div class="after">
              <span aria-hidden="true">=</span>
              <Formula right={after} />
            </div>
          )}
        </li>
      ))}
    </ol>
  );
}
