// An editor of a text that is kept elsewhere: what is typed goes there, what changes there is shown, faults are marked.
import { setDiagnostics } from "@codemirror/lint";
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { effect, type ReadonlySignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Fault } from "../../protocol";

interface Edited {
  /** Followed without delay: a late copy would undo what is being typed. */
  text$: ReadonlySignal<string>;
  extensions: Extension;
  fault: Fault | null;
  onText(text: string): void;
}

/** The box of the editor, and the editor while it is there. */
export function useTextEditor({ text$, extensions, fault, onText }: Edited): { box: RefObject<HTMLDivElement | null>; view: { readonly current: EditorView | null } } {
  const box = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const call = useRef(onText);
  call.current = onText;

  useEffect(() => {
    if (!box.current) return undefined;
    const listens = EditorView.updateListener.of((update) => {
      if (update.docChanged) call.current(update.state.doc.toString());
    });
    const made = new EditorView({ state: EditorState.create({ doc: text$.peek(), extensions: [extensions, listens] }), parent: box.current });
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
  }, [text$, extensions]);

  useEffect(() => {
    const editor = view.current;
    if (editor) editor.dispatch(setDiagnostics(editor.state, fault ? marksOf(fault, editor.state.doc.length) : []));
  }, [fault]);

  return { box, view };
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
