// The viewer in a notebook cell. The pose goes both ways; what the kernel computes for it is shown beside.
import { explore } from "./explorer";
import type { Pose, Scene } from "./types";

interface Traits {
  scene: Scene;
  pose: Pose;
}
interface Model {
  get<K extends keyof Traits>(name: K): Traits[K];
  set<K extends keyof Traits>(name: K, value: Traits[K]): void;
  save_changes(): void;
  on(event: string, act: () => void): void;
  off(event: string, act: () => void): void;
}

const same = (a: Pose, b: Pose): boolean => JSON.stringify(a) === JSON.stringify(b);

function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  const explorer = explore(el, model.get("scene"), {
    onPose(pose, done) {
      sent = pose;
      clearTimeout(timer);
      timer = setTimeout(send, done ? 0 : 60); // the kernel need not follow every frame of a drag
    },
  });
  const send = () => {
    model.set("pose", sent);
    model.save_changes();
  };
  let timer: ReturnType<typeof setTimeout> | undefined;
  let sent = model.get("pose");
  explorer.setPose(sent);
  const posed = () => {
    const pose = model.get("pose");
    if (!same(pose, sent)) explorer.setPose((sent = pose));
  };
  const staged = () => explorer.setScene(model.get("scene"));
  model.on("change:pose", posed);
  model.on("change:scene", staged);
  return () => {
    clearTimeout(timer);
    model.off("change:pose", posed);
    model.off("change:scene", staged);
    explorer.dispose();
  };
}

export const widget = { render };
