// The legs or the actuators at the pose: how long or how far, within what limits, and what the Jacobian makes of them.
import type { Numbers } from "../../protocol";
import { short } from "../lib/format";
import { useStore } from "../parts/context";

type Actuator = Numbers["actuators"][number];

/** How far outside its limits; 0 within, NaN without limits. */
function beyond({ value, low, high }: Actuator): number {
  if (low === null && high === null) return NaN;
  return Math.max(low === null ? 0 : low - value, high === null ? 0 : value - high, 0);
}

export function ActuatorsTable() {
  const { posing, study } = useStore();
  const { actuators = [], jacobian = [] } = posing.numbers.value ?? {};
  if (actuators.length === 0) return <p class="none">The legs have no lengths here.</p>;
  const legs = study.value?.kind === "platform";
  const limited = actuators.some((a) => !Number.isNaN(beyond(a)));
  const driven = actuators.some(({ speed, turn }) => speed || turn);
  return (
    <>
      <p class="tip" role="status" data-testid="reach">
        {reachWords(actuators, legs)}
      </p>
      <div class="scrolled">
        <table class="readings actuators" data-testid="actuators">
          <thead>
            <tr>
              <th scope="col">{legs ? "Leg" : "Actuator"}</th>
              <th scope="col">{legs ? "length" : "from home"}</th>
              {limited && <th scope="col">limits</th>}
              {driven && <th scope="col" title="Of the platform's centre, with this one at unit rate and the others locked">speed</th>}
              {driven && <th scope="col" title="Of the platform, with this one at unit rate and the others locked">turn</th>}
            </tr>
          </thead>
          <tbody>
            {actuators.map((a) => (
              <tr key={a.name} class={beyond(a) > 0 ? "beyond" : ""}>
                <th scope="row">{a.name}</th>
                <td>
                  {short(a.value)} {unitOf(a)}
                </td>
                {limited && (
                  <td>
                    <Limits actuator={a} />
                  </td>
                )}
                {driven && <td>{a.speed}</td>}
                {driven && <td>{a.turn}</td>}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <dl class="facts small">
        {jacobian.map((one) => (
          <div key={one.key}>
            <dt>{one.key}</dt>
            <dd>{one.value}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}

const unitOf = ({ unit }: Actuator): string => (unit === "deg" ? "°" : unit);

function reachWords(actuators: readonly Actuator[], legs: boolean): string {
  const out = actuators.filter((a) => beyond(a) > 0);
  const noun = legs ? "leg" : "actuator";
  if (actuators.every((a) => Number.isNaN(beyond(a)))) return `The file says nothing about what ${noun}s reach.`;
  if (out.length === 0) return `All ${noun}s are within the limits of the file.`;
  const words = out.map((a) => `${a.name} by ${short(beyond(a))} ${unitOf(a)}`);
  return `Beyond the limits of the file: ${words.join(", ")}.`;
}

function Limits({ actuator }: { actuator: Actuator }) {
  const { low, high, value } = actuator;
  const words = `${low === null ? "" : short(low)} … ${high === null ? "" : short(high)}`.trim();
  const share = low === null || high === null || high <= low ? null : Math.min(Math.max((value - low) / (high - low), 0), 1);
  return (
    <span class="limits">
      {share !== null && (
        <span class="span" aria-hidden="true">
          <i style={{ left: `${100 * share}%` }} />
        </span>
      )}
      {words}
    </span>
  );
}
