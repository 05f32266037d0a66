// The directions of the axes in a corner of the view.
import { Vector3, type PerspectiveCamera } from "three";
import type { Box } from "./labels";
import { UPRIGHT } from "./overlay";
import { colourOf } from "./palette";
import { element } from "./svg";
import type { Theme } from "./types";

const HALF = 34;
const REACH = 22;
const GAUGE = 80; // pixels that the width of a square takes beside it

/** The corner of the view that it takes, with the words beside it. */
export const compassBox = (height: number): Box => [0, height - 2 * HALF, 2 * HALF + GAUGE, height];

export class Compass {
  readonly node = element("svg", { viewBox: `${-HALF} ${-HALF} ${2 * HALF} ${2 * HALF}`, width: 2 * HALF, height: 2 * HALF });
  private readonly axes = ["x", "y", "z"].map((name) => {
    const line = element("line", { x1: 0, y1: 0, "stroke-width": 1.6, "stroke-linecap": "round" });
    const text = element("text", { "text-anchor": "middle", "font-size": 11, "font-family": UPRIGHT }, name);
    this.node.append(line, text);
    return { line, text };
  });

  constructor() {
    this.node.setAttribute("aria-hidden", "true");
    this.node.style.cssText = `position:absolute;left:.4rem;bottom:.2rem;pointer-events:none;width:${2 * HALF}px;height:${2 * HALF}px`;
  }

  turn(camera: PerspectiveCamera, theme: Theme): void {
    const muted = colourOf("muted", theme);
    this.axes.forEach(({ line, text }, i) => {
      const { x, y } = new Vector3().setComponent(i, 1).transformDirection(camera.matrixWorldInverse);
      line.setAttribute("x2", (REACH * x).toFixed(1));
      line.setAttribute("y2", (-REACH * y).toFixed(1));
      line.setAttribute("stroke", muted);
      const out = 1 + 7 / (REACH * Math.hypot(x, y) + 1e-6);
      const far = Math.min(out, 8);
      text.setAttribute("x", (REACH * x * far).toFixed(1));
      text.setAttribute("y", (-REACH * y * far + 3.5).toFixed(1));
      text.setAttribute("fill", muted);
    });
  }
}
