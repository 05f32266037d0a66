// Help while typing: what may stand at the cursor, as the prompt completes it, and what a word means.
import { autocompletion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import type { Extension } from "@codemirror/state";
import { hoverTooltip } from "@codemirror/view";
import { BENCH_WORDS } from "../../../protocol";
import type { Store } from "../../state/store";

const WORD = /[:\\]?[A-Za-z][\w']*$/;

export function helping({ client, source$, study }: Store): Extension[] {
  async function complete(context: CompletionContext): Promise<CompletionResult | null> {
    const before = context.matchBefore(WORD);
    if (!context.explicit && (!before || before.text.length < 2)) return null;
    const source = study.peek() ? source$.peek() : null;
    try {
      const text = context.state.sliceDoc(0, context.pos);
      const { options } = await client.ask("complete", { text, ...(source && { source }) }, { channel: "complete" });
      const [first] = options;
      if (!first || context.aborted) return null;
      return {
        from: context.pos - first.length,
        options: options.filter(({ length }) => length === first.length).map(({ text: label, help }) => ({ label, detail: help })),
        filter: false,
      };
    } catch {
      return null; // nothing is offered
    }
  }

  const meaning = hoverTooltip((view, at) => {
    const line = view.state.doc.lineAt(at);
    for (const found of line.text.matchAll(/:?[a-z_]+/g)) {
      const [from, to] = [line.from + found.index, line.from + found.index + found[0].length];
      const word = BENCH_WORDS.find(([name]) => name === found[0]);
      if (at < from || at > to || !word) continue;
      const [, usage, help] = word;
      return { pos: from, end: to, above: true, create: () => ({ dom: tip(usage, help) }) };
    }
    return null;
  });

  return [autocompletion({ override: [complete], icons: false }), meaning];
}

function tip(usage: string, help: string): HTMLElement {
  const box = document.createElement("div");
  box.className = "bench-tip";
  const code = document.createElement("code");
  code.textContent = usage;
  const words = document.createElement("p");
  words.textContent = help;
  box.append(code, words);
  return box;
}
