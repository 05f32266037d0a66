// Pointer and keys on the surface: what is pointed at, what is picked, how the keys move platform and view.
import { reachOf, type Graspable } from "./grasp";
import { placeOf, poseOf } from "./grips";
import { nudged } from "./keys";
import { spoken } from "./names";
import type { Rig } from "./rig";
import type { Grip, Pose } from "./types";

export interface Pointed {
  point?: string;
  entity?: string;
}

/** What the hand can reach. */
export interface Reach extends Graspable {
  readonly platform: Pose;
  readonly rig: Rig;
  /** Whether the platform may be moved. */
  readonly movable: boolean;
  readonly chosen: Grip | null;
  removed(id: string): void;
  inserted(id: string): void;
  under(x: number, y: number, reach: number): Pointed;
  hovered(found: Pointed | null): void;
  picked(name: string): void;
  moved(pose: Pose): void;
  done(): void;
  fit(): void;
}

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const REST = 250; // milliseconds after which a key's move counts as done

export class Hand {
  private pressed: [number, number] | null = null;
  private last: Pointed | null = null;
  private rest = 0;

  constructor(private readonly reach: Reach, stop: AbortSignal) {
    const on = <K extends keyof HTMLElementEventMap>(name: K, act: (event: HTMLElementEventMap[K]) => void) =>
      reach.surface.root.addEventListener(name, act, { signal: stop });
    on("pointermove", (e) => this.hover(e));
    on("pointerleave", () => this.point(null));
    on("pointerdown", (e) => {
      this.pressed = [e.clientX, e.clientY];
      reach.rig.halt();
    });
    on("pointerup", (e) => this.release(e));
    on("keydown", (e) => this.key(e));
    stop.addEventListener("abort", () => clearTimeout(this.rest));
  }

  /** Nothing is pointed at any more, for what was is gone. */
  forget(): void {
    this.last = null;
  }

  private under(e: PointerEvent): Pointed {
    return this.reach.under(...this.reach.surface.place(e), e.pointerType === "mouse" ? 14 : 24);
  }

  private hover(e: PointerEvent): void {
    if (e.buttons || this.reach.grabbed) return;
    const found = this.under(e);
    const grip = this.reach.mode === "pick" ? null : this.reach.gripUnder(...this.reach.surface.place(e), reachOf(e));
    if (this.reach.mode !== "pick") this.reach.surface.cursor = grip ? "move" : "grab";
    this.point(found.point || found.entity ? found : null);
    if (this.reach.mode === "pick") this.reach.surface.cursor = found.point ? "pointer" : "crosshair";
  }

  private point(found: Pointed | null): void {
    if (found?.point === this.last?.point && found?.entity === this.last?.entity) return;
    this.last = found;
    this.reach.hovered(found);
  }

  private release(e: PointerEvent): void {
    const still = this.pressed && Math.hypot(e.clientX - this.pressed[0], e.clientY - this.pressed[1]) < 6;
    this.pressed = null;
    const name = still && !this.reach.grabbed ? this.under(e).point : undefined;
    if (name) this.pick(name);
    else if (still && !this.reach.grabbed && this.reach.chosen) this.reach.chose(null);
  }

  private pick(name: string): void {
    this.reach.surface.say(`Point ${spoken(name)}`);
    this.reach.picked(name);
  }

  private key(e: KeyboardEvent): void {
    if (e.ctrlKey || e.metaKey) return;
    const { reach } = this;
    const arrow = ARROWS[e.key];
    const picking = reach.mode === "pick";
    if (!picking && !e.altKey && this.gripKey(e)) {
      e.preventDefault();
      return e.stopPropagation(); // the page has other uses for some of them
    }
    if (picking && (arrow || e.key === "Enter") && !e.altKey) this.walk(arrow);
    else if (arrow && (e.altKey || !reach.movable)) reach.rig.turn(arrow[0] * 0.12, arrow[1] * 0.12);
    else if (e.key === "+" || e.key === "=") reach.rig.zoom(1 / 1.15);
    else if (e.key === "-") reach.rig.zoom(1.15);
    else if (e.key === "Home") reach.fit();
    else {
      const pose = reach.movable && !picking ? nudged(reach.platform, e.key, e.shiftKey, reach.scene.size) : null;
      if (!pose) return;
      reach.moved(pose);
      clearTimeout(this.rest);
      this.rest = window.setTimeout(() => reach.done(), REST);
    }
    e.preventDefault();
  }

  /** Comma and full stop choose among what can be dragged; keys then move it. Whether the key was one of these. */
  private gripKey(e: KeyboardEvent): boolean {
    const { reach } = this;
    const grips = (reach.scene.grips ?? []).filter(({ look }) => look !== "between");
    const { chosen } = reach;
    if ((e.key === "." || e.key === ",") && grips.length > 0) {
      const now = grips.findIndex(({ id }) => id === chosen?.id);
      const next = grips[e.key === "." ? (now + 1) % grips.length : (Math.max(now, 0) + grips.length - 1) % grips.length]!;
      reach.chose(next.id);
      reach.surface.say(next.name);
      return true;
    }
    if (!chosen) return false;
    const [leave, remove] = [() => reach.chose(null), () => reach.removed(chosen.id)];
    const act = { Escape: leave, Delete: remove, Backspace: remove, Insert: () => reach.inserted(chosen.id) }[e.key];
    if (act) {
      act();
      return true;
    }
    const step = 100 * (chosen.step ?? reach.scene.size / 100);
    const turns = e.shiftKey && chosen.turn !== undefined;
    const pose = nudged(poseOf(chosen, reach.scene.about), e.key, turns, e.shiftKey && !turns ? 10 * step : step);
    if (!pose) return false;
    const place = placeOf(pose, reach.scene.about);
    reach.gripMoved(chosen.id, place);
    reach.surface.say(`${chosen.name}: ${place.at.map((c) => Number(c.toPrecision(4))).join(", ")}`);
    clearTimeout(this.rest);
    this.rest = window.setTimeout(() => reach.gripDone(), REST);
    return true;
  }

  /** Arrow keys walk through the points, Enter (no arrow) picks. */
  private walk(arrow: [number, number] | undefined): void {
    const names = [...this.reach.scene.base, ...this.reach.scene.platform];
    const at = this.last?.point ? names.indexOf(this.last.point) : -1;
    if (!arrow) {
      if (at >= 0) this.pick(names[at]!);
      return;
    }
    if (!names.length) return;
    const step = arrow[0] + arrow[1];
    const next = names[(Math.max(at, step < 0 ? 0 : -1) + step + names.length) % names.length]!;
    this.point({ point: next });
    this.reach.surface.say(`Point ${spoken(next)}`);
  }
}
