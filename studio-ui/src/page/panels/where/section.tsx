// The frame of a question: its heading, what asks it, how far the answer is, and the answer.
import type { ComponentChildren } from "preact";
import type { Account, Method, Methods } from "../../../protocol";
import { FaultBox } from "../../parts/fault-box";
import { useSight } from "../../parts/sight";
import { Termed } from "../../parts/term";
import { Seeks } from "../../pose/nearest-view";
import type { Runner } from "../../state/running";
import { Facts } from "../motion/facts";

interface Props<M extends Method> {
  title: string;
  why: string;
  name: string;
  runner: Runner<M>;
  /** What is asked, above the buttons. */
  fields?: ComponentChildren;
  /** The buttons that ask. */
  ask: ComponentChildren;
  /** What the answer is, for its colour. */
  tone?(result: Methods[M]["result"]): string;
  children(result: Methods[M]["result"], asked: Methods[M]["args"]): ComponentChildren;
}

export function Question<M extends "assemblies" | "aspects" | "free" | "boxes" | "certify">({ title, why, name, runner, fields, ask, tone, children }: Props<M>) {
  const now = runner.now.value;
  const sight = useSight(now.state === "found");
  return (
    <section class={name} aria-label={title} ref={sight}>
      <h3>
        <Termed text={title} />
      </h3>
      <div class="ask">
        {fields}
        <div class="row">
          <span class="told">
            <Termed text={why} />
          </span>
          {ask}
        </div>
      </div>
      {now.state === "busy" && <Seeks words={now.words} stop={runner.stop} testid={`${name}-stop`} />}
      {now.state === "failed" && <FaultBox fault={now.fault} />}
      {now.state === "found" && (
        <div class={`answer ${tone?.(now.result) ?? ""}`.trim()}>
          <Verdict account={now.result} name={name} />
          {children(now.result, now.asked)}
          <Facts facts={now.result.facts} title="What was computed, and how sure it is" />
        </div>
      )}
    </section>
  );
}

const Verdict = ({ account, name }: { account: Account; name: string }) => (
  <p class="said" role="status" data-testid={`${name}-verdict`}>
    {account.verdict}
  </p>
);
