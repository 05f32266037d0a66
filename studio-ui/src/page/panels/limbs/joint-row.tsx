// A joint of a limb: its kind, whether it is driven, and the points and directions that it is made of.
import type { JointKind, JointRow as Joint, SheetEdit } from "../../../protocol";
import { Icon } from "../../parts/icon";
import { TextField } from "./fields";
import { RowFaults } from "./row-faults";

interface Props {
  joint: Joint;
  kinds: readonly JointKind[];
  /** The places of its limb, of its chain and of itself. */
  at: { limb: number; chain: number; joint: number };
  last: boolean;
  alone: boolean;
  change(edit: SheetEdit): void;
}

export function JointRow({ joint, kinds, at, last, alone, change }: Props) {
  const kind = kinds.find(({ symbol }) => symbol === joint.kind);
  const number = `${at.limb + 1}, joint ${at.joint + 1}`;
  const key = `${at.limb}-${at.chain}-${at.joint}`;
  const wrong = joint.faults.length > 0;
  return (
    <li class={wrong ? "joint-row wrong" : "joint-row"} data-testid={`joint-${key}`} data-points={joint.parts.join(" ")}>
      <div class="joint-line">
        <span class={joint.star ? "symbol driven" : "symbol"} aria-hidden="true">
          {joint.kind}
        </span>
        <select
          class="kind"
          aria-label={`Kind of limb ${number}`}
          value={joint.kind}
          data-testid={`kind-${key}`}
          onChange={(event) => change({ do: "joint kind", ...at, text: event.currentTarget.value })}
        >
          {!kind && <option value={joint.kind}>{joint.kind}?</option>}
          {kinds.map(({ symbol, name }) => (
            <option key={symbol} value={symbol}>
              {name}
            </option>
          ))}
        </select>
        <Drive joint={joint} kind={kind} label={number} testid={`drive-${key}`} take={(text) => change({ do: "joint drive", ...at, text })} />
        <span class="joint-tools">
          <Tool icon="up" label={`Move joint ${at.joint + 1} towards the base`} disabled={at.joint === 0} act={() => change({ do: "joint move", ...at, to: at.joint - 1 })} />
          <Tool icon="more" label={`Move joint ${at.joint + 1} towards the platform`} disabled={last} act={() => change({ do: "joint move", ...at, to: at.joint + 1 })} />
          <Tool icon="close" label={`Take joint ${at.joint + 1} away`} disabled={alone} testid={`joint-remove-${key}`} act={() => change({ do: "joint remove", ...at })} />
        </span>
        <span class="parts">
          {joint.parts.map((part, i) => {
            const { name, form } = kind?.parts[i] ?? { name: "part", form: "point" as const };
            return (
              <label key={i} class="part">
                <span>{WORDS[name] ?? name}</span>
                <TextField
                  value={part}
                  label={`${name} of limb ${number}`}
                  list={form === "number" ? undefined : `limb-${form}s`}
                  testid={`part-${key}-${i}`}
                  class="math-name"
                  size={Math.max(3, part.length)}
                  invalid={wrong && joint.undefined.some((u) => part.split(" ").includes(u.name))}
                  onTake={(text) => change({ do: "joint part", ...at, part: i, text })}
                />
              </label>
            );
          })}
        </span>
      </div>
      <RowFaults faults={joint.faults} undefined={joint.undefined} change={change} />
    </li>
  );
}

const WORDS: Record<string, string> = { point: "at", axis: "axis", direction: "along", first: "first", second: "second" };

interface DriveProps {
  joint: Joint;
  kind: JointKind | undefined;
  label: string;
  testid: string;
  take(star: string): void;
}

/** A switch where there is one freedom to drive, a list where there are several. */
function Drive({ joint, kind, label, testid, take }: DriveProps) {
  const drives = kind?.drives ?? [];
  if (drives.length > 2)
    return (
      <select class="drive" aria-label={`Drive of limb ${label}`} value={joint.star} data-testid={testid} onChange={(event) => take(event.currentTarget.value)}>
        {drives.map(({ star, words }) => (
          <option key={star} value={star}>
            {words}
          </option>
        ))}
      </select>
    );
  if (drives.length < 2) return <span class="drive none">passive</span>;
  return (
    <button type="button" class="drive" aria-pressed={joint.star !== ""} data-testid={testid} aria-label={`Driven: limb ${label}`} onClick={() => take(joint.star ? "" : "*")}>
      <Icon name="drive" size={13} /> {joint.star ? "driven" : "passive"}
    </button>
  );
}

interface ToolProps {
  icon: "up" | "more" | "close" | "copy" | "around" | "trash";
  label: string;
  disabled?: boolean;
  testid?: string;
  act(): void;
}

export function Tool({ icon, label, disabled = false, testid, act }: ToolProps) {
  return (
    <button type="button" class="quiet" title={label} aria-label={label} disabled={disabled} onClick={act} data-testid={testid}>
      <Icon name={icon} size={15} />
    </button>
  );
}
