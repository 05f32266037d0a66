// The report within a page of one's own: the file, and the lines that show it there.
import { useState } from "preact/hooks";
import type { Fault } from "../../../protocol";
import { download } from "../../lib/download";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { faultOf } from "../../state/studying";
import { keyOf, make } from "./making";

/** An inner page that runs its scripts and reaches nothing of the page around it. */
export const snippet = (file: string, title: string): string =>
  `<iframe src="${escaped(file)}" title="${escaped(title)}" width="100%" height="720" loading="lazy" sandbox="allow-scripts"></iframe>`;

const escaped = (text: string): string => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

export function Embed() {
  const store = useStore();
  const [made, show] = useState<{ key: string; text: string } | null>(null);
  const [busy, work] = useState(false);
  const [fault, tell] = useState<Fault | null>(null);
  const key = keyOf(store.doc.value);
  const text = made?.key === key ? made.text : null;

  async function get(): Promise<void> {
    work(true);
    tell(null);
    try {
      const page = await make(store, "embedded", new AbortController().signal, () => undefined);
      download(page);
      show({ key, text: snippet(page.name, store.study.peek()?.title ?? "Robot") });
    } catch (error) {
      tell(faultOf(error));
    }
    work(false);
  }

  function copy(): void {
    navigator.clipboard.writeText(text ?? "").then(
      () => store.front.tell("The lines are copied"),
      () => store.front.tell("The browser does not allow copying: select the lines and copy them"),
    );
  }

  return (
    <section class="take-link">
      <h3>Within a page of your own</h3>
      <p>The report at this pose, without answers, notes and link, to lie beside the page, and the line that shows it there.</p>
      <div class="line">
        <input
          type="text"
          class="mono"
          readOnly
          value={text ?? ""}
          placeholder="Save the report first"
          aria-label="Line for a page"
          onFocus={(event) => event.currentTarget.select()}
          data-testid="embed"
        />
        {text ? (
          <button type="button" class="primary" onClick={copy} data-testid="embed-copy">
            Copy
          </button>
        ) : (
          <button type="button" disabled={busy} onClick={() => void get()} data-testid="embed-make">
            {busy ? <span class="spinner" aria-hidden="true" /> : <Icon name="take-away" size={15} />} Save the report
          </button>
        )}
      </div>
      {fault && <FaultBox fault={fault} />}
    </section>
  );
}
