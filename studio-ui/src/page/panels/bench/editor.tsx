// The editor: text, faults under the places they are at, and answers below the statements they belong to.
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { lintGutter } from "@codemirror/lint";
import { StateEffect, StateField, type Extension } from "@codemirror/state";
import { Decoration, EditorView, highlightActiveLine, keymap, lineNumbers, placeholder, WidgetType, type DecorationSet } from "@codemirror/view";
import { render, type ComponentChild } from "preact";
import type { ReadonlySignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import type { Fault } from "../../../protocol";
import { useTextEditor } from "../../parts/text-editor";
import { gca } from "./language";

/** What stands below the line in which a statement ends. `key` tells whether it has changed. */
export interface Below {
  end: number;
  key: string;
  content: ComponentChild;
}

interface Props {
  text$: ReadonlySignal<string>;
  below: readonly Below[];
  fault: Fault | null;
  /** Completion, and help on words. */
  help: Extension[];
  onText(text: string): void;
  onRun(): void;
  /** The editor while it is there. */
  hold(view: EditorView | null): void;
}

class BelowWidget extends WidgetType {
  constructor(readonly key: string, readonly content: ComponentChild) {
    super();
  }
  override eq(other: BelowWidget): boolean {
    return other.key === this.key;
  }
  toDOM(): HTMLElement {
    const box = document.createElement("div");
    render(this.content, box);
    return box;
  }
  override destroy(box: HTMLElement): void {
    render(null, box);
  }
}

const setBelow = StateEffect.define<readonly Below[]>();

const belowField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(shown, change) {
    const set = change.effects.find((effect) => effect.is(setBelow));
    if (!set) return shown.map(change.changes);
    const { doc } = change.state;
    const widgets = (set.value as readonly Below[]).map(({ end, key, content }) => {
      const at = doc.lineAt(Math.min(end, doc.length)).to;
      return Decoration.widget({ widget: new BelowWidget(key, content), block: true, side: 1 }).range(at);
    });
    return Decoration.set(widgets, true);
  },
  provide: (field) => EditorView.decorations.from(field),
});

export function Editor({ text$, below, fault, help, onText, onRun, hold }: Props) {
  const run = useRef(onRun);
  run.current = onRun;
  const extensions = useMemo(() => [keymap.of([{ key: "Mod-Enter", run: () => (run.current(), true) }]), ...help, ...EXTENSIONS], [help]);
  const { box, view } = useTextEditor({ text$, extensions, fault, onText });

  useEffect(() => view.current?.dispatch({ effects: setBelow.of(below) }), [below]);
  useEffect(() => {
    hold(view.current);
    return () => hold(null);
  }, [help]);

  return <div class="bench-editor" ref={box} data-testid="bench-editor" />;
}

const EXTENSIONS: Extension[] = [
  lineNumbers(),
  lintGutter(),
  history(),
  bracketMatching(),
  highlightActiveLine(),
  EditorView.lineWrapping,
  EditorView.contentAttributes.of({ "aria-label": "Expressions", spellcheck: "false", autocapitalize: "off" }),
  placeholder("let p = ab /\\ cde"),
  gca,
  belowField,
  keymap.of([...defaultKeymap, ...historyKeymap]),
];
