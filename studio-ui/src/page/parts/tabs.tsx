// Tabs with the arrow keys, one of them in the order of the tab key.
import type { ComponentChildren } from "preact";

interface Tab<T extends string> {
  id: T;
  label: ComponentChildren;
  title?: string;
  testid?: string;
}

interface Props<T extends string> {
  name: string;
  tabs: readonly Tab<T>[];
  current: T;
  onChoose(id: T): void;
  vertical?: boolean;
  class?: string;
  /** id of the element that shows the chosen tab. */
  controls?: string;
}

export function Tabs<T extends string>({ name, tabs, current, onChoose, vertical = false, class: c, controls }: Props<T>) {
  const [back, on] = vertical ? ["ArrowUp", "ArrowDown"] : ["ArrowLeft", "ArrowRight"];

  function key(event: KeyboardEvent & { currentTarget: HTMLElement }): void {
    const here = tabs.findIndex(({ id }) => id === current);
    const to = { [back]: here - 1, [on]: here + 1, Home: 0, End: tabs.length - 1 }[event.key];
    const next = to === undefined ? undefined : tabs[(to + tabs.length) % tabs.length];
    if (!next) return;
    event.preventDefault();
    onChoose(next.id);
    const list = event.currentTarget;
    requestAnimationFrame(() => list.querySelector<HTMLElement>("[aria-selected=true]")?.focus());
  }

  return (
    <div
      class={c ?? "tabs"}
      role="tablist"
      aria-label={name}
      aria-orientation={vertical ? "vertical" : "horizontal"}
      onKeyDown={key}
    >
      {tabs.map(({ id, label, title, testid }) => (
        <button
          key={id}
          type="button"
          role="tab"
          aria-selected={id === current}
          aria-controls={controls}
          tabIndex={id === current ? 0 : -1}
          title={title}
          data-testid={testid}
          onClick={() => onChoose(id)}
        >
          {label}
        </button>
      ))}
    </div>
  );
}
