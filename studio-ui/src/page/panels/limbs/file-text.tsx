// The robot's file as text: what is typed is read at once, faults are marked where they are.
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState } from "@codemirror/state";
import { EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { effect, type ReadonlySignal } from "@preact/signals";
import { tags } from "@lezer/highlight";
import { useEffect, useRef } from "preact/hooks";
import type { Fault } from "../../../protocol";
import { marksOf } from "../bench/editor";

interface Props {
  text$: ReadonlySignal<string>;
  fault: Fault | null;
  onText(text: string): void;
}

export function FileText({ text$, fault, onText }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const call = useRef(onText);
  call.current = onText;

  useEffect(() => {
    if (!box.current) return undefined;
    const listens = EditorView.updateListener.of((update) => {
      if (update.docChanged) call.current(update.state.doc.toString());
    });
    const made = new EditorView({ state: EditorState.create({ doc: text$.peek(), extensions: [...EXTENSIONS, listens] }), parent: box.current });
    view.current = made;
    const follow = effect(() => {
      const text = text$.value;
      const { doc } = made.state;
      if (doc.toString() !== text) made.dispatch({ changes: { from: 0, to: doc.length, insert: text } });
    });
    return () => {
      follow();
      view.current = null;
      made.destroy();
    };
  }, [text$]);

  useEffect(() => {
    const editor = view.current;
    if (editor) editor.dispatch(setDiagnostics(editor.state, fault ? marksOf(fault, editor.state.doc.length) : []));
  }, [fault]);

  return <div class="bench-editor file-text" ref={box} data-testid="limb-text" />;
}

/** Keys, comments and what is driven. */
const yaml = StreamLanguage.define({
  token(stream) {
    if (stream.match(/#.*/)) return "comment";
    if (stream.match(/[A-Za-z][\w%']*(?=\s*:(\s|$))/)) return "keyword";
    if (stream.match(/(R|P|H|C|U|Pa)\*\d?(?=[:(])/)) return "strong";
    if (!stream.match(/[\w%'*]+/)) stream.next();
    return null;
  },
});

const LOOKS = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--accent)" },
  { tag: tags.comment, color: "var(--muted)" },
  { tag: tags.strong, color: "var(--entity2-text)", fontWeight: "600" },
]);

const EXTENSIONS = [
  lineNumbers(),
  lintGutter(),
  history(),
  highlightActiveLine(),
  EditorView.lineWrapping,
  EditorView.contentAttributes.of({ "aria-label": "Robot file", spellcheck: "false", autocapitalize: "off" }),
  yaml,
  syntaxHighlighting(LOOKS),
  keymap.of([...defaultKeymap, ...historyKeymap]),
];
