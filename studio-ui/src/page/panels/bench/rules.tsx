// Files of rules that hold on the bench: opened, checked, switched on and off, and at work. Below them the plugins.
import { useEffect, useMemo } from "preact/hooks";
import type { BenchResult, CheckedRule, CheckedRuleFile, PluginRule, PluginsAnswer, RuleFile, RuleOwner } from "../../../protocol";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { OpenFile } from "../../parts/open-file";
import { Seeks } from "../../pose/nearest-view";
import type { Store } from "../../state/store";
import { createRuleChecks, type RuleChecks } from "./rule-checks";
import "./rules.css";

interface Props {
  store: Store;
  results: readonly BenchResult[];
  text: string;
  say(words: string): void;
  /** Puts a rule on the bench. */
  write(rule: string): void;
}

export function Rules({ store, results, text, say, write }: Props) {
  const checks = useMemo(() => createRuleChecks(store), [store]);
  useEffect(() => checks.dispose, [checks]);
  const files = store.rules$.value;
  const now = checks.now.value;
  const found = now.state === "found" ? now.files : [];
  const used = usedIn(results, text);

  async function open(file: File): Promise<void> {
    const refused = checks.open(file.name, await file.text());
    if (refused) say(refused);
  }

  return (
    <details
      class="bench-rules"
      data-testid="bench-rules"
      onToggle={(event) => {
        if (event.currentTarget.open) checks.askPlugins();
      }}
    >
      <summary data-testid="bench-rules-open">
        <Icon name="more" size={14} /> Rules <span class="count">{countOf(files, found, now.state)}</span>
      </summary>
      <div class="body">
        <section aria-label="Files of rules and catalogs">
          <header>
            <h3>Your rules and catalogs</h3>
            <OpenFile accept=".gca,.txt,.yaml,.yml" testid="rules-file" title="Open a file of rules (.gca) or a catalog (.yaml)" class="quiet" buttonTestid="rules-open" size={14} take={(file) => void open(file)}>
              Open rules
            </OpenFile>
          </header>
          {files.length === 0 && (
            <p class="told">
              A file of rules holds identities, such as <code>rule pierce: ab /\ cde =&gt; [acde] b - [bcde] a</code>. Each is proved before it is used; then{" "}
              <code>rewrite</code> and <code>:analyze</code> go by it. A catalog (<code>.yaml</code>) holds classes of platforms with their conditions, which <code>:analyze</code> knows then; what is not proved is
              marked.
            </p>
          )}
          {now.state === "busy" && <Seeks words={now.words} stop={checks.stop} testid="rules-stop" />}
          {now.state === "failed" && (
            <>
              {now.fault.kind === "cancelled" ? <p class="told">The check was stopped.</p> : <FaultBox fault={now.fault} />}
              <button type="button" class="quiet" onClick={checks.again}>
                Check again
              </button>
            </>
          )}
          {files.map((file, i) => (
            <OwnFile key={file.name} file={file} checked={found[i]} checks={checks} index={i} used={used} />
          ))}
        </section>
        <Plugins checks={checks} used={used} write={write} />
      </div>
    </details>
  );
}

type Used = ReadonlyMap<string, readonly number[]>;

/** The lines of the answers that a rule led to, by its id and who brought it. */
function usedIn(results: readonly BenchResult[], text: string): Used {
  const found = new Map<string, number[]>();
  for (const { applied, start } of results)
    for (const { id, owner } of applied) {
      const key = keyOf(id, owner);
      found.set(key, [...(found.get(key) ?? []), text.slice(0, start).split("\n").length]);
    }
  return found;
}

const keyOf = (id: string, { kind, name }: Pick<RuleOwner, "kind" | "name">): string => JSON.stringify([id, kind, name]);

function countOf(files: readonly RuleFile[], found: readonly CheckedRuleFile[], state: string): string {
  if (files.length === 0) return "";
  if (state === "busy") return "being checked";
  if (found.length === 0) return "not checked";
  const rules = found.flatMap(({ rules: own }, i) => own.map((rule) => rule.fault === null && !files[i]?.off.includes(rule.id)));
  const wrong = found.reduce((sum, { rules: own, fault }) => sum + (fault ? 1 : own.filter((rule) => rule.fault).length), 0);
  const words = `${rules.filter(Boolean).length} of ${rules.length} on`;
  return wrong > 0 ? `${words}, ${wrong} wrong` : words;
}

const Work = ({ lines }: { lines: readonly number[] | undefined }) =>
  lines ? (
    <span class="tag work" data-testid="rule-work">
      at work in {lines.length === 1 ? "line" : "lines"} {[...new Set(lines)].join(", ")}
    </span>
  ) : null;

interface OwnProps {
  file: RuleFile;
  checked: CheckedRuleFile | undefined;
  checks: RuleChecks;
  index: number;
  used: Used;
}

