// The largest box, or ball, around the pose on show that is proved free of singular poses.
import { CertificateButton } from "../../parts/certificate-button";
import { useStore } from "../../parts/context";
import { samePose } from "../../state/doc";
import { Question } from "./section";

const SHAPES = ["box", "ball"] as const;

export function FreeSection() {
  const { roaming, doc, pose$ } = useStore();
  const { free } = roaming;

  function ask(shape: (typeof SHAPES)[number]): void {
    const { source, pose } = doc.peek();
    if (source) void free.start({ source, pose, shape });
  }

  return (
    <Question
      title="Free of singular poses"
      why="The largest box or ball around this pose without one, proved."
      name="free"
      runner={free}
      ask={SHAPES.map((shape) => (
        <button
          type="button"
          key={shape}
          class={shape === "box" ? "primary" : "second"}
          disabled={free.now.value.state === "busy"}
          onClick={() => ask(shape)}
          data-testid={`free-${shape}`}
        >
          {shape === "box" ? "Box" : "Ball"}
        </button>
      ))}
    >
      {({ ranges }, asked) => (
        <>
          <table class="ranges">
            <tbody>
              {ranges.map(({ name, low, high, unit }) => (
                <tr key={name} data-testid="free-range">
                  <td>{low.replace("-", "−")}</td>
                  <td>≤</td>
                  <th scope="row">{name}</th>
                  <td>≤</td>
                  <td>{high.replace("-", "−")}</td>
                  <td>{unit === "deg" ? "°" : unit}</td>
                </tr>
              ))}
            </tbody>
          </table>
          <CertificateButton what="free" asked={asked} />
          {!samePose(asked.pose, pose$.value) && <p class="tip">The robot has moved since: this is around the pose that was asked about.</p>}
        </>
      )}
    </Question>
  );
}
