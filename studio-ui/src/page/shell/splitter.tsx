// A handle between two parts of the page: dragged, or moved with the arrow keys.
import type { Signal } from "@preact/signals";

interface Props {
  share: Signal<number>;
  direction: "across" | "down";
  label: string;
}

const [LEAST, MOST, STEP] = [0.25, 0.75, 0.02];
const within = (share: number): number => Math.min(Math.max(share, LEAST), MOST);

export function Splitter({ share, direction, label }: Props) {
  const across = direction === "across";

  function drag(event: PointerEvent & { currentTarget: HTMLElement }): void {
    const handle = event.currentTarget;
    const box = handle.parentElement?.getBoundingClientRect();
    if (!box) return;
    handle.setPointerCapture(event.pointerId);
    handle.onpointermove = ({ clientX, clientY }) =>
      (share.value = within(across ? (clientX - box.left) / box.width : (clientY - box.top) / box.height));
    handle.onpointerup = handle.onpointercancel = () => (handle.onpointermove = null);
  }

  function key(event: KeyboardEvent): void {
    const by = { ArrowLeft: -STEP, ArrowUp: -STEP, ArrowRight: STEP, ArrowDown: STEP }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    share.value = within(share.value + by);
  }

  return (
    <div
      class={`splitter ${direction}`}
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={across ? "vertical" : "horizontal"}
      aria-valuenow={Math.round(100 * share.value)}
      aria-valuemin={100 * LEAST}
      aria-valuemax={100 * MOST}
      onPointerDown={drag}
      onKeyDown={key}
      onDblClick={() => (share.value = 0.5)}
    />
  );
}
