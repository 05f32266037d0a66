// The robot's file as text: what is typed is read at once, faults are marked where they are.
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { lintGutter } from "@codemirror/lint";
import { EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import type { ReadonlySignal } from "@preact/signals";
import { tags } from "@lezer/highlight";
import type { Fault } from "../../../protocol";
import { useTextEditor } from "../../parts/text-editor";

interface Props {
  text$: ReadonlySignal<string>;
  fault: Fault | null;
  onText(text: string): void;
}

export function FileText({ text$, fault, onText }: Props) {
  const { box } = useTextEditor({ text$, extensions: EXTENSIONS, fault, onText });
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
