// The answer to the last proposal, with its reason; a counterexample is drawn and written out.
import { useMemo } from "preact/hooks";
import type { Manual, Study } from "../../../protocol";
import { Icon, type IconName } from "../../parts/icon";
import { PointName } from "../../parts/point-name";
import { MiniViewer } from "../mini-viewer";
import { counterScene } from "./proposals";

type Record_ = Manual["history"][number];

export const ANSWERS: Record<Record_["answer"], { title: string; icon: IconName }> = {
  confirmed: { title: "Confirmed", icon: "ok" },
  refused: { title: "Refused", icon: "close" },
  possible: { title: "Possible", icon: "warn" },
  done: { title: "Done", icon: "ok" },
};

export function Answer({ study, manual }: { study: Study; manual: Manual }) {
  const last = manual.history.at(-1);
  if (!last) return null;
  const { title, icon } = ANSWERS[last.answer];
  return (
    <section class={`answer ${last.answer}`} role="status" data-testid="manual-answer" data-answer={last.answer}>
      <p class="head">
        <Icon name={icon} size={17} /> <strong>{title}</strong> <code>{last.command}</code>
      </p>
      {last.words.split("\n").map((line, i) => (
        <p key={i}>{line.replace(/-(?=\[)/g, "−")}</p>
      ))}
      {manual.counterexample && <Counterexample study={study} points={manual.counterexample} command={last.command} />}
    </section>
  );
}

interface Props {
  study: Study;
  points: NonNullable<Manual["counterexample"]>;
  command: string;
}

function Counterexample({ study, points, command }: Props) {
  const scene = useMemo(() => {
    const places = Object.entries(points).map(([name, { at }]) => [name, at] as const);
    return counterScene(study, Object.fromEntries(places), command);
  }, [study, points, command]);
  return (
    <figure class="counter" data-testid="counterexample">
      <MiniViewer scene={scene} label="The counterexample in 3D" testid="counterexample-viewer" />
      <figcaption>
        <p>The robot at these points refutes the proposal. They are exact.</p>
        <table>
          <tbody>
            {Object.entries(points).map(([name, { exactly }]) => (
              <tr key={name}>
                <th scope="row">
                  <PointName name={name} />
                </th>
                {exactly.map((c, i) => (
                  <td key={i}>{c.replace("-", "−")}</td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </figcaption>
    </figure>
  );
}
