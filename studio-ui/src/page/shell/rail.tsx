// The panels by name.
import { panelsOf } from "../panels";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";

export function Rail() {
  const store = useStore();
  const { panel$, source$, go } = store;
  const [panel, source] = [panel$.value, source$.value];
  return (
    <nav class="rail" aria-label="Panels">
      {panelsOf(store).map(({ id, title, written, icon, needs }) => (
        <button
          type="button"
          key={id}
          aria-label={written && title}
          aria-current={id === panel ? "page" : undefined}
          disabled={needs === "study" && !source}
          data-testid={`panel-${id}`}
          onClick={() => go({ panel: id })}
        >
          <Icon name={icon} size={20} />
          <span>{written ?? title}</span>
        </button>
      ))}
    </nav>
  );
}
