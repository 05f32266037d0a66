// How a model of links and joints was read: which joint of it each actuator is, what was merged, moved and left out.
import type { Model } from "../../protocol";
import { Facts } from "../panels/motion/facts";

export function ModelView({ model: { verdict, drives, facts } }: { model: Model }) {
  const limited = drives.some(({ limits }) => limits);
  return (
    <section class="model" aria-label="The model" data-testid="model">
      <h3>The model that was opened</h3>
      <p data-testid="model-verdict">{verdict}</p>
      {drives.length > 0 && (
        <table>
          <thead>
            <tr>
              <th scope="col">actuator</th>
              <th scope="col">joint of the model</th>
              {limited && <th scope="col">from home (rad, m)</th>}
            </tr>
          </thead>
          <tbody>
            {drives.map(({ name, joint, limits }) => (
              <tr key={name} data-testid="model-drive">
                <th scope="row">{name}</th>
                <td>{joint}</td>
                {limited && <td>{limits.replaceAll("-", "−") || "–"}</td>}
              </tr>
            ))}
          </tbody>
        </table>
      )}
      <Facts facts={facts} title="What was read, merged, moved and left out" />
    </section>
  );
}
