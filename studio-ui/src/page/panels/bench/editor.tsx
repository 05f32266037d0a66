// The editor: text, faults under the places they are at, and answers below the statements they belong to.
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { lintGutter } from "@codemirror/lint";
import { StateEffect, StateField, type Extension, type Range, type Transaction } from "@codemirror/state";
import { Decoration, EditorView, highlightActiveLine, keymap, lineNumbers, placeholder, WidgetType, type DecorationSet } from "@codemirror/view";
import { render, type ComponentChild } from "preact";
import type { ReadonlySignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import type { Fault } from "../../../protocol";
import { useTextEditor } from "../../parts/text-editor";
import { holds } from "./holding";
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

const EARLIER = "Of the text before it was changed";

class BelowWidget extends WidgetType {
  /** `earlier`: the text has changed since. */
  constructor(readonly key: string, readonly content: ComponentChild, readonly end: number, readonly earlier = false) {
    super();
  }
  override eq(other: BelowWidget): boolean {
    return other.key === this.key && other.end === this.end && other.earlier === this.earlier;
  }
  toDOM(): HTMLElement {
    const box = document.createElement("div");
    render(this.content, box);
    this.mark(box);
    return box;
  }
  override updateDOM(box: HTMLElement, _: EditorView, before: BelowWidget): boolean {
    if (before.key !== this.key) return false;
    this.mark(box);
    return true;
  }
  private mark(box: HTMLElement): void {
    box.classList.toggle("earlier", this.earlier);
    if (this.earlier) box.title = EARLIER;
    else box.removeAttribute("title");
  }
  override destroy(box: HTMLElement): void {
    render(null, box);
  }
}

const setBelow = StateEffect.define<readonly Below[]>();

/** What is no more true of the text is marked; the rest stays below its statement. */
function outdated(shown: DecorationSet, { changes, startState, state: { doc } }: Transaction): DecorationSet {
  const [before, now] = [startState.doc.toString(), doc.toString()];
  const found: Range<Decoration>[] = [];
  for (const cursor = shown.map(changes).iter(); cursor.value; cursor.next()) {
    const { key, content, end, earlier } = cursor.value.spec.widget as BelowWidget;
    if (earlier) found.push(cursor.value.range(cursor.from));
    else if (holds(end, before, now)) found.push(cursor.value.range(doc.lineAt(end).to));
    else found.push(below(new BelowWidget(key, content, end, true)).range(cursor.from));
  }
  return Decoration.set(found, true);
}

const below = (widget: BelowWidget): Decoration => Decoration.widget({ widget, block: true, side: 1 });

const belowField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(shown, change) {
    const set = change.effects.find((effect) => effect.is(setBelow));
    if (!set) return change.docChanged ? outdated(shown, change) : shown;
    const { doc } = change.state;
    const widgets = (set.value as readonly Below[]).map(({ end, key, content }) => {
      const at = doc.lineAt(Math.min(end, doc.length)).to;
      return below(new BelowWidget(key, content, end)).range(at);
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
