// The editor: text, faults under the places they are at, and answers below the statements they belong to.
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState, StateEffect, StateField, type Extension } from "@codemirror/state";
import { Decoration, EditorView, highlightActiveLine, keymap, lineNumbers, placeholder, WidgetType, type DecorationSet } from "@codemirror/view";
import { render, type ComponentChild } from "preact";
import { effect, type ReadonlySignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Fault } from "../../../protocol";
import { gca } from "./language";

/** What stands below the line in which a statement ends. `key` tells whether it has changed. */
export interface Below {
  end: number;
  key: string;
  content: ComponentChild;
}

interface Props {
  /** Followed without delay: a late copy would undo what is being typed. */
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
  const box = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const calls = useRef({ onText, onRun, hold });
  calls.current = { onText, onRun, hold };

  useEffect(() => {
    if (!box.current) return undefined;
    const listens = EditorView.updateListener.of((update) => {
      if (update.docChanged) calls.current.onText(update.state.doc.toString());
    });
    const runs = keymap.of([{ key: "Mod-Enter", run: () => (calls.current.onRun(), true) }]);
    const state = EditorState.create({ doc: text$.peek(), extensions: [runs, ...help, ...EXTENSIONS, listens] });
    const made = new EditorView({ state, parent: box.current });
    view.current = made;
    calls.current.hold(made);
    const follow = effect(() => {
      const text = text$.value;
      const { doc } = made.state;
      if (doc.toString() !== text) made.dispatch({ changes: { from: 0, to: doc.length, insert: text } });
    });
    return () => {
      follow();
      view.current = null;
      calls.current.hold(null);
      made.destroy();
    };
  }, [text$, help]);

  useEffect(() => view.current?.dispatch({ effects: setBelow.of(below) }), [below]);

  useEffect(() => {
    const editor = view.current;
    if (editor) editor.dispatch(setDiagnostics(editor.state, fault ? marksOf(fault, editor.state.doc.length) : []));
  }, [fault]);

  return <div class="bench-editor" ref={box} data-testid="bench-editor" />;
}

/** A fault without extent marks the character before it. */
export function marksOf(fault: Fault, length: number) {
  return [fault, ...(fault.more ?? [])].flatMap(({ place, message, hint }) => {
    if (!place) return [];
    const to = Math.min(Math.max(place.end, place.start + 1), length);
    const from = Math.min(place.start, Math.max(to - 1, 0));
    return [{ from, to, severity: "error" as const, message: hint ? `${message}\n${hint}` : message }];
  });
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
