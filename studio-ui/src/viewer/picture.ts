// Pictures of the view, to be taken away: SVG text, and pixels twice as fine as those of the screen.
import type { Model } from "./drawing";
import { drawPointers, svgPointers, type Pointer } from "./marks";
import { drawLabels, svgLabels, type Placed } from "./overlay";
import { colourOf } from "./palette";
import type { Sight } from "./sight";
import { element, paintSvg, type splitDrawing } from "./svg";
import type { Theme } from "./types";

export interface Shot {
  model: Model;
  split: ReturnType<typeof splitDrawing>;
  sight: Sight;
  labels: readonly Placed[];
  pointers: readonly Pointer[];
  theme: Theme;
  title: string;
}

export function svgPicture({ model, split, sight, labels, pointers, theme, title }: Shot): string {
  const { width, height } = sight;
  const paper = colourOf("paper", theme);
  const svg = element("svg", { xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `0 0 ${width} ${height}` });
  const inside = element("g", {});
  paintSvg(inside, model, split, sight, { paper, muted: colourOf("muted", theme) });
  svg.append(element("title", {}, title), element("rect", { width, height, fill: paper }), inside, ...svgPointers(pointers), ...svgLabels(labels, paper));
  return new XMLSerializer().serializeToString(svg);
}

/** A data URL of a PNG picture; `drawn` is the drawing without its labels, else it is painted from SVG. */
export async function pngPicture(shot: Shot, drawn: HTMLCanvasElement | null): Promise<string> {
  if (drawn) return pngOf(shot, drawn, shot.labels);
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgPicture(shot))}`;
  await image.decode();
  return pngOf(shot, image, []);
}

function pngOf(shot: Shot, image: CanvasImageSource, labels: readonly Placed[]): string {
  const canvas = document.createElement("canvas");
  paintPixels(canvas, shot, image, labels);
  return canvas.toDataURL("image/png");
}

export function paintPixels(canvas: HTMLCanvasElement, { sight, theme, pointers }: Shot, image: CanvasImageSource, labels: readonly Placed[]): void {
  canvas.width = 2 * sight.width;
  canvas.height = 2 * sight.height;
  const pen = canvas.getContext("2d")!;
  const paper = colourOf("paper", theme);
  pen.scale(2, 2);
  pen.fillStyle = paper;
  pen.fillRect(0, 0, sight.width, sight.height);
  pen.drawImage(image, 0, 0, sight.width, sight.height);
  drawPointers(pen, labels.length > 0 ? pointers : []); // without labels the image has them all
  drawLabels(pen, labels, paper);
}
