// A picture of the server with the frame of its axes: where the pointer is in the frame, from 0 to 1 and upwards.
import type { ComponentChildren } from "preact";
import type { Frame } from "../../../protocol";

export type Spot = readonly [number, number];

interface Props {
  frame: Frame;
  picture: ComponentChildren;
  children?: ComponentChildren;
  testid: string;
  /** What the frame is for; it takes the keyboard then. */
  label?: string;
  onHover?(spot: Spot | null): void;
  onPress?(spot: Spot): void;
  onRelease?(): void;
  onKey?(event: KeyboardEvent): void;
}

export function Plot({ frame, picture, children, testid, label, onHover, onPress, onRelease, onKey }: Props) {
  const { left, right, top, bottom } = frame;
  const part = (size: number) => `${100 * size}%`;
  const style = { left: part(left), top: part(top), width: part(right - left), height: part(bottom - top) };

  function spot(event: PointerEvent): Spot {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const within = (x: number) => Math.min(Math.max(x, 0), 1);
    return [within((event.clientX - box.left) / box.width), within(1 - (event.clientY - box.top) / box.height)];
  }

  return (
    <div class="plot">
      {picture}
      <div
        class="frame"
        style={style}
        data-testid={testid}
        {...(label !== undefined && { tabIndex: 0, role: "application", "aria-label": label })}
        onKeyDown={onKey}
        onPointerDown={(event) => {
          if (event.button !== 0) return;
          event.currentTarget.setPointerCapture(event.pointerId);
          onPress?.(spot(event));
        }}
        onPointerMove={(event) => {
          if (!event.movementX && !event.movementY) return; // the page moved under a pointer that rests
          onHover?.(spot(event));
          if (event.buttons & 1) onPress?.(spot(event));
        }}
        onPointerUp={onRelease}
        onPointerLeave={() => onHover?.(null)}
      >
        {children}
      </div>
    </div>
  );
}
