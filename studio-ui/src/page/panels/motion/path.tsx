// A path: from home, or from a pose that was marked, to the pose on show or to one that is typed.
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { useSight } from "../../parts/sight";
import { Seeks } from "../../pose/nearest-view";
import { atHome, samePose } from "../../state/doc";
import { PathResult } from "./path-result";

export function PathSection() {
  const { touring, doc, pose$, tour$, settle } = useStore();
  const { path, change } = touring;
  const { start, to } = tour$.value;
  const now = path.now.value;
  const sight = useSight(now.state === "found");
  const nowhere = to.trim() === "" && samePose(start ?? atHome(pose$.value), pose$.value);

  function go(around = false): void {
    const { source, pose, threshold } = doc.peek();
    if (!source) return;
    const typed = to.trim();
    void path.start({ source, goal: pose, threshold, ...(start && { start }), ...(typed && { to: typed }), ...(around && { way: "around" as const }) });
  }

  return (
    <section class="path" aria-label="Path" ref={sight}>
      <h3>Along a path</h3>
      <form
        class="ask"
        onSubmit={(event) => {
          event.preventDefault();
          go();
        }}
      >
        <div class="row">
          <span class="label">from</span>
          <div class="segments" role="group" aria-label="The path begins at">
            <button type="button" aria-pressed={start === null} onClick={() => change({ start: null })} data-testid="path-from-home">
              Home
            </button>
            <button
              type="button"
              aria-pressed={start !== null}
              title="Begin where the robot is now; move it on afterwards"
              onClick={() => change({ start: pose$.peek() })}
              data-testid="path-from-here"
            >
              {start === null ? "This pose" : "The marked pose"}
            </button>
          </div>
        </div>
        <div class="row">
          <label>
            <span class="label">to</span>
            <input
              type="text"
              class="mono"
              value={to}
              placeholder="the pose on show"
              title="Coordinates such as z=0.2, roll=20deg; left empty, the path ends at the pose on show"
              data-testid="path-to"
              onInput={(event) => change({ to: event.currentTarget.value })}
              onBlur={settle}
            />
          </label>
          <button type="submit" class="primary" disabled={now.state === "busy" || nowhere} data-testid="path-go">
            <Icon name="play" size={14} /> Follow
          </button>
          <button
            type="button"
            disabled={now.state === "busy" || nowhere}
            title="Find a way to the same pose on which nothing is singular, or the proof that there is none"
            data-testid="path-around"
            onClick={() => go(true)}
          >
            Go around
          </button>
        </div>
      </form>
      {nowhere && <p class="tip">Move the robot, or type where the path ends.</p>}
      {now.state === "busy" && <Seeks words={now.words} stop={path.stop} testid="path-stop" />}
      {now.state === "failed" && <FaultBox fault={now.fault} />}
      {now.state === "found" && <PathResult key={now.result.svg} asked={now.asked} result={now.result} />}
    </section>
  );
}
