// A further limb, of joints that are written as people write them: UP*S, R*RR.
import { useState } from "preact/hooks";
import type { JointKind } from "../../../protocol";
import { Icon } from "../../parts/icon";

interface Props {
  plane: boolean;
  kinds: readonly JointKind[];
  add(chain: string): void;
}

/** Chains to choose from, in space and in the plane. */
const CHAINS = {
  space: ["RP*S", "UP*S", "P*RS", "R*US", "P*US", "UP*U", "P*UU", "R*UU", "R*4S", "R*RR", "SP*R", "P*RRS", "S", "cable"],
  plane: ["R*RR", "RP*R", "P*RR", "RR*R", "cable"],
};

export function AddLimb({ plane, kinds, add }: Props) {
  const chains = plane ? CHAINS.plane : CHAINS.space;
  const [chain, write] = useState("");
  const first = chains[0] ?? "";
  return (
    <form
      class="add-limb"
      data-testid="add-limb"
      onSubmit={(event) => {
        event.preventDefault();
        add(chain.trim() || first);
      }}
    >
      <label>
        <span>Joints</span>
        <input
          type="text"
          list="limb-chains"
          size={9}
          maxLength={40}
          autocomplete="off"
          autocapitalize="characters"
          spellcheck={false}
          value={chain}
          placeholder={first}
          title={`From the base to the platform, a star behind what is driven. ${kinds.map(({ symbol, name }) => `${symbol} ${name}`).join(", ")}`}
          data-testid="limb-add-chain"
          onInput={(event) => write(event.currentTarget.value)}
        />
      </label>
      <datalist id="limb-chains">
        {chains.map((text) => (
          <option key={text} value={text} />
        ))}
      </datalist>
      <button type="submit" data-testid="limb-add">
        <Icon name="build" size={15} /> Add a limb
      </button>
    </form>
  );
}
