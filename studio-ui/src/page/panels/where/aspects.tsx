// The aspects: sets of poses that are connected without a singularity, and a button to a pose of each.
import { short } from "../../lib/format";
import { useStore } from "../../parts/context";
import { Icon } from "../../parts/icon";
import { Question } from "./section";

export function AspectsSection() {
  const { roaming, moving, doc } = useStore();
  const { aspects } = roaming;

  function ask(): void {
    const { source } = doc.peek();
    if (source) void aspects.start({ source });
  }

  return (
    <Question
      title="Aspects"
      why="Into how many parts singularities divide the poses around home."
      name="aspects"
      runner={aspects}
      ask={
        <button type="button" class="primary" disabled={aspects.now.value.state === "busy"} onClick={ask} data-testid="aspects-go">
          <Icon name="where" size={14} /> Count
        </button>
      }
    >
      {({ sets, changes }) => (
        <>
        <table class="sets">
          <thead>
            <tr>
              <th scope="col">set</th>
              <th scope="col">signs</th>
              <th scope="col">poses</th>
              <th scope="col">modes</th>
              <th scope="col">σ up to</th>
              <th scope="col" aria-label="go there" />
            </tr>
          </thead>
          <tbody>
            {sets.map((one) => (
              <tr key={one.name} data-testid="aspect">
                <th scope="row">{one.name}</th>
                <td>{one.signs}</td>
                <td>{one.poses}</td>
                <td>{one.modes.join(", ") || "–"}</td>
                <td>{short(one.margin, 3)}</td>
                <td>
                  <button
                    type="button"
                    title={one.pose ? one.at : `${one.at}: the sliders do not lead there from home`}
                    aria-label={`Go to a pose of ${one.name}`}
                    disabled={!one.pose}
                    data-testid="aspect-go"
                    onClick={() => one.pose && moving.to(one.pose)}
                  >
                    Go there
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
        {changes.map((words) => (
          <p key={words} class="change" data-testid="aspect-change">
            {words.charAt(0).toUpperCase()}{words.slice(1)}.
          </p>
        ))}
        </>
      )}
    </Question>
  );
}
