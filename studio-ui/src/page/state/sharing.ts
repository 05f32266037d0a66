// The pose that Python shares with the page it has opened: who moves the robot tells the others.
import { computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Pose, Source } from "../../protocol";
import type { Client } from "../net/client";
import { latest } from "../net/latest";
import { samePose, sameSource } from "./doc";
import type { Editing } from "./editing";

export interface Sharing {
  /** Whether the robot on show is the one that Python moves too. */
  active: ReadonlySignal<boolean>;
  begin(opened: Source): void;
}

export function createSharing(client: Client, { source$, pose$, edit }: Editing): Sharing {
  const page = crypto.randomUUID();
  const opened = signal<Source | null>(null);
  const active = computed(() => opened.value !== null && sameSource(opened.value, source$.value));
  let heard: Pose | null = null; // until the first pose has come the page's own counts for nothing

  const show = latest(
    (asked: { source: Source; pose: Pose }) => client.ask("show", { page, ...asked }, { channel: "show" }),
    () => undefined,
    () => undefined,
  );

  async function follow(): Promise<void> {
    for (let after = 0; ; ) {
      const found = await client.ask("follow", { page, after }).catch(() => null);
      if (!found) return void (opened.value = null); // another server has come
      after = found.after;
      heard = found.pose;
      if (active.peek()) edit({ pose: found.pose }, "shared");
    }
  }

  effect(() => {
    const [source, pose] = [source$.value, pose$.value];
    if (source && heard && active.value && !samePose(pose, heard)) {
      heard = pose;
      show({ source, pose });
    }
  });

  return {
    active,
    begin(robot) {
      opened.value = robot;
      void follow();
    },
  };
}
