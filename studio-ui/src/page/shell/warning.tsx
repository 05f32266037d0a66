// Where the pose is close or singular: what has gone wrong in the geometry, and the motion that is gained. It stands at an edge of
// the picture where it covers no point in which planes meet; where both edges have one, below the picture.
import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";
import { Prose } from "../parts/prose";
import { placeOf, type Place } from "./warning-place";

export function Warning({ pane }: { pane: RefObject<HTMLElement | null> }) {
  const { posing, space } = useStore();
  const [open, unfold] = useState(false);
  const bar = useRef<HTMLDivElement>(null);
  const [place, put] = useState<Place>("top");
  const marks = space.marks.value;
  const numbers = posing.numbers.value;
  const warns = numbers !== null && numbers.verdict !== "regular";
  const movable = warns && numbers.motion !== null;
  useEffect(() => {
    if (!movable) space.playing.value = false;
  }, [movable]);
  const below = useRef<readonly unknown[]>([]); // what was on show when it went below the picture, which is smaller since then
  useLayoutEffect(() => {
    const [shown, picture] = [bar.current, pane.current];
    if (!shown || !picture || (place === "below" && below.current[0] === numbers && below.current[1] === open)) return;
    below.current = [numbers, open];
    put(placeOf(place, shown.offsetWidth, shown.offsetHeight, picture.clientWidth, picture.clientHeight, marks));
  }, [marks, numbers, open]); // once for what is on show: it is as large in each place
  if (!warns) return null;
  const causes = numbers.causes.flatMap((cause) => cause.split("\n"));
  const motion = numbers.motion ? [sentence(numbers.motion.text)] : [];
  const [first, ...others] = [...causes, ...motion];
  if (first === undefined) return null;
  return (
    <div ref={bar} class={`warning ${numbers.verdict} ${place} ${open ? "open" : ""}`} data-testid="warning" data-place={place}>
      {movable && <Play />}
      <ul data-testid="causes">
        <li title={open ? undefined : first}>
          <Prose text={first} />
        </li>
        {others.map((text) => (
          <li key={text} hidden={!open} {...(motion.includes(text) && { "data-testid": "motion" })}>
            <Prose text={text} />
          </li>
        ))}
      </ul>
      <button
        type="button"
        class="quiet unfold"
        aria-expanded={open}
        aria-label={open ? "Less" : "More about it"}
        title={open ? "Less" : "More about it"}
        data-testid="warning-more"
        onClick={() => unfold(!open)}
      >
        <Icon name="more" size={16} />
      </button>
    </div>
  );
}

function Play() {
  const { space } = useStore();
  const playing = space.playing.value;
  return (
    <button
      type="button"
      class="play"
      aria-pressed={playing}
      aria-label={playing ? "Stop the motion" : "Show the gained motion"}
      title={playing ? "Stop the motion" : "Show the motion that the platform gains"}
      data-testid="play-motion"
      onClick={() => (space.playing.value = !playing)}
    >
      <Icon name={playing ? "pause" : "play"} size={14} /> {playing ? "Stop" : "Motion"}
    </button>
  );
}

const sentence = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1) + (text.endsWith(".") ? "" : ".");
