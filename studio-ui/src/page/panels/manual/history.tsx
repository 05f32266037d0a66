// What was proposed so far, and a line to type commands into.
import { useState } from "preact/hooks";
import type { Manual } from "../../../protocol";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { ANSWERS } from "./answer";
import type { Hand } from "./session";

const COMMANDS = "order, form, shortest, tetrahedron, plane, line, pair, lines, condition, auto, undo, redo";

export function HandHistory({ manual }: { manual: Manual }) {
  if (manual.history.length === 0) return null;
  return (
    <section class="hand-history">
      <h3>History</h3>
      <ol data-testid="manual-history">
        {manual.history.map(({ command, answer, words }, i) => (
          <li key={i} class={answer} title={words}>
            <Icon name={ANSWERS[answer].icon} size={14} />
            <code>{command}</code>
            <span>{ANSWERS[answer].title.toLowerCase()}</span>
          </li>
        ))}
      </ol>
    </section>
  );
}

export function CommandLine({ hand }: { hand: Hand }) {
  const [text, type] = useState("");
  const wrong = hand.fault.value;
  function enter(): void {
    const command = text.trim();
    if (command === "undo") hand.back();
    else if (command === "redo") hand.again();
    else if (command) hand.propose(command);
    type("");
  }
  return (
    <form
      class="command-line"
      onSubmit={(event) => {
        event.preventDefault();
        enter();
      }}
    >
      <label>
        <span>Or type a command</span>
        <input
          type="text"
          class="mono"
          value={text}
          placeholder="plane abc"
          spellcheck={false}
          autoComplete="off"
          title={COMMANDS}
          aria-describedby="commands"
          onInput={(event) => type(event.currentTarget.value)}
          data-testid="manual-command"
        />
      </label>
      <p id="commands" class="sr-only">
        {COMMANDS}
      </p>
      {wrong && <FaultBox fault={wrong.fault} text={wrong.command} />}
    </form>
  );
}
