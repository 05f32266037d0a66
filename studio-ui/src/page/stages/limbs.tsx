// A robot of limbs: joints in sequence and the wrenches that each limb applies with its actuators locked.
import type { Robot } from "../../protocol";
import { tone } from "../lib/tint";

export function Limbs({ robot }: { robot: Robot }) {
  return (
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
  );
}
