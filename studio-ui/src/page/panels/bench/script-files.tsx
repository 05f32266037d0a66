// Scripts as files: opened into the bench, and saved so that `gcrules run` takes them.
import { Icon } from "../../parts/icon";
import { OpenFile } from "../../parts/open-file";
import { download } from "../../lib/download";
import type { Store } from "../../state/store";
import { faultOf } from "../../state/studying";

export function ScriptFiles({ store, say }: { store: Store; say(words: string): void }) {
  async function open(file: File): Promise<void> {
    const text = await file.text();
    if (text.length > 20_000) return say("The file has more than 20,000 characters.");
    store.settle();
    store.edit({ bench: text.replaceAll("\r\n", "\n") });
  }

  async function save(): Promise<void> {
    const source = store.study.peek() ? store.source$.peek() : null;
    try {
      const { text } = await store.client.ask("script", { text: store.bench$.peek(), ...(source && { source }) });
      download({ name: "bench.gca", blob: new Blob([text], { type: "text/plain" }) });
      say("Saved as bench.gca: expressions are shown, equations are claims, questions are comments.");
    } catch (error) {
      say(faultOf(error).message);
    }
  }

  return (
    <>
      <OpenFile accept=".gca,.txt" testid="bench-file" title="Open a script (.gca)" class="quiet" buttonTestid="bench-open" size={14} take={(file) => void open(file)}>
        Open
      </OpenFile>
      <button type="button" class="quiet" title="Save as a script (.gca)" disabled={!store.bench$.value.trim()} onClick={() => void save()} data-testid="bench-save">
        <Icon name="take-away" size={14} /> Save
      </button>
    </>
  );
}
