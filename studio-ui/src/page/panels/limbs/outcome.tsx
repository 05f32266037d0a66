// What the robot is by now: its mobility, what is wrong with it as a whole, and when it is singular.
import type { Fault, Numbers, SheetEdit } from "../../../protocol";
import { short } from "../../lib/format";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { VERDICTS } from "../../pose/verdict-view";
import type { Building } from "./editing";

interface Props {
  building: Building;
  change(edit: SheetEdit): void;
  open(): void;
  save(): void;
}

export function Outcome({ building, change, open, save }: Props) {
  const answer = building.answer.value;
  const known = building.known.value;
  if (!answer) return null;
  const { mobility, every, sheet } = answer;
  const sound = every === null && sheet !== null;
  const fresh = sound && known?.text === answer.text;
  const differs = mobility.number !== null && mobility.written !== "" && Number(mobility.written) !== mobility.number;
  const marked = (every ? 1 + (every.more?.length ?? 0) : 0) - answer.faults.length - mobility.faults.length;
  return (
    <section class="limb-outcome" aria-live="polite">
      <div class="mobility" data-testid="mobility">
        <span class="figure">{mobility.number ?? "–"}</span>
        <div>
          <p class="over">Mobility of the platform</p>
          <p>{mobility.sentence || (sheet?.limbs.length === 0 ? "Known from the first limb on." : "Known as soon as the limbs are without faults.")}</p>
          {mobility.faults.map(({ message, hint }) => (
            <p class="wanting" key={message}>
              {message.charAt(0).toUpperCase() + message.slice(1)}
              {hint && `; ${hint}`}.
            </p>
          ))}
          {differs && (
            <button type="button" onClick={() => change({ do: "mobility", to: mobility.number ?? 0 })} data-testid="write-mobility">
              The file says {mobility.written}: write {mobility.number}
            </button>
          )}
        </div>
      </div>
      {answer.faults.map((fault, i) => (
        <FaultBox key={i} fault={withoutMore(fault)} />
      ))}
      {marked > 0 && sheet !== null && (
        <p class="lacking" data-testid="limb-lacking">
          {marked === 1 ? "One fault is" : `${marked} faults are`} marked in the table.
        </p>
      )}
      {sound && !fresh && building.analysing.value && (
        <p class="busy">
          <span class="spinner" aria-hidden="true" /> Looking for the condition …
        </p>
      )}
      {known && (
        <div class={fresh ? "statement" : "statement old"} data-testid="limb-statement" data-fresh={fresh}>
          <p class="over">{fresh ? "When it is singular" : "When the last sound robot was singular"}</p>
          <p data-testid="limb-sentence">{known.study.robot?.statement ?? known.study.condition.statement}</p>
          {fresh && known.numbers && <AtHome numbers={known.numbers} />}
        </div>
      )}
      <p class="ways">
        <button type="button" class="primary" disabled={!sound} onClick={open} data-testid="limbs-open">
          Open in the studio <Icon name="next" size={15} />
        </button>
        <button type="button" onClick={save} data-testid="limbs-save">
          <Icon name="take-away" size={15} /> Save the file
        </button>
      </p>
    </section>
  );
}

/** Whether it is singular as it stands. */
function AtHome({ numbers: { verdict, margin, causes, reason } }: { numbers: Numbers }) {
  const [word, icon] = VERDICTS[verdict];
  return (
    <div class={`at-home ${verdict}`} data-testid="limb-verdict" data-verdict={verdict}>
      <p>
        <Icon name={icon} size={16} /> <b>{word} at home</b>
        <span>σ {short(margin, 3)}</span>
      </p>
      {verdict !== "regular" && (causes.length > 0 ? causes : [reason]).map((cause) => <p key={cause}>{cause}</p>)}
    </div>
  );
}

const withoutMore = ({ more: _, place: __, ...fault }: Fault): Fault => fault;
