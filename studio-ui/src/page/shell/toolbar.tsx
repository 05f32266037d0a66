// What the mouse does in 3D, standard views, and what is shown.
import { actionOf, titleOf } from "../actions/table";
import { LAYERS, MODES, VIEWS, isMovable, show } from "../actions/picture";
import { useStore } from "../parts/context";
import { useDismissed } from "../parts/dismissed";
import { Icon } from "../parts/icon";

export function Toolbar() {
  const store = useStore();
  const { space } = store;
  const layers = useDismissed();
  const movable = isMovable(store);
  const large = actionOf(store, "large");
  return (
    <div class="viewer-tools" role="toolbar" aria-label="View">
      <div class="segments" role="group" aria-label="Mouse">
        {MODES.map(([mode, label, icon]) => (
          <button
            type="button"
            key={mode}
            title={label}
            aria-label={label}
            aria-pressed={space.mode.value === mode}
            disabled={mode !== "orbit" && !movable}
            data-testid={`mode-${mode}`}
            onClick={() => (space.mode.value = mode)}
          >
            <Icon name={icon} size={16} />
          </button>
        ))}
      </div>
      <div class="segments views" role="group" aria-label="Standard views">
        {VIEWS.map(([view, label]) => (
          <button type="button" key={view} data-testid={`view-${view}`} onClick={() => space.viewer.value?.setView(view)}>
            {label}
          </button>
        ))}
      </div>
      <button
        type="button"
        class="large"
        title={titleOf(large)}
        aria-label={large.title}
        aria-pressed={space.large.value}
        data-testid="large"
        onClick={large.act}
      >
        <Icon name={space.large.value ? "close" : "large"} size={16} />
      </button>
      <details class="layers" ref={layers}>
        <summary aria-label="What is shown" title="What is shown" data-testid="layers">
          <Icon name="layers" size={16} />
        </summary>
        <fieldset>
          <legend>Show</legend>
          {LAYERS.map(([layer, label]) => (
            <label key={layer}>
              <input
                type="checkbox"
                checked={space.layers.value[layer]}
                data-testid={`layer-${layer}`}
                onChange={(event) => show(store, layer, event.currentTarget.checked)}
              />
              {label}
            </label>
          ))}
        </fieldset>
      </details>
    </div>
  );
}
