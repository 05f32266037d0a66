// What to begin with: a limb, a robot that comes with gcrules, the one that is open, or a file.
import { limbsAtHand } from "../../actions/limbs";
import { OpenFile, ROBOT_FILES } from "../../parts/open-file";
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

  async function take(file: File): Promise<void> {
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
      <OpenFile accept={ROBOT_FILES} testid="limbs-file" title="A robot file (YAML), or a model (URDF, SDF, MJCF)" size={15} take={(file) => void take(file)}>
        Open a file
      </OpenFile>
    </div>
  );
}
