// The assembly modes: pictures that take the robot to each of them.
import type { AssemblyMode, Pose, Study } from "../../../protocol";
import { short } from "../../lib/format";
import { useStore } from "../../parts/context";
import { Drawing } from "../../parts/drawing";
import { Icon } from "../../parts/icon";
import { inMode, modeOf } from "../../pose/mode-view";
import { samePose } from "../../state/doc";
import { Question } from "./section";

export function AssembliesSection({ study }: { study: Study }) {
  const { roaming, moving, doc, pose$, source$, open, panel$ } = useStore();
  const { assemblies } = roaming;
  const driven = study.robot !== null && study.kind === "robot";
  const busy = assemblies.now.value.state === "busy";
  const current = modeOf(source$.value);

  function ask(): void {
    const { source, pose, threshold } = doc.peek();
    if (source) void assemblies.start({ source, pose, threshold });
  }

  function take({ pose, mode }: AssemblyMode): void {
    const source = source$.peek();
    if (pose) moving.to(pose);
    else if (source) open(inMode(source, mode ?? undefined), panel$.peek());
  }

  const on = (one: AssemblyMode, pose: Pose) => (one.pose ? samePose(one.pose, pose) : (one.mode ?? undefined) === current);

  return (
    <Question
      title="Assembly modes"
      why={driven ? "All configurations with the actuators at home." : "All poses with the legs as long as they are now."}
      name="assemblies"
      runner={assemblies}
      ask={
        <button type="button" class="primary" disabled={busy} onClick={ask} data-testid="assemblies-go">
          <Icon name="where" size={14} /> Find all
        </button>
      }
    >
      {({ modes }) => (
        <>
          <div class="gallery" role="group" aria-label="Assembly modes">
            {modes.map((one) => (
              <button
                type="button"
                key={one.number}
                class={`mode ${one.verdict}`}
                aria-pressed={on(one, pose$.value)}
                title={`${one.at}; ${one.sure}`}
                data-testid="assembly"
                onClick={() => take(one)}
              >
                <Drawing svg={one.svg} label={`The robot in mode ${one.number}`} />
                <strong>
                  {one.number} {one.given && <small>{driven ? "home" : "here"}</small>}
                </strong>
                <span>
                  σ {short(one.margin, 3)} {one.signs && <b>{one.signs}</b>}
                </span>
              </button>
            ))}
          </div>
          {modes.length > 0 && !driven && !modes.some((one) => on(one, pose$.value)) && (
            <p class="tip">The legs have other lengths now: these are the modes of the pose that was asked about.</p>
          )}
        </>
      )}
    </Question>
  );
}
