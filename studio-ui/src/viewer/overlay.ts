// Labels over the drawing: HTML while it lives, text in pictures.
import type { Model, Tag } from "./drawing";
import { placed, type Box, type Wish } from "./labels";
import { runs } from "./names";
import type { Sight } from "./sight";
import { element } from "./svg";

export interface Placed {
  tag: Tag;
  x: number;
  y: number;
  size: number;
}

const SIZES = { joint: 19, construction: 19, entity: 15 } as const;
const RANKS = { joint: 3, construction: 4, entity: 1 } as const;
const HALO = 3; // pixels: the width of its stroke
const ITALIC = '"KaTeX_Math", "STIX Two Text", "Latin Modern Roman", Cambria, "Liberation Serif", Georgia, serif';
export const UPRIGHT = 'system-ui, "Segoe UI", "Liberation Sans", sans-serif';

/** The labels of what is in front of the eye and on the screen, clear of the boxes that are taken. */
export function placeTags(model: Model, sight: Sight, taken: readonly Box[]): Placed[] {
  const shown: { tag: Tag; wish: Wish; size: number }[] = [];
  const [cx, cy] = sight.place(model.middle);
  for (const tag of model.tags) {
    const [x, y, depth] = sight.place(tag.at);
    if (depth < sight.near || x < -20 || y < -20 || x > sight.width + 20 || y > sight.height + 20) continue;
    const size = SIZES[tag.look] * sight.letter * (tag.strong ? 1.12 : 1);
    const radius = tag.clear * sight.scale(depth) + 1;
    const wish = { x, y, radius, width: widthOf(tag, size), height: size * 1.05, toward: [x - cx, y - cy + (y < cy ? -30 : 30)] as [number, number] };
    shown.push({ tag, size, wish: { ...wish, rank: RANKS[tag.look] + (tag.strong ? 5 : 0) } });
  }
  const discs = model.balls.map((b): [number, number, number] => {
    const [x, y, depth] = sight.place(b.at);
    return [x, y, b.outer * sight.scale(depth)];
  });
  const strokes = model.rods
    .filter((r) => r.solid)
    .map((r): [number, number, number, number] => {
      const [a, b] = [sight.place(r.a), sight.place(r.b)];
      return [a[0], a[1], b[0], b[1]];
    });
  const places = placed(shown.map((s) => s.wish), discs, strokes, taken, sight.width, sight.height);
  // a label that would cover another gives way if it is less important
  return shown.flatMap(({ tag, size }, i) => (places[i]!.covered > 30 && !tag.strong && tag.look !== "joint" ? [] : [{ tag, size, x: places[i]!.x, y: places[i]!.y }]));
}

let pen: CanvasRenderingContext2D | null = null;
const widths = new Map<string, number>();

export function widthOf(tag: Pick<Tag, "text" | "upright">, size: number): number {
  const key = `${tag.upright}${size}${tag.text}`;
  let width = widths.get(key);
  if (width === undefined) {
    pen ??= document.createElement("canvas").getContext("2d");
    width = 3;
    for (const run of tag.upright ? [{ text: tag.text, style: "plain" as const }] : runs(tag.text)) {
      if (pen) pen.font = fontOf(run.style, size);
      width += pen ? pen.measureText(run.text).width : 0.6 * size * run.text.length;
    }
    widths.set(key, width);
  }
  return width;
}

const fontOf = (style: "italic" | "sub" | "plain", size: number): string =>
  `${style === "italic" ? "italic " : ""}${style === "sub" ? size * 0.72 : size}px ${style === "plain" ? UPRIGHT : ITALIC}`;

/** Keeps two elements for each label, its halo and its text, and moves them: a filter, or a layer for each, costs more than the drawing. */
export class LabelLayer {
  readonly node = document.createElement("div");
  private readonly labels: { halo: HTMLElement; text: HTMLElement; key: string }[] = [];

  constructor() {
    this.node.setAttribute("aria-hidden", "true");
    this.node.style.cssText = "position:absolute;inset:0;overflow:hidden;pointer-events:none;user-select:none";
  }

