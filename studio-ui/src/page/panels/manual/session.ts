// A session by hand. The document holds its commands; the server replays them and answers with the board.
import { computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Fault, Manual } from "../../../protocol";
import type { Store } from "../../state/store";
import { faultOf } from "../../state/studying";

export interface Hand {
  manual: ReadonlySignal<Manual | null>;
  /** What is being worked on, in words. */
  busy: ReadonlySignal<string | null>;
  fault: ReadonlySignal<{ fault: Fault; command: string } | null>;
  canBack: ReadonlySignal<boolean>;
  canAgain: ReadonlySignal<boolean>;
  propose(command: string): void;
  /** Takes back the last proposal that was not refused, and brings it back. */
  back(): void;
  again(): void;
  restart(): void;
  stop(): void;
  dispose(): void;
}

export function createHand({ client, source$, commands$, study, edit }: Store): Hand {
  const manual = signal<Manual | null>(null);
  const busy = signal<string | null>(null);
  const fault = signal<{ fault: Fault; command: string } | null>(null);
  let known = "";
  let running: AbortController | null = null;

  const keyOf = (commands: readonly string[]) => JSON.stringify([source$.peek(), commands]);

  /** Commands with a fault are not taken into the document where they were just `given`. */
  async function replay(commands: readonly string[], given?: string): Promise<void> {
    const source = source$.peek();
    if (!source) return;
    const before = running;
    const mine = new AbortController();
    running = mine;
    before?.abort();
    busy.value = given ?? "Replaying the session";
    try {
      const found = await client.ask(
        "manual",
        { source, commands: [...commands] },
        { channel: "manual", signal: mine.signal },
      );
      if (running !== mine) return;
      fault.value = found.fault && { fault: found.fault, command: given ?? commands[found.history.length] ?? "" };
      if (found.fault && given !== undefined) return;
      known = keyOf(commands);
      manual.value = found;
      if (given !== undefined) edit({ commands: [...commands] });
    } catch (error) {
      const said = faultOf(error);
      const quiet = said.kind === "cancelled" || said.kind === "superseded";
      if (running === mine && !quiet) fault.value = { fault: said, command: given ?? "" };
    } finally {
      if (running === mine) {
        running = null;
        busy.value = null;
      }
    }
  }

  const stopEffect = effect(() => {
    const commands = commands$.value;
    if (!study.value || keyOf(commands) === known) return;
    known = keyOf(commands);
    void replay(commands);
  });

  /** A new proposal stands behind those that still stand; what was taken back is forgotten. */
  const standing = () => (manual.peek()?.history ?? []).map(({ command }) => command);

  return {
    manual,
    busy,
    fault,
    canBack: computed(() => manual.value?.history.some(({ answer }) => answer !== "refused") ?? false),
    canAgain: computed(() => takenBack(commands$.value) > 0),
    propose: (command) => void replay([...standing(), command], command),
    back: () => void replay([...commands$.peek(), "undo"], "undo"),
    again: () => void replay([...commands$.peek(), "redo"], "redo"),
    restart: () => void replay([], ""),
    stop() {
      running?.abort();
      running = null;
      busy.value = null;
    },
    dispose() {
      stopEffect();
      running?.abort();
      running = null;
    },
  };
}

function takenBack(commands: readonly string[]): number {
  return commands.reduce((depth, command) => {
    const by = { undo: 1, redo: -1 }[command];
    return by === undefined ? 0 : depth + by;
  }, 0);
}