function OwnFile({ file, checked, checks, index, used }: OwnProps) {
  return (
    <div class="file" data-testid={`rules-of-${index}`}>
      <header>
        <h4>
          <Icon name="file" size={14} /> {file.name}
        </h4>
        {checked?.kind === "catalog" && <span class="tag">catalog</span>}
        <button type="button" class="tool" title="Close this file" aria-label={`Close ${file.name}`} onClick={() => checks.close(index)} data-testid={`rules-close-${index}`}>
          <Icon name="close" size={14} />
        </button>
      </header>
      {checked?.fault && <FaultBox fault={checked.fault} text={file.text} />}
      <ul>
        {checked?.rules.map((rule) => (
          <OwnRule
            key={rule.id}
            rule={rule}
            text={file.text}
            on={!file.off.includes(rule.id)}
            toggle={(on) => checks.toggle(index, rule.id, on)}
            lines={used.get(keyOf(rule.id, { kind: "file", name: file.name }))}
          />
        ))}
      </ul>
    </div>
  );
}

interface RuleProps {
  rule: CheckedRule;
  text: string;
  on: boolean;
  toggle(on: boolean): void;
  lines: readonly number[] | undefined;
}

function OwnRule({ rule, text, on, toggle, lines }: RuleProps) {
  const { id, sentence, reason, fault, verdict } = rule;
  return (
    <li class={fault ? "wrong" : on ? "on" : "off"} data-testid={`rule-${id}`} data-verdict={verdict}>
      <label>
        <input type="checkbox" checked={on && !fault} disabled={fault !== null} onChange={(event) => toggle(event.currentTarget.checked)} />
        <code>{id}</code>
      </label>
      <Work lines={lines} />
      <span class="state">
        <Icon name={verdict === "undecided" ? "warn" : fault ? "close" : "ok"} size={14} /> {fault ? WRONG[verdict] : reason}
      </span>
      <p class="sentence">
        {sentence || rule.text} <span class="at">line {rule.line}</span>
      </p>
      {fault && <FaultBox fault={fault} text={text} />}
    </li>
  );
}

const WRONG: Record<CheckedRule["verdict"], string> = { proved: "", refuted: "refuted, not used", refused: "refused, not used", undecided: "not decided, not used" };

const KINDS: Record<PluginsAnswer["plugins"][number]["kind"], string> = { shipped: "comes with gcrules", package: "installed package", folder: "named at the start" };

function Plugins({ checks, used, write }: { checks: RuleChecks; used: Used; write(rule: string): void }) {
  const now = checks.plugins.value;
  const found = now?.state === "found" ? now.answer : null;
  return (
    <section aria-label="Plugins" data-testid="bench-plugins">
      <header>
        <h3>Plugins</h3>
      </header>
      <p class="told">
        Rules in Python are code, and this page does not load any. They are in folders, or in installed packages, that are present when the studio is started:{" "}
        <code>gcrules studio --plugins DIR</code>.
      </p>
      {now?.state === "busy" && (
        <p class="busy" role="status">
          <span class="spinner" aria-hidden="true" /> {now.words} …
        </p>
      )}
      {now?.state === "failed" && <FaultBox fault={now.fault} />}
      {found && (
        <>
          {found.plugins.map(({ name, kind, rules, robots, catalogs }) => (
            <div class="file" key={name} data-testid={`plugin-${name.replace(/^\w+ /, "")}`} data-kind={kind}>
              <header>
                <h4>{name}</h4>
                <span class="tag">{KINDS[kind]}</span>
              </header>
              {robots.length + catalogs.length > 0 && (
                <p class="told">Brings {[...robots.map((robot) => `the robot ${robot}`), ...catalogs.map((file) => `the catalog ${file}`)].join(", ")}.</p>
              )}
              <ul>
                {rules.map((rule) => (
                  <Brought key={rule.id} rule={rule} lines={used.get(keyOf(rule.id, { kind: "plugin", name }))} write={write} />
                ))}
              </ul>
            </div>
          ))}
          <p class="told">
            {found.robots} more plugins come with gcrules, each of them a robot.
            {found.folders.length > 0 && ` Named at the start: ${found.folders.join(", ")}.`}
          </p>
        </>
      )}
    </section>
  );
}

function Brought({ rule, lines, write }: { rule: PluginRule; lines: readonly number[] | undefined; write(text: string): void }) {
  const { id, sentence, text, holds, reason } = rule;
  return (
    <li class={holds ? "on" : "wrong"} data-testid={`rule-${id}`} data-verdict={holds ? "proved" : "refuted"}>
      <code>{id}</code>
      <Work lines={lines} />
      <span class="state">
        <Icon name={holds ? "ok" : "close"} size={14} /> {reason}
      </span>
      <p class="sentence">
        {sentence}{" "}
        {text && holds ? (
          <button type="button" class="quiet" title="An identity of a plugin runs where it is named" onClick={() => write(`rule ${id} "${sentence.replaceAll('"', "'")}": ${text}`)} data-testid={`rule-write-${id}`}>
            Put it on the bench
          </button>
        ) : (
          holds && <span class="at">runs in every analysis</span>
        )}
      </p>
    </li>
  );
}
