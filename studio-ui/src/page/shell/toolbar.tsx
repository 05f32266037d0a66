// What the mouse does in 3D, standard views, and what is shown.
import type { Layer, Mode, View } from "../../viewer";
import { useStore } from "../parts/context";
import { useDismissed } from "../parts/dismissed";
import { Icon, type IconName } from "../parts/icon";

const MODES: readonly [Mode, string, IconName][] = [
  ["orbit", "Look around", "orbit"],
  ["translate", "Shift the platform", "translate"],
  ["rotate", "Turn the platform", "rotate"],
];
const VIEWS: readonly [View, string][] = [
  ["iso", "3D"],
  ["front", "Front"],
  ["side", "Side"],
  ["top", "Top"],
  ["fit", "Fit"],
];
const LAYERS: readonly [Layer, string][] = [
  ["entities", "Planes, lines, tetrahedra"],
  ["labels", "Labels"],
  ["legs", "Legs"],
  ["wrenches", "Joints and wrenches"],
  ["grid", "Ground grid"],
  ["motion", "Gained motion"],
];

export function Toolbar() {
  const { space, study } = useStore();
  const layers = useDismissed();
  const movable = study.value?.kind === "platform" && study.value.axes.length > 0;
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
        title="The picture alone (F)"
        aria-label="The picture alone"
        aria-pressed={space.large.value}
        data-testid="large"
        onClick={() => (space.large.value = !space.large.value)}
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
                onChange={(event) => (space.layers.value = { ...space.layers.value, [layer]: event.currentTarget.checked })}
              />
              {label}
            </label>
          ))}
        </fieldset>
      </details>
    </div>
  );
}
