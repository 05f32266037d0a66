// The lines that repeat what the page shows, for the shell and for Python, to copy.
import { useEffect, useState } from "preact/hooks";
import type { Fault, Repeated } from "../../protocol";
import { useStore } from "../parts/context";
import { FaultBox } from "../parts/fault-box";
import { Icon } from "../parts/icon";
import { LineToCopy } from "../parts/line-to-copy";
import { Modal } from "../parts/modal";
import { repeatables, type Repeatable } from "../state/repeating";
import { faultOf } from "../state/studying";

const LANGUAGES = [
  ["shell", "Shell"],
  ["python", "Python"],
] as const;
type Language = (typeof LANGUAGES)[number][0];

export function Repeat({ onClose }: { onClose(): void }) {
  const store = useStore();
  const [language, speak] = useState<Language>("shell");
  const all = repeatables(store);
  return (
    <Modal label="Repeat it" class="repeat" testid="repeat-lines" onClose={onClose}>
      <header>
        <h2>Repeat it</h2>
        <div class="segments" role="group" aria-label="Language">
          {LANGUAGES.map(([id, title]) => (
            <button type="button" key={id} aria-pressed={language === id} onClick={() => speak(id)} data-testid={`repeat-${id}`}>
              {title}
            </button>
          ))}
        </div>
        <button type="button" class="tool" aria-label="Close" title="Close" onClick={onClose} data-testid="repeat-close">
          <Icon name="close" />
        </button>
      </header>
      <div class="lines">
        {all.map((one) => (
          <Lines key={`${one.title}${JSON.stringify(one.args)}`} one={one} language={language} />
        ))}
        {all.length === 0 && <p class="none">Nothing is open that could be repeated.</p>}
      </div>
    </Modal>
  );
}

function Lines({ one, language }: { one: Repeatable; language: Language }) {
  const { client, source$, study } = useStore();
  const [found, show] = useState<Repeated | null>(null);
  const [fault, tell] = useState<Fault | null>(null);
  useEffect(() => {
    const source = study.peek() ? source$.peek() : null;
    client.ask("repeat", { what: one.what, args: one.args, ...(source && { source }) }).then(show, (error) => tell(faultOf(error)));
  }, []);
  const text = found?.[language];
  return (
    <section data-testid={`repeat-of-${one.what}`}>
      <h3>{one.title}</h3>
      {fault && <FaultBox fault={fault} />}
      {!found && !fault && <span class="spinner" role="status" aria-label="Writing the lines" />}
      {found && !text && <p class="none">The prompt takes it; no function of Python does.</p>}
      {text && <LineToCopy title={one.title} language={language} text={text} files={found?.files ?? []} name={one.what} />}
    </section>
  );
}
