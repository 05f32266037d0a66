// The handles that move and turn the platform.
import { Object3D, Quaternion, Vector3, type PerspectiveCamera } from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import { normalised } from "./pose";
import type { Mode, Pose, Vec3 } from "./types";
import { add, sub } from "./vectors";

const LOW = 480; // pixels
const TIPS = { translate: 0.6, rotate: 0.75 }; // how far three's handles reach, in their own unit
const FACING = 0.9; // the least cosine between the axis of a ring and the line of sight
const AXES: Record<string, Vector3> = { X: new Vector3(1, 0, 0), Y: new Vector3(0, 1, 0), Z: new Vector3(0, 0, 1) };

/** Where handles are, and how far they reach: at the distance 1, where half the height of the picture is 1. */
export interface Extent {
  at: Vec3;
  reach: number;
}

export interface GizmoEvents {
  moved(pose: Pose): void;
  done(): void;
  dragging(on: boolean): void;
  changed(): void;
}

export class Gizmo {
  readonly helper: Object3D;
  readonly proxy = new Object3D();
  private readonly controls: TransformControls;
  private about: Vec3 = [0, 0, 0];
  private size = 1;

  constructor(camera: PerspectiveCamera, surface: HTMLElement, on: GizmoEvents) {
    this.controls = new TransformControls(camera, surface);
    this.controls.setSpace("world");
    this.controls.setColors(0xd1495b, 0x3a9d5d, 0x3b7dd8, 0xe6a100);
    this.controls.attach(this.proxy);
    this.helper = this.controls.getHelper();
    const update = this.helper.updateMatrixWorld.bind(this.helper);
    this.helper.updateMatrixWorld = (force) => {
      update(force);
      this.faceRing();
    };
    this.controls.addEventListener("objectChange", () => on.moved(this.pose));
    this.controls.addEventListener("mouseUp", () => on.done());
    this.controls.addEventListener("dragging-changed", ({ value }) => on.dragging(Boolean(value)));
    this.controls.addEventListener("change", () => on.changed());
    this.setMode("orbit");
  }

  /** A ring that is seen nearly from its axis turns as one that is seen from it: with the pointer, around its middle. */
  private faceRing(): void {
    const axis = AXES[this.controls.axis ?? ""];
    const { eye } = this.controls as unknown as { eye: Vector3 };
    if (this.controls.mode === "rotate" && axis && Math.abs(eye.dot(axis)) > FACING) eye.copy(axis).multiplyScalar(Math.sign(eye.dot(axis)));
  }

  private get pose(): Pose {
    const { x, y, z, w } = this.proxy.quaternion;
    return { translation: sub(this.proxy.position.toArray() as Vec3, this.about), quaternion: normalised([w, x, y, z]) };
  }

  get dragging(): boolean {
    return this.controls.dragging;
  }
  /** Whether the pointer is over a handle. */
  get grabbed(): boolean {
    return this.controls.enabled && this.controls.axis !== null;
  }

  place(pose: Pose, about: Vec3): void {
    this.about = about;
    if (this.controls.dragging) return;
    const [w, x, y, z] = pose.quaternion;
    this.proxy.position.set(...add(about, pose.translation));
    this.proxy.quaternion.copy(new Quaternion(x, y, z, w));
    this.proxy.updateMatrixWorld();
  }

  /** The handles grow with the picture; in a low one they are kept large enough for a finger. */
  resize(height: number): void {
    this.size = Math.min(Math.max(LOW / height, 1), 2);
    this.controls.setSize(this.size);
  }

  /** None where no handles are shown. */
  get extent(): Extent | null {
    const { mode } = this.controls;
    if (!this.controls.enabled || mode === "scale") return null;
    return { at: this.proxy.position.toArray() as Vec3, reach: (1.9 * TIPS[mode] * this.size) / 4 }; // as three scales them
  }

  setMode(mode: Mode): void {
    const on = mode === "translate" || mode === "rotate";
    this.controls.enabled = this.helper.visible = on;
    if (!on) this.controls.axis = null;
    else this.controls.setMode(mode);
  }

  dispose(): void {
    this.controls.detach();
    this.controls.dispose();
  }
}
