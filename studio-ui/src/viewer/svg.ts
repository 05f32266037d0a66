// The drawing as SVG: for machines without WebGL, and for pictures that are to be printed.
import { painted, tree, type Piece, type Tree } from "./bsp";
import type { Ball, Cone, Face, Model, Rod } from "./drawing";
import { farthestFirst, shaded } from "./mesh";
import { inFront, type Sight } from "./sight";
import type { Vec3 } from "./types";
import { along, centre, distance, mix, sub, unit } from "./vectors";

const NS = "http://www.w3.org/2000/svg";

type Drawn = { face: Face } | { rod: Rod };

/** Faces and rods, split so that they can be painted from any side. */
export function splitDrawing(model: Model): Tree<Drawn> | null {
  const pieces: Piece<Drawn>[] = [
    ...model.faces.map((face) => ({ corners: face.corners, edges: face.edges, tag: { face } })),
    ...model.rods.flatMap((rod) => stretches(rod, model).map((corners) => ({ corners, edges: [], tag: { rod } }))),
  ];
  return tree(pieces, 1e-6 * model.radius);
}

/** A rod in one, or in short parts where a curved surface may hide some of it. */
function stretches({ a, b }: Rod, { veil, radius }: Model): Vec3[][] {
  const count = veil ? Math.max(1, Math.round(distance(a, b) / (0.08 * radius))) : 1;
  return Array.from({ length: count }, (_, k) => [mix(a, b, k / count), mix(a, b, (k + 1) / count)]);
}

export function element(name: string, attributes: Record<string, string | number>, text?: string): SVGElement {
  const found = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes))
    found.setAttribute(key, typeof value === "number" ? String(Math.round(value * 100) / 100) : value);
  if (text !== undefined) found.textContent = text;
  return found;
}

/** Everything but the labels, farthest first. */
export function paintSvg(root: SVGElement, model: Model, split: Tree<Drawn> | null, sight: Sight, ink: { paper: string; muted: string }): void {
  const nodes: SVGElement[] = [];
  const flat = (corners: readonly Vec3[]) => inFront(sight, corners).map((c) => sight.place(c));
  const stroke = (a: Vec3, b: Vec3, colour: string, width: number, more: Record<string, string | number> = {}) => {
    const [p, q] = flat([a, b]);
    if (!p || !q) return;
    nodes.push(element("line", { x1: p[0], y1: p[1], x2: q[0], y2: q[1], stroke: colour, "stroke-width": width, ...more }));
  };
  for (const [a, b] of model.grid) stroke(a, b, ink.muted, 0.8, { "stroke-opacity": 0.28 });
  const { veil } = model;
  const waiting = veil ? farthestFirst(veil, sight.eye) : [];
  let next = 0;
  for (const piece of painted(split, sight.eye)) {
    veiled(distance(centre(piece.corners), sight.eye));
    if ("face" in piece.tag) facePiece(piece, piece.tag.face);
    else rodPiece(piece, piece.tag.rod);
  }
  veiled(0);
  for (const cone of model.cones) head(cone);
  const nearestLast = [...model.balls].sort((a, b) => distance(b.at, sight.eye) - distance(a.at, sight.eye));
  for (const one of nearestLast) disc(one);
  root.replaceChildren(...nodes);

  /** What of the curved surface is farther than that and not there yet. */
  function veiled(depth: number): void {
    if (!veil) return;
    for (; next < waiting.length && distance(veil.middles[waiting[next]!]!, sight.eye) > depth; next++) {
      const i = waiting[next]!;
      const at = flat(veil.triangles[i]!.map((k) => veil.corners[k]!));
      if (at.length < 3) continue;
      const points = at.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ");
      // neighbours meet without a seam where edges are not smoothed
      nodes.push(element("polygon", { points, fill: shaded(veil, i, sight.eye), "fill-opacity": veil.fill, "shape-rendering": "crispEdges" }));
    }
  }
  function facePiece(piece: Piece<Drawn>, face: Face): void {
    const at = flat(piece.corners);
    if (at.length < 3) return;
    const points = at.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ");
    nodes.push(element("polygon", { points, fill: face.colour, "fill-opacity": face.fill }));
    piece.corners.forEach((a, i) => {
      const b = piece.corners[(i + 1) % piece.corners.length]!;
      if (piece.edges[i]) stroke(a, b, face.colour, Math.max(1, 2 * face.rim * sight.scale(sight.place(a)[2])), { "stroke-linecap": "round" });
    });
  }
  function rodPiece(piece: Piece<Drawn>, rod: Rod): void {
    const [a, b] = piece.corners as [Vec3, Vec3];
    const width = Math.max(1.1, 2 * rod.radius * sight.scale((sight.place(a)[2] + sight.place(b)[2]) / 2));
    const gap = 3.2 * width / sight.scale(sight.place(a)[2]);
    // a clear stretch around a leg where it passes in front of another
    if (rod.solid && distance(a, b) > 3 * gap) {
      const u = unit(sub(b, a));
      stroke(along(a, u, gap), along(b, u, -gap), ink.paper, width + 3, { "stroke-opacity": 0.75 });
    }
    stroke(a, b, rod.colour, width, { "stroke-linecap": "round" });
  }
  function head(cone: Cone): void {
    const [tip, base] = [sight.place(cone.tip), sight.place(cone.base)];
    if (tip[2] < sight.near || base[2] < sight.near) return;
    const width = cone.radius * sight.scale(base[2]);
    const [dx, dy] = [tip[0] - base[0], tip[1] - base[1]];
    const long = Math.hypot(dx, dy);
    if (long < width / 2) return void nodes.push(element("circle", { cx: tip[0], cy: tip[1], r: width, fill: cone.colour }));
    const [nx, ny] = [(-dy / long) * width, (dx / long) * width];
    const points = [[tip[0], tip[1]], [base[0] + nx, base[1] + ny], [base[0] - nx, base[1] - ny]];
    nodes.push(element("polygon", { points: points.map((p) => p.map((c) => c.toFixed(2)).join(",")).join(" "), fill: cone.colour }));
  }
  function disc(ball: Ball): void {
    const [x, y, depth] = sight.place(ball.at);
    if (depth < sight.near) return;
    const k = sight.scale(depth);
    const width = (ball.outer - ball.radius) * k;
    nodes.push(
      element("circle", { cx: x, cy: y, r: ball.radius * k + width / 2, fill: ball.fill, stroke: ball.rim, "stroke-width": width }),
    );
  }
}
