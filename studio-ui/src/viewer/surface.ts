// The elements of a viewer: what takes pointer and keys, the labels over the drawing, and what is said aloud.
import type { PerspectiveCamera } from "three";
import { Compass } from "./compass";
import type { Model } from "./drawing";
import { GRIPS, HELP } from "./keys";
import { svgPointers, type Pointer } from "./marks";
import { sideBySide, spoken } from "./names";
import { LabelLayer, UPRIGHT, type Placed } from "./overlay";
import { colourOf } from "./palette";
import { element } from "./svg";
import type { Scene, Theme } from "./types";

export class Surface {
  readonly root = document.createElement("div");
  private readonly labels = new LabelLayer();
  private readonly pointers = element("svg", { "aria-hidden": "true", "data-marks": "" });
  private readonly compass = new Compass();
  private readonly gauge = document.createElement("div");
  private readonly voice = document.createElement("div");

  constructor(host: HTMLElement, private readonly help: boolean) {
    const { root, voice, gauge } = this;
    root.className = "gcrules-viewer";
    root.tabIndex = 0;
    root.setAttribute("role", "application");
    root.setAttribute("aria-roledescription", "three-dimensional view");
    root.style.cssText = "position:relative;width:100%;height:100%;overflow:hidden;touch-action:none;cursor:grab";
    voice.setAttribute("aria-live", "polite");
    voice.style.cssText = "position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)";
    gauge.style.cssText = `position:absolute;left:4.6rem;bottom:.7rem;font:.75rem ${UPRIGHT};pointer-events:none`;
    this.pointers.style.cssText = "position:absolute;inset:0;width:100%;height:100%;pointer-events:none";
    root.append(this.pointers, this.labels.node, this.compass.node, gauge, voice);
    this.describe(null);
    host.append(root);
  }

  set cursor(name: string) {
    this.root.style.cursor = name;
  }

  say(words: string): void {
    this.voice.textContent = words;
  }

  /** What there is, and how to move it, for those who do not see it. */
  describe(scene: Scene | null): void {
    this.root.setAttribute("aria-label", `${scene ? titleOf(scene) : "Robot"}, in three dimensions. ${this.help ? HELP : ""}${scene?.grips?.length ? ` ${GRIPS}` : ""}`);
  }

  paint(theme: Theme): void {
    this.root.style.background = colourOf("paper", theme);
    this.gauge.style.color = colourOf("muted", theme);
  }

  /** The ground and the directions of the axes are seen or not. */
  measure(on: boolean): void {
    this.compass.node.style.visibility = this.gauge.style.visibility = on ? "" : "hidden";
  }

  show(model: Model, labels: readonly Placed[], pointers: readonly Pointer[], camera: PerspectiveCamera, theme: Theme): void {
    this.gauge.textContent = model.gauge ? `grid ${model.gauge}` : "";
    this.compass.turn(camera, theme);
    if (pointers.length > 0 || this.pointers.firstChild) this.pointers.replaceChildren(...svgPointers(pointers));
    this.labels.show(labels, colourOf("paper", theme));
  }

  /** The place of a pointer, in pixels from the upper left corner. */
  place(e: PointerEvent): [number, number] {
    const box = this.root.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  }
}

export const titleOf = ({ legs, surface }: Scene): string =>
  `Robot with legs ${legs.map((leg) => spoken(sideBySide(leg))).join(", ")}${surface?.faces.length ? ", and its singular surface" : ""}`;
