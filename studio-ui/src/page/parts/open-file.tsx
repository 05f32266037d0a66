// A button that opens a file of the user's; the same one can be opened again.
import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { Icon } from "./icon";

interface Props {
  /** Endings of names, as `accept` of an input has them. */
  accept: string;
  testid: string;
  children: ComponentChildren;
  title?: string;
  class?: string;
  /** Of the button; the input has `testid`. */
  buttonTestid?: string;
  size?: number;
  take(file: File): void;
}

export function OpenFile({ accept, testid, children, title, class: c, buttonTestid, size = 16, take }: Props) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <button type="button" class={c} title={title} data-testid={buttonTestid} onClick={() => input.current?.click()}>
        <Icon name="file" size={size} /> {children}
      </button>
      <input
        ref={input}
        type="file"
        accept={accept}
        hidden
        data-testid={testid}
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          if (file) take(file);
          event.currentTarget.value = "";
        }}
      />
    </>
  );
}

/** Platform files, robot files, and models. */
export const ROBOT_FILES = ".yaml,.yml,.json,.urdf,.sdf,.mjcf,.xml";
