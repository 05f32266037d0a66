// What to begin with: a limb, a robot that comes with gcrules, the one that is open, or a file.
import { useRef } from "preact/hooks";
import { limbsAtHand } from "../../actions/limbs";
import { Icon } from "../../parts/icon";
import type { Store } from "../../state/store";
import type { Building } from "./editing";

interface Props {
  store: Store;
  building: Building;
  begun(): void;
}

const FIRST = ["space", "plane"] as const;
const OPEN = "open";

export function StartFrom({ store, building, begun }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const robots = store.gallery.value?.robots ?? [];
  const opened = limbsAtHand(store);

  function begin(id: string): void {
    begun();
    store.settle();
    const first = FIRST.find((one) => one === id);
    if (first) return void building.begin(first);
    if (id === OPEN) return void (opened && building.begin(opened));
    const robot = robots.find((one) => one.id === id);
    if (robot) void building.begin(robot.source);
  }

  async function take(file: File | undefined): Promise<void> {
    if (!file) return;
    begun();
    store.settle();
    const text = await file.text();
    const model = text.trimStart().startsWith("<"); // of links and joints: the server makes a robot file of it
    if (model) void building.begin({ kind: "file", text, name: file.name });
    else building.write(text);
  }

  return (
    <div class="start-from">
      <label>
        <span class="sr-only">Begin with</span>
        <select
          value=""
          data-testid="limbs-start"
          onChange={(event) => {
            begin(event.currentTarget.value);
            event.currentTarget.value = "";
          }}
        >
          <option value="">Begin with …</option>
          <option value="space">a single limb</option>
          <option value="plane">a single limb of a planar robot</option>
          {opened && <option value={OPEN}>the open robot: {store.study.value?.title}</option>}
          <optgroup label="Robots">
            {robots.map(({ id, title }) => (
              <option key={id} value={id}>
                {title}
              </option>
            ))}
          </optgroup>
        </select>
      </label>
      <button type="button" onClick={() => input.current?.click()} title="A robot file (YAML), or a model (URDF, SDF, MJCF)">
        <Icon name="file" size={15} /> Open a file
      </button>
      <input
        ref={input}
        type="file"
        accept=".yaml,.yml,.json,.urdf,.sdf,.mjcf,.xml"
        hidden
        data-testid="limbs-file"
        onChange={(event) => {
          void take(event.currentTarget.files?.[0]);
          event.currentTarget.value = "";
        }}
      />
    </div>
  );
}
