// A drawing that is opened large at a click.
import { useRef } from "preact/hooks";
import { Drawing } from "./drawing";
import { Icon } from "./icon";

export function Zoom({ svg, label, testid }: { svg: string; label: string; testid: string }) {
  const dialog = useRef<HTMLDialogElement>(null);
  return (
    <figure class="figure">
      <button type="button" title="Enlarge" aria-label={`Enlarge: ${label}`} data-testid={testid} onClick={() => dialog.current?.showModal()}>
        <Drawing svg={svg} label={label} />
      </button>
      <figcaption>{label}</figcaption>
      <dialog ref={dialog} class="zoom" aria-label={label} onClick={() => dialog.current?.close()}>
        <button type="button" class="tool" aria-label="Close">
          <Icon name="close" />
        </button>
        <Drawing svg={svg} label={label} />
      </dialog>
    </figure>
  );
}
