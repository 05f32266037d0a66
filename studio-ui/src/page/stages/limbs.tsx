// A robot of limbs: joints in sequence and the wrenches that each limb applies with its actuators locked.
import type { Robot } from "../../protocol";
import { editLimbs, limbsAtHand } from "../actions/limbs";
import { tone } from "../lib/tint";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";

export function Limbs({ robot }: { robot: Robot }) {
  const store = useStore();
  return (
    <>
    <div class="limbs" data-testid="limbs">
        {robot.limbs.map(({ name, colour, joints, wrenches }) => (
          <section key={name} style={tone({ colour })}>
            <h3>{name}</h3>
            <p class="joints">
              {joints.map(({ kind, actuated }, i) => (
                <abbr key={i} class={actuated ? "actuated" : ""} title={actuated ? `${kind}, actuated` : kind}>
                  {kind}
                </abbr>
              ))}
            </p>
            <ul>
              {wrenches.map((text, i) => (
                <li key={i}>{text}</li>
              ))}
            </ul>
          </section>
        ))}
    </div>
    {limbsAtHand(store) && (
      <p>
        <button type="button" data-testid="edit-limbs" onClick={() => void editLimbs(store)}>
          <Icon name="build" size={15} /> Edit its limbs
        </button>
      </p>
    )}
    </>
  );
}
