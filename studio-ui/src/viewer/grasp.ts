// The pointer on a grip: it is dragged in the plane of the view, and chosen where it is only pressed.
import { IDENTITY } from "./pose";
import type { Sight } from "./sight";
import type { Surface } from "./surface";
import type { Grip, Mode, Place, Scene } from "./types";
import { add } from "./vectors";

/** What a grasp reaches. */
export interface Graspable {
  readonly mode: Mode;
  readonly scene: Scene;
  readonly surface: Surface;
  /** Whether the pointer is over a handle, which goes first. */
  readonly grabbed: boolean;
  readonly sight: Sight;
  gripUnder(x: number, y: number, reach: number): Grip | null;
  chose(id: string | null): void;
  gripMoved(id: string, place: Place): void;
  gripDone(): void;
}

const STILL = 4; // pixels that a pressing hand may tremble

/** How far from a grip a pointer may be, in pixels. */
export const reachOf = (e: PointerEvent): number => (e.pointerType === "mouse" ? 12 : 24);

export class Grasp {
  private held: { grip: Grip; start: [number, number]; moved: boolean } | null = null;

  constructor(private readonly reach: Graspable, stop: AbortSignal) {
    // before the camera and the handles hear of it
    const on = (name: "pointerdown" | "pointermove" | "pointerup" | "pointercancel", act: (e: PointerEvent) => void) =>
      reach.surface.root.addEventListener(name, act, { signal: stop, capture: true });
    on("pointerdown", (e) => this.down(e));
    on("pointermove", (e) => this.move(e));
    on("pointerup", (e) => this.up(e));
    on("pointercancel", (e) => this.up(e));
    window.addEventListener("keydown", (e) => this.cancel(e), { signal: stop, capture: true });
  }

  /** Escape, and undo amid a drag, take it back; the page's own undo would change what is held. */
  private cancel(e: KeyboardEvent): void {
    const { held, reach } = this;
    const undo = (e.ctrlKey || e.metaKey) && e.key.toLowerCase() === "z";
    if (!held || !(undo || e.key === "Escape")) return;
    this.held = null;
    e.preventDefault();
    e.stopImmediatePropagation();
    if (!held.moved) return;
    const { id, at, turn = IDENTITY.quaternion } = held.grip;
    reach.gripMoved(id, { at, turn });
    reach.gripDone();
  }

  private down(e: PointerEvent): void {
    const { reach } = this;
    if (this.held) return e.stopImmediatePropagation(); // a second finger
    if (e.button !== 0 || reach.mode === "pick" || reach.grabbed) return;
    const start = reach.surface.place(e);
    const grip = reach.gripUnder(...start, reachOf(e));
    if (!grip) return;
    this.held = { grip, start, moved: false };
    reach.surface.root.setPointerCapture(e.pointerId);
    e.stopImmediatePropagation();
  }

  private move(e: PointerEvent): void {
    const { held, reach } = this;
    if (!held) return;
    e.stopImmediatePropagation();
    const [x, y] = reach.surface.place(e);
    const [dx, dy] = [x - held.start[0], y - held.start[1]];
    if (!held.moved && Math.hypot(dx, dy) < STILL) return;
    held.moved = true;
    const { sight } = reach;
    const { id, at, turn = IDENTITY.quaternion } = held.grip;
    reach.gripMoved(id, { at: add(at, sight.shift(dx, dy, sight.place(at)[2])), turn });
  }

  private up(e: PointerEvent): void {
    const { held, reach } = this;
    if (!held) return;
    this.held = null;
    e.stopImmediatePropagation();
    if (held.moved) reach.gripDone();
    else reach.chose(held.grip.id);
  }
}

