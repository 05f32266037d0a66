// What the server says of the files of rules that are open, and of plugins: asked for anew where a file has changed.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import { MOST_RULE_FILES, LONGEST_RULES, type CheckedRuleFile, type Fault, type PluginsAnswer, type RuleFile } from "../../../protocol";
import type { Store } from "../../state/store";
import { faultOf } from "../../state/studying";

export type Checking = { state: "idle" } | { state: "busy"; words: string } | { state: "found"; files: readonly CheckedRuleFile[] } | { state: "failed"; fault: Fault };

export type Plugins = { state: "busy"; words: string } | { state: "found"; answer: PluginsAnswer } | { state: "failed"; fault: Fault };

export interface RuleChecks {
  now: ReadonlySignal<Checking>;
  /** null: not asked for yet. */
  plugins: ReadonlySignal<Plugins | null>;
  /** Takes a file in, or takes the place of the one with its name; a refusal in words, "" for none. */
  open(name: string, text: string): string;
  close(index: number): void;
  toggle(index: number, id: string, on: boolean): void;
  stop(): void;
  again(): void;
  askPlugins(): void;
  dispose(): void;
}

export function createRuleChecks({ client, rules$, edit, settle }: Store): RuleChecks {
  const now = signal<Checking>({ state: "idle" });
  const plugins = signal<Plugins | null>(null);
  const leaving = new AbortController();
  let asked = "";
  let running: AbortController | null = null;

  async function check(files: readonly RuleFile[]): Promise<void> {
    running?.abort();
    const mine = new AbortController();
    running = mine;
    if (files.length === 0) return void (now.value = { state: "idle" });
    const words = (text: string): void => void (running === mine && (now.value = { state: "busy", words: text }));
    words("checking the rules");
    try {
      const found = await client.ask("rules", { files: [...files] }, { channel: "rules", progress: words, signal: mine.signal });
      if (running === mine) now.value = { state: "found", files: found.files };
    } catch (error) {
      if (running === mine) now.value = { state: "failed", fault: faultOf(error) };
    }
  }

  const stopEffect = effect(() => {
    const files = rules$.value;
    const key = JSON.stringify(files);
    if (key === asked) return;
    asked = key;
    void check(files);
  });

  const change = (rules: readonly RuleFile[]): void => {
    settle();
    edit({ rules });
  };

  return {
    now,
    plugins,
    open(name, text) {
      const files = rules$.peek();
      if (text.length > LONGEST_RULES) return `${name} has more than ${LONGEST_RULES.toLocaleString("en")} characters.`;
      if (text.includes("\0")) return `${name} holds characters that are not text; it is not opened.`;
      const file: RuleFile = { name: name.slice(0, 200), text: text.replaceAll("\r\n", "\n"), off: [] };
      const others = files.filter((other) => other.name !== file.name);
      if (others.length >= MOST_RULE_FILES) return `At most ${MOST_RULE_FILES} files of rules and catalogs are open at a time.`;
      change(others.length < files.length ? files.map((other) => (other.name === file.name ? file : other)) : [...files, file]);
      return "";
    },
    close: (index) => change(rules$.peek().filter((_, i) => i !== index)),
    toggle: (index, id, on) =>
      change(rules$.peek().map((file, i) => (i === index ? { ...file, off: on ? file.off.filter((other) => other !== id) : [...file.off, id] } : file))),
    stop: () => running?.abort(),
    again: () => void check(rules$.peek()),
    askPlugins() {
      const before = plugins.peek()?.state;
      if (before === "busy" || before === "found") return;
      const words = (text: string): void => void (plugins.value = { state: "busy", words: text });
      words("checking the rules of plugins");
      client.ask("plugins", {}, { channel: "plugins", progress: words, signal: leaving.signal }).then(
        (answer) => (plugins.value = { state: "found", answer }),
        (error) => (plugins.value = { state: "failed", fault: faultOf(error) }),
      );
    },
    dispose() {
      stopEffect();
      running?.abort();
      leaving.abort();
    },
  };
}
