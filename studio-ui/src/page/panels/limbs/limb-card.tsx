// A limb: its joints from the base to the platform, and the wrenches that it applies with its actuators locked.
import { useState } from "preact/hooks";
import type { JointKind, LimbRow, SheetEdit } from "../../../protocol";
import { tone } from "../../lib/tint";
import { Icon } from "../../parts/icon";
import { TextField } from "./fields";
import { JointRow, Tool } from "./joint-row";
import { RowFaults } from "./row-faults";

interface Props {
  limb: LimbRow;
  /** Whether limbs alike are turned about z from one to the next, evenly. */
  turned: boolean;
  at: number;
  count: number;
  kinds: readonly JointKind[];
  change(edit: SheetEdit): void;
}

export function LimbCard({ limb, turned, at, count, kinds, change }: Props) {
  return (
    <section class="limb-card" style={tone({ colour: limb.colour })} data-testid={`limb-${at}`} aria-label={limb.name}>
      <header>
        <TextField value={limb.name} label={`Name of limb ${at + 1}`} class="limb-name" testid={`limb-name-${at}`} onTake={(text) => change({ do: "limb name", limb: at, text })} />
        <span class="limb-chain" title="Its joints; those with a star are driven">
          {limb.copies > 1 && `${limb.copies} × `}
          {limb.chain}
        </span>
        <span class="space" />
        <Tool icon="up" label={`Move ${limb.name} up`} disabled={at === 0} act={() => change({ do: "limb move", limb: at, to: at - 1 })} />
        <Tool icon="more" label={`Move ${limb.name} down`} disabled={at === count - 1} act={() => change({ do: "limb move", limb: at, to: at + 1 })} />
        <Tool icon="trash" label={`Take ${limb.name} away`} testid={`limb-remove-${at}`} act={() => change({ do: "limb remove", limb: at })} />
      </header>
      {limb.cable.length > 0 && (
        <p class="cable parts">
          {limb.cable.map((name, part) => (
            <label class="part" key={part}>
              <span>{part === 0 ? "Cable from" : "to"}</span>
              <TextField value={name} label={`${part === 0 ? "Begin" : "End"} of the cable ${limb.name}`} list="limb-points" size={3} class="math-name" testid={`cable-${at}-${part}`} onTake={(text) => change({ do: "limb cable", limb: at, part, text })} />
            </label>
          ))}
          <span>It is driven, and only pulls.</span>
        </p>
      )}
      {limb.chains.map(({ head, joints }, chain) => (
        <div class="chain" key={chain}>
          {head && <h3>{head}</h3>}
          <ol class="joint-rows">
            {joints.map((joint, k) => (
              <JointRow key={k} joint={joint} kinds={kinds} at={{ limb: at, chain, joint: k }} last={k === joints.length - 1} alone={joints.length === 1} change={change} />
            ))}
          </ol>
          <AddJoint kinds={kinds} label={`Add a joint to ${limb.name}`} testid={`joint-add-${at}-${chain}`} add={(text) => change({ do: "joint add", limb: at, chain, joint: joints.length, text })} />
        </div>
      ))}
      {limb.couplings && <p class="cable">Coupled: {limb.couplings}</p>}
      <RowFaults faults={limb.faults} undefined={limb.undefined} change={change} />
      <Wrenches limb={limb} />
      <Around limb={limb} turned={turned} at={at} change={change} />
    </section>
  );
}

interface AddProps {
  kinds: readonly JointKind[];
  label: string;
  testid: string;
  add(symbol: string): void;
}

function AddJoint({ kinds, label, testid, add }: AddProps) {
  return (
    <div class="joint-add" role="group" aria-label={label} data-testid={testid}>
      <span aria-hidden="true">+</span>
      {kinds.map(({ symbol, name }) => (
        <button type="button" key={symbol} title={`Add a ${name} joint`} aria-label={`Add a ${name} joint`} onClick={() => add(symbol)}>
          {symbol}
        </button>
      ))}
    </div>
  );
}

function Wrenches({ limb }: { limb: LimbRow }) {
  if (!limb.system) return null;
  return (
    <div class="limb-wrenches" data-testid="limb-wrenches">
      <p>
        {limb.freedoms} joint freedoms; applies: <b>{limb.system}</b>
      </p>
      <ul>
        {limb.wrenches.map(({ text, role }) => (
          <li key={text} class={role}>
            {text}
            <small>{ROLES[role]}</small>
          </li>
        ))}
      </ul>
    </div>
  );
}

const ROLES: Record<string, string> = { constraint: "constraint", actuation: "by its drive", both: "drive and constraint" };

/** More limbs like this one: around z, as copies that change together, or one more by itself. */
function Around({ limb, turned, at, change }: Pick<Props, "limb" | "turned" | "at" | "change">) {
  const [number, choose] = useState(3);
  const [degrees, turn] = useState(120);
  if (limb.numbered)
    return (
      <footer>
        <label>
          <select aria-label={`Number of limbs like ${limb.name}${turned ? " around z" : ""}`} value={limb.copies} data-testid={`copies-${at}`} onChange={(event) => change({ do: "copies", to: Number(event.currentTarget.value) })}>
            {NUMBERS.map((n) => (
              <option key={n}>{n}</option>
            ))}
          </select>{" "}
          {turned ? "alike around z" : "alike"}
        </label>
        <button type="button" onClick={() => change({ do: "limb single", limb: at })} data-testid={`limb-single-${at}`}>
          Make single limbs
        </button>
      </footer>
    );
  return (
    <footer>
      <span class="pair">
        <select aria-label="How many limbs around z" value={number} onChange={(event) => choose(Number(event.currentTarget.value))} data-testid={`around-number-${at}`}>
          {NUMBERS.map((n) => (
            <option key={n}>{n}</option>
          ))}
        </select>
        <button type="button" onClick={() => change({ do: "limb around", limb: at, to: number })} data-testid={`around-${at}`}>
          <Icon name="around" size={15} /> alike around z
        </button>
      </span>
      <span class="pair">
        <select aria-label="Angle of the duplicate about z" value={degrees} onChange={(event) => turn(Number(event.currentTarget.value))}>
          {ANGLES.map((angle) => (
            <option key={angle} value={angle}>
              {angle}°
            </option>
          ))}
        </select>
        <button type="button" onClick={() => change({ do: "limb duplicate", limb: at, degrees })} data-testid={`duplicate-${at}`}>
          <Icon name="copy" size={14} /> Duplicate, turned
        </button>
      </span>
    </footer>
  );
}

const NUMBERS = [2, 3, 4, 5, 6, 8];
const ANGLES = [30, 45, 60, 72, 90, 120, 180, 240, 270];
