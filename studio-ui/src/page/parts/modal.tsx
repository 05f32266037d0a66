// A window over the page: it holds the focus, closes with Escape and with a press beside it, and gives the focus back.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

interface Props {
  label: string;
  class: string;
  testid: string;
  onClose(): void;
  children: ComponentChildren;
}

export function Modal({ label, class: name, testid, onClose, children }: Props) {
  const box = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    box.current?.showModal();
    return () => void (before instanceof HTMLElement && before.focus());
  }, []);
  return (
    <dialog
      ref={box}
      class={`modal ${name}`}
      aria-label={label}
      data-testid={testid}
      onCancel={(event) => (event.preventDefault(), onClose())}
      onMouseDown={(event) => event.target === box.current && (event.preventDefault(), onClose())}
    >
      {children}
    </dialog>
  );
}
