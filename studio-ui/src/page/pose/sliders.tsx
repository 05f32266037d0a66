// The freedoms of the platform: three shifts and three angles, or the coordinates of a robot with limbs.
import type { Axis, Pose, Study } from "../../protocol";
import { ANGLES, type Angles } from "../lib/rotation";
import { useStore } from "../parts/context";
import { HOME, isHome, shifted } from "../state/doc";
import type { Led } from "../state/taste";
import { useAngles } from "./angles";
import { FaultBox } from "../parts/fault-box";
import { AxisSlider } from "./axis-slider";
import { Icon } from "../parts/icon";

const NAMES: Record<Angles, string> = {
  vector: "rotation vector",
  XYZ: "Euler XYZ",
  ZYX: "Euler ZYX",
  ZXZ: "Euler ZXZ",
  ZYZ: "Euler ZYZ",
};
const SHIFTS = ["x", "y", "z"] as const;

export function Sliders({ study }: { study: Study }) {
  const { pose$, moving } = useStore();
  const pose = pose$.value;
  return (
    <section class="sliders" aria-label="Pose">
      {study.kind === "robot" ? <Coordinates study={study} pose={pose} /> : <SixAxes study={study} pose={pose} />}
      <button type="button" class="quiet home" disabled={isHome(pose)} data-testid="home" onClick={() => moving.to(home(pose))}>
        <Icon name="home" size={16} /> Home
      </button>
    </section>
  );
}

const home = (pose: Pose): Pose => (pose.coordinates ? { ...HOME, coordinates: pose.coordinates.map(() => 0) } : HOME);

function SixAxes({ study, pose }: { study: Study; pose: Pose }) {
  const { edit, settle, moving, taste } = useStore();
  const kind = taste.angles.value;
  const held = useAngles(kind, pose.quaternion);
  const turns = kind === "vector" ? (["x", "y", "z"] as const) : [...kind].map((c) => c.toLowerCase());
  const reach = study.size * 2;
  const change = (next: Pose, key: string) => {
    moving.stop();
    edit({ pose: next }, key);
  };
  return (
    <>
      <div class="group">
        <h3>Shift</h3>
        {SHIFTS.map((name, i) => {
          const axis = study.axes[i];
          return (
            <AxisSlider
              key={name}
              name={name}
              label={`Shift along ${name}`}
              unit={axis?.unit ?? study.unit}
              low={axis?.low ?? -reach}
              high={axis?.high ?? reach}
              step={axis?.step ?? stepFor(reach)}
              value={pose.translation[i] ?? 0}
              testid={`slider-${name}`}
              onChange={(value) => change(shifted(pose, i as 0 | 1 | 2, value), `shift ${name}`)}
              onDone={settle}
            />
          );
        })}
      </div>
      <div class="group">
        <h3>
          <label>
            Turn
            <select
              value={kind}
              data-testid="angles"
              aria-label="How the turn is given"
              onChange={(event) => (taste.angles.value = event.currentTarget.value as Angles)}
            >
              {ANGLES.map((one) => (
                <option key={one} value={one}>
                  {NAMES[one]}
                </option>
              ))}
            </select>
          </label>
        </h3>
        {turns.map((name, i) => (
          <AxisSlider
            key={i}
            name={`r${name}`}
            label={`Turn ${i + 1}, about ${name}`}
            unit="°"
            low={-180}
            high={180}
            step={0.1}
            value={held.angles[i] ?? 0}
            testid={`slider-r${SHIFTS[i]}`}
            onChange={(value) => change({ ...pose, quaternion: held.set(i as 0 | 1 | 2, value) }, `turn ${i}`)}
            onDone={settle}
          />
        ))}
      </div>
    </>
  );
}

/** A robot with limbs: its actuators, or the freedoms of its platform. */
function Coordinates({ study, pose }: { study: Study; pose: Pose }) {
  const { edit, settle, moving, leading, taste } = useStore();
  const byPlatform = taste.led.value === "platform" && study.freedoms.length > 0;
  const now = byPlatform ? leading.values.value : study.axes.map((_, i) => pose.coordinates?.[i] ?? 0);
  const change = (i: number, value: number) => {
    moving.stop();
    if (byPlatform) leading.set(i, value);
    else edit({ pose: { ...pose, coordinates: now.map((c, j) => (j === i ? value : c)) } }, `coordinate ${i}`);
  };
  const fault = leading.fault.value;
  const axes = byPlatform ? study.freedoms : study.axes;
  return (
    <div class={axes.length > 3 ? "group wide many" : "group wide"}>
      <h3>
        <label>
          Move
          <select
            value={byPlatform ? "platform" : "actuators"}
            data-testid="led"
            aria-label="What is moved"
            onChange={(event) => (taste.led.value = event.currentTarget.value as Led)}
          >
            <option value="actuators">{study.axes.length === 1 ? "the actuator" : `the ${study.axes.length} actuators`}</option>
            {study.freedoms.length > 0 && <option value="platform">the platform</option>}
          </select>
        </label>
      </h3>
      {axes.map((axis: Axis, i) => (
        <AxisSlider
          key={axis.name}
          {...axis}
          label={axis.name}
          value={now[i] ?? 0}
          testid={byPlatform ? `slider-${axis.name}` : `slider-${i}`}
          onChange={(value) => change(i, value)}
          onDone={byPlatform ? leading.done : settle}
        />
      ))}
      {byPlatform && fault && <FaultBox fault={fault} />}
    </div>
  );
}

/** A step of a few thousandths of the reach, a power of ten. */
const stepFor = (reach: number): number => 10 ** Math.floor(Math.log10(reach / 200));