  show(labels: readonly Placed[], paper: string): void {
    while (this.labels.length < labels.length) {
      const [halo, text] = [document.createElement("b"), document.createElement("span")];
      for (const node of [halo, text]) node.style.cssText = "position:absolute;left:0;top:0;white-space:pre;line-height:1";
      this.node.append(halo, text);
      this.labels.push({ halo, text, key: "" });
    }
    this.labels.forEach((shown, i) => {
      const label = labels[i];
      shown.halo.hidden = shown.text.hidden = !label;
      if (!label) return;
      const key = [label.tag.text, label.tag.upright, label.tag.colour, label.tag.strong, label.size, paper].join("|");
      if (key !== shown.key) {
        shown.key = key;
        // all of the halo beneath: that of a run would cover the run before it
        fill(shown.halo, label, paper);
        shown.halo.style.webkitTextStroke = `${HALO}px ${paper}`;
        fill(shown.text, label, label.tag.colour);
      }
      for (const node of [shown.halo, shown.text])
        node.style.transform = `translate(${label.x.toFixed(1)}px,${label.y.toFixed(1)}px) translate(-50%,-50%)`;
    });
  }
}

function fill(node: HTMLElement, { tag, size }: Placed, colour: string): void {
  node.style.color = colour;
  node.style.fontSize = `${size}px`;
  node.style.fontWeight = tag.strong ? "700" : "400";
  const parts = tag.upright ? [{ text: tag.text, style: "plain" as const }] : runs(tag.text);
  node.replaceChildren(
    ...parts.map((run) => {
      const part = document.createElement("span");
      part.textContent = run.text;
      part.style.fontFamily = run.style === "plain" ? UPRIGHT : ITALIC;
      if (run.style === "italic") part.style.fontStyle = "italic";
      if (run.style === "sub") part.style.cssText += ";font-size:.72em;position:relative;top:.28em";
      return part;
    }),
  );
}

/** The labels as text of an SVG picture, each with a halo. */
export function svgLabels(labels: readonly Placed[], paper: string): SVGElement[] {
  const round = { stroke: paper, "stroke-width": HALO, "stroke-linejoin": "round", "aria-hidden": "true", class: "halo" };
  // all of the halo first: that of a run would cover the run before it
  return labels.flatMap((label) => [lettered(label, { fill: paper, ...round }), lettered(label, { fill: label.tag.colour })]);
}

function lettered({ tag, x, y, size }: Placed, paint: Record<string, string | number>): SVGElement {
  const text = element("text", { x, y: y + size * 0.34, "text-anchor": "middle", "font-size": size, "font-weight": tag.strong ? 700 : 400, ...paint });
  let lowered = false;
  for (const run of tag.upright ? [{ text: tag.text, style: "plain" as const }] : runs(tag.text)) {
    const low = run.style === "sub";
    const span = element("tspan", { "font-family": run.style === "plain" ? UPRIGHT : ITALIC, ...(run.style === "italic" ? { "font-style": "italic" } : {}), ...(low ? { "font-size": size * 0.72 } : {}), ...(low !== lowered ? { dy: (low ? 0.22 : -0.22) * size } : {}) }, run.text);
    lowered = low;
    text.append(span);
  }
  return text;
}

/** The labels onto a picture of pixels. */
export function drawLabels(pen: CanvasRenderingContext2D, labels: readonly Placed[], paper: string): void {
  pen.textBaseline = "alphabetic";
  pen.lineJoin = "round";
  for (const { tag, x, y, size } of labels) {
    const parts = tag.upright ? [{ text: tag.text, style: "plain" as const }] : runs(tag.text);
    const wide = parts.map((run) => ((pen.font = fontOf(run.style, size)), pen.measureText(run.text).width));
    for (const halo of [true, false]) {
      let left = x - wide.reduce((a, b) => a + b, 0) / 2;
      parts.forEach((run, i) => {
        pen.font = `${tag.strong ? "bold " : ""}${fontOf(run.style, size)}`;
        const base = y + size * (run.style === "sub" ? 0.56 : 0.34);
        if (halo) {
          pen.strokeStyle = paper;
          pen.lineWidth = HALO;
          pen.strokeText(run.text, left, base);
        } else {
          pen.fillStyle = tag.colour;
          pen.fillText(run.text, left, base);
        }
        left += wide[i]!;
      });
    }
  }
}
