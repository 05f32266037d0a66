// The faults of a row, under it: what is wrong, what to do, and names that can be defined at once.
import type { Fault, SheetEdit, Undefined } from "../../../protocol";

interface Props {
  faults: readonly Fault[];
  undefined?: readonly Undefined[];
  change?(edit: SheetEdit): void;
}

export function RowFaults({ faults, undefined: missing = [], change }: Props) {
  if (faults.length === 0) return null;
  return (
    <ul class="row-faults" data-testid="row-faults">
      {faults.map(({ message, hint }) => (
        <li key={message}>
          <span class="message">{message}</span>
          {hint && <span class="hint"> {hint}</span>}
        </li>
      ))}
      {change &&
        missing.map(({ name, sort }) => (
          <li key={name}>
            <button type="button" onClick={() => change({ do: "name add", name, text: sort })} data-testid={`define-${name}`}>
              Make {name} a free {sort}
            </button>
          </li>
        ))}
    </ul>
  );
}
