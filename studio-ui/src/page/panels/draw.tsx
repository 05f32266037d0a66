// Drawing a robot: a plan of its base and platform, legs between them, and what becomes of it at once.
import { useEffect, useMemo, useState } from "preact/hooks";
import type { Sketch } from "../../protocol";
import { Icon, type IconName } from "../parts/icon";
import { NumberField } from "../parts/number-field";
import { Graph } from "./draw/graph";
import { Sheet, type Tool } from "./draw/sheet";
import { EMPTY, atHeight, fromStudy, gridOf, heightOf, sceneOfSketch, spanOf } from "./draw/sketch";
import { Legs, Points } from "./draw/tables";
import { Verdict } from "./draw/verdict";
import { MiniViewer } from "./mini-viewer";
import type { PanelProps } from "./index";
import "./draw/draw.css";

const TOOLS: readonly { id: Tool; title: string; words: string; key: string }[] = [
  { id: "base", title: "Base points", words: "Click to place, drag to move; drop a point on another to make the joints one.", key: "b" },
  { id: "platform", title: "Platform points", words: "The same on the platform, which lies above the base.", key: "p" },
  { id: "leg", title: "Legs", words: "Drag from a joint of the base to one of the platform, or click one after the other.", key: "l" },
  { id: "erase", title: "Erase", words: "Click a point or a leg.", key: "e" },
];

export function Draw({ store }: PanelProps) {
  const sketch = store.sketch$.value ?? EMPTY;
  const [tool, use] = useState<Tool>(sketch.base.length === 0 ? "base" : "leg");
  const [span, zoom] = useState(() => spanOf(sketch));
  const [snap, setSnap] = useState(true);
  const [rest, setRest] = useState(200);
  const [selected, select] = useState<string | null>(null);
  const [said, say] = useState<string | null>(null);
  const height = heightOf(sketch, rest);
  const study = store.study.value;
  const empty = Object.keys(sketch.points).length === 0;

  function change(next: Sketch, key?: string): void {
    if (next !== store.sketch$.peek()) store.edit({ sketch: next }, key && `sketch-${key}`);
  }
  function replace(next: Sketch): void {
    store.settle();
    change(next);
    zoom(spanOf(next));
    select(null);
    say(null);
    use(next.base.length === 0 ? "base" : "leg");
  }
  const shared = { sketch, span, height, selected, select, change, say };
  const words = TOOLS.find(({ id }) => id === tool)?.words;
  return (
    <div class="draw">
      <div class="draw-main">
        <div class="draw-bar" role="toolbar" aria-label="Drawing">
          <div class="segments" role="group" aria-label="Tool">
            {TOOLS.map(({ id, title }) => (
              <button type="button" key={id} aria-pressed={tool === id} onClick={() => use(id)} data-testid={`tool-${id}`}>
                {title}
              </button>
            ))}
          </div>
          <label class="check">
            <input type="checkbox" checked={snap} onChange={(event) => setSnap(event.currentTarget.checked)} data-testid="snap" />
            Snap to {gridOf(span)}
          </label>
          <label class="height">
            Platform height
            <NumberField
              value={height}
              step={gridOf(span)}
              digits={0}
              label="Height of the platform"
              testid="platform-height"
              onChange={(value) => {
                setRest(value);
                if (sketch.platform.length > 0) change(atHeight(sketch, value), "height");
              }}
            />
          </label>
          <span class="space" />
          <div class="segments" role="group" aria-label="Zoom">
            {ZOOMS.map(([label, title, by]) => (
              <button type="button" key={title} aria-label={title} title={title} onClick={() => zoom(by === null ? spanOf(sketch) : span * by)}>
                {label}
              </button>
            ))}
          </div>
        </div>
        <div
          class="draw-sheet"
          onWheel={(event) => {
            event.preventDefault();
            zoom(span * (event.deltaY > 0 ? 1.1 : 1 / 1.1));
          }}
        >
          <Sheet {...shared} tool={tool} snap={snap} settle={store.settle} />
          <p class="tip" role="status" data-testid="draw-said">
            {said ?? words}
          </p>
        </div>
      </div>
      <aside class="draw-side" aria-label="The drawing">
        <div class="draw-head">
          <input
            type="text"
            class="title"
            aria-label="Title"
            value={sketch.title}
            data-testid="draw-title"
            onInput={(event) => change({ ...sketch, title: event.currentTarget.value }, "title")}
          />
          {study?.kind === "platform" && study.legs.length > 0 && (
            <Head
              icon="file"
              label={`Start from ${study.title}`}
              testid="draw-from-study"
              act={() => replace(fromStudy(study, store.posing.numbers.value?.points ?? study.points))}
            />
          )}
          <Head icon="close" label="Clear the sheet" testid="draw-clear" disabled={empty} act={() => replace({ ...EMPTY })} />
        </div>
        <Verdict sketch={sketch} />
        {sketch.legs.length > 0 && <Graph sketch={sketch} selected={selected} />}
        {sketch.legs.length > 0 && <Preview sketch={sketch} />}
        <Points {...shared} />
        <Legs {...shared} />
      </aside>
    </div>
  );
}

const ZOOMS: readonly [string, string, number | null][] = [
  ["−", "Smaller", 1.25],
  ["Fit", "Fit", null],
  ["+", "Larger", 0.8],
];

interface HeadProps {
  icon: IconName;
  label: string;
  testid: string;
  disabled?: boolean;
  act(): void;
}

function Head({ icon, label, testid, disabled = false, act }: HeadProps) {
  return (
    <button type="button" class="tool" title={label} aria-label={label} disabled={disabled} onClick={act} data-testid={testid}>
      <Icon name={icon} size={17} />
    </button>
  );
}

const REST = 150; // milliseconds without a change before the picture in space is made anew

function Preview({ sketch }: { sketch: Sketch }) {
  const [settled, settle] = useState(sketch);
  useEffect(() => {
    const timer = window.setTimeout(() => settle(sketch), REST);
    return () => window.clearTimeout(timer);
  }, [sketch]);
  const scene = useMemo(() => sceneOfSketch(settled), [settled]);
  return <MiniViewer scene={scene} label="The drawing in 3D" testid="draw-viewer" />;
}
