// What the drawing is painted on: WebGL, or SVG where there is none.
import { Scene as World, type PerspectiveCamera } from "three";
import type { Model } from "./drawing";
import type { Gizmo } from "./gizmo";
import { paintHandles } from "./handles";
import { colourOf } from "./palette";
import type { Sight } from "./sight";
import { element, paintSvg, type splitDrawing } from "./svg";
import type { Theme } from "./types";
import { WebGLPainter } from "./webgl";

export interface Easel {
  readonly kind: "webgl" | "svg";
  /** The pixels, where there are some. */
  readonly canvas: HTMLCanvasElement | null;
  hold(gizmo: Gizmo): void;
  resize(width: number, height: number): void;
  load(model: Model, split: ReturnType<typeof splitDrawing>, theme: Theme): void;
  paint(camera: PerspectiveCamera, sight: Sight): void;
  dispose(): void;
}

const FILLING = "position:absolute;inset:0;width:100%;height:100%;display:block";

export function newEasel(root: HTMLElement, wanted: "auto" | "svg", changed: () => void): Easel {
  if (wanted === "auto") {
    try {
      return new WebGLEasel(root, changed);
    } catch {
      // no WebGL on this machine: SVG shows the same
    }
  }
  return new SvgEasel(root);
}

class WebGLEasel implements Easel {
  readonly kind = "webgl";
  readonly canvas = document.createElement("canvas");
  private readonly painter: WebGLPainter;

  constructor(root: HTMLElement, changed: () => void) {
    this.canvas.style.cssText = FILLING;
    this.painter = new WebGLPainter(this.canvas);
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", changed);
    root.prepend(this.canvas);
  }
  hold(gizmo: Gizmo): void {
    this.painter.world.add(gizmo.proxy, gizmo.helper);
  }
  resize(width: number, height: number): void {
    this.painter.resize(width, height);
  }
  load(model: Model, _: unknown, theme: Theme): void {
    this.painter.load(model, colourOf("muted", theme));
  }
  paint(camera: PerspectiveCamera): void {
    this.painter.render(camera);
  }
  dispose(): void {
    this.painter.dispose();
  }
}

class SvgEasel implements Easel {
  readonly kind = "svg";
  readonly canvas = null;
  private readonly node = element("svg", { "aria-hidden": "true" });
  private readonly drawn = element("g", {});
  private readonly grips = element("g", {});
  private gizmo: Gizmo | null = null;
  private loaded: Parameters<Easel["load"]> | null = null;

  constructor(root: HTMLElement) {
    this.node.style.cssText = FILLING;
    this.node.append(this.drawn, this.grips);
    root.prepend(this.node);
  }
  hold(gizmo: Gizmo): void {
    this.gizmo = gizmo;
    new World().add(gizmo.proxy, gizmo.helper);
  }
  resize(width: number, height: number): void {
    this.node.setAttribute("viewBox", `0 0 ${width} ${height}`);
  }
  load(...all: Parameters<Easel["load"]>): void {
    this.loaded = all;
  }
  paint(_: PerspectiveCamera, sight: Sight): void {
    if (!this.loaded) return;
    const [model, split, theme] = this.loaded;
    paintSvg(this.drawn, model, split, sight, { paper: colourOf("paper", theme), muted: colourOf("muted", theme) });
    if (this.gizmo) paintHandles(this.grips, this.gizmo.helper, sight);
  }
  dispose(): void {}
}
