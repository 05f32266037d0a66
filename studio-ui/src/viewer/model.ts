// The robot, its surroundings and the entities of its condition, as a drawing.
import { Drawing, SIZES, jointsOf, type Model, type State } from "./drawing";
import { drawnWay } from "./grips";
import { drawnLimbs } from "./limbs";
import { drawnMesh } from "./mesh";
import { drawnMotion, swung } from "./motion";
import { constructedAt } from "./numbers";
import { legible } from "./palette";
import { body, disc, patch, stretched, throughBall, volume, type Outline } from "./solids";
import type { Constructed, Scene, SceneEntity, Vec3 } from "./types";
import { along, centre, cross, distance, dot, unit } from "./vectors";

/** Letters of an entity's name that are written beside it; a longer one stands in the legend alone. */
const LONGEST_LABEL = 20;

export function modelOf(scene: Scene, state: State): Model {
  const d = new Drawing(scene, state);
  if (d.shows("grid")) ground(d);
  bodies(d, scene.points, 0);
  if (d.shows("legs")) legs(d);
  const carried = d.shows("motion") && scene.motion && state.swing !== null ? swung(scene, scene.motion, state.swing) : null;
  if (d.shows("entities")) {
    // of a platform on six legs they follow from the places of the joints, and are those of the pose that is swung to
    const { recipe } = scene;
    const there = carried && recipe ? { ...scene, points: carried, constructed: constructedAt(scene, recipe, carried) } : scene;
    const strength = carried && !recipe ? 0.4 : 1; // what moves comes first
    const met = there.constructed?.some(({ kind }) => kind === "point") ? null : (scene.constructed ?? null); // they are seen to part there
    there.entities.forEach((entity) => entityShape(d, there, entity, strength, met));
    constructions(d, there);
  }
  if (d.shows("wrenches")) drawnLimbs(d);
  if (d.shows("surface") && scene.surface?.faces.length) {
    drawnMesh(d, scene.surface);
    const radius = 0.8 * SIZES.joint * scene.size;
    d.ball(state.centre, radius, d.colour("paper"), d.colour("mark"), 1.5);
    d.tag("centre", state.centre, d.colour("mark"), "entity", { clear: 1.5 * radius, upright: true });
  }
  if (scene.ghost) bodies(d, { ...scene.points, ...scene.ghost }, 0.6, true);
  if (d.shows("motion") && scene.motion) {
    drawnMotion(d, scene.motion);
    if (carried) bodies(d, carried, 0.25, true);
  }
  if (d.shows("way")) drawnWay(d, scene);
  joints(d);
  return d;
}

function bodies(d: Drawing, points: Record<string, Vec3>, pale: number, ghost = false): void {
  for (const role of ghost ? (["platform"] as const) : (["base", "platform"] as const)) {
    const named = d.scene[role].flatMap((n) => (points[n] ? [points[n]] : []));
    const own = d.scene.skeleton?.[role] ?? (role === "platform" ? d.scene.plate : undefined);
    const corners = named.length < 3 && !ghost && own ? own : named;
    const colour = d.pale(ghost ? d.colour("mark") : d.colour(role), pale);
    const rim = SIZES.edge * d.scene.size;
    for (const outline of body(corners)) d.faces.push({ ...outline, colour, fill: 0.26, rim });
    if (corners.length === 2) d.line(corners[0]!, corners[1]!, colour, { radius: rim * 1.6 });
    if (ghost) corners.forEach((at) => d.ball(at, 0.6 * SIZES.joint * d.scene.size, colour, colour));
  }
  if (ghost)
    for (const [a, b] of d.scene.legs)
      if (points[a] && points[b]) d.line(points[a], points[b], d.pale(d.colour("mark"), 0.6), { radius: SIZES.edge * d.scene.size });
}

function legs(d: Drawing): void {
  const marked = new Set((d.state.highlight?.legs ?? []).map((l) => [...l].sort().join("\n")));
  const coloured = new Map(d.scene.entities.flatMap((e) => (e.kind === "line" ? [[[...e.points].sort().join("\n"), e.colour]] : []) as [string, number][]));
  const robot = Boolean(d.scene.limbs?.length);
  for (const [a, b] of d.scene.legs) {
    const [p, q] = [d.scene.points[a], d.scene.points[b]];
    if (!p || !q || distance(p, q) < 1e-9 * d.scene.size) continue;
    const key = [a, b].sort().join("\n");
    const entity = d.shows("entities") ? coloured.get(key) : undefined;
    const colour = marked.has(key) ? d.colour("mark") : entity !== undefined ? d.entityColour(entity) : d.colour("leg");
    const width = marked.has(key) ? 1.5 : robot ? 0.55 : 1;
    d.rods.push({ a: p, b: q, radius: SIZES.leg * width * d.scene.size, colour, solid: true });
  }
}

/** How strongly an entity is drawn while some are pointed at. */
function emphasis(d: Drawing, id: string): number {
  const chosen = d.state.highlight?.entities;
  return !chosen?.length ? 1 : chosen.includes(id) ? 1.8 : 0.35;
}

/** The places of an entity's points, and the directions of those at infinity. */
function placesOf({ points, directions }: Placed, e: SceneEntity): { corners: Vec3[]; ways: Vec3[] } {
  const among = (known: Record<string, Vec3> | undefined) => e.points.flatMap((n) => (known?.[n] ? [known[n]] : []));
  return { corners: among(points), ways: among(directions) };
}

type Placed = Pick<Scene, "points" | "directions">;

/** Whether an entity has a shape in space: the plane at infinity has none, nor has what goes through unknown points. */
export function isDrawn(scene: Placed, e: SceneEntity): boolean {
  const { corners, ways } = placesOf(scene, e);
  return corners.length + ways.length === e.points.length && (corners.length > 0 || e.kind === "line");
}

/** An entity in space; its plane reaches points that it passes through, or those in which it met others before it swung. */
function entityShape(d: Drawing, scene: Scene, e: SceneEntity, calm: number, met: readonly Constructed[] | null): void {
  if (!isDrawn(scene, e)) return;
  const { corners, ways } = placesOf(scene, e);
  const strength = emphasis(d, e.id);
  const colour = strength < 1 ? d.pale(d.entityColour(e.colour), 0.55) : d.entityColour(e.colour);
  const marks = (met ?? scene.constructed ?? []).flatMap((c) =>
    c.kind === "point" && c.entities.includes(e.id) && distance(c.at, d.middle) < SIZES.far * d.radius ? [c.at] : [],
  );
  const rim = SIZES.edge * scene.size * (strength > 1 ? 1.8 : 1);
  const face = (outline: Outline, fill: number) =>
    d.faces.push({ ...outline, colour, fill: Math.min(0.55, fill * strength * calm), rim, entity: e.id });
  const label = (at: Vec3) => {
    if (e.label.length <= LONGEST_LABEL) d.tag(e.label, at, colour, "entity", { strong: strength > 1 });
  };
  const all = (ring: Vec3[]): Outline => ({ corners: ring, edges: ring.map(() => true) });
  if (e.kind === "tetrahedron" && ways.length > 0) {
    // flat when its directions and the lines between its points lie in one plane
    const reach = 0.45 * scene.size;
    ways.forEach((u) => d.arrow(corners[0]!, along(corners[0]!, u, reach), colour, strength > 1 ? 1.3 : 0.9));
    corners.slice(1).forEach((c) => d.line(corners[0]!, c, colour, { entity: e.id }));
    label(along(corners[0]!, ways[0]!, reach));
  } else if (e.kind === "tetrahedron") {
    if (Math.abs(volume(corners, scene.size)) < 1e-9) body(corners).forEach((outline) => face(outline, 0.34));
    else for (const out of corners) face(all(corners.filter((c) => c !== out)), 0.13);
    label(centre(corners));
  } else if (e.kind === "plane") {
    // within three hundredths of the size a mark is where the planes nearly meet
    const ring = patch([...corners, ...strips(corners, ways, 0.35 * scene.size)], SIZES.margin * scene.size, marks, met ? Infinity : 0.04 * scene.size);
    if (!ring) return;
    face(all(ring), 0.24);
    label(apart(d, scene, ring));
  } else if (e.kind === "line" && corners.length === 0) {
    // a line at infinity is what all planes through its directions have in common: one of them, with its normal
    const normal = cross(ways[0]!, ways[1]!);
    if (Math.hypot(...normal) < 1e-9) return;
    const near = scene.entities.flatMap((other) => placesOf(scene, other).corners);
    const [at, reach] = [near.length ? centre(near) : d.middle, 0.3 * scene.size];
    face(all(disc(normal, dot(normal, at), at, reach)), 0.16);
    const tip = along(at, unit(normal), 1.2 * reach);
    d.arrow(at, tip, colour, strength > 1 ? 1.3 : 0.9);
    label(tip);
  } else if (e.kind === "line") {
    const [from, to] = [corners[0]!, corners[1] ?? along(corners[0]!, ways[0]!, scene.size)];
    const [a, b] = stretched(from, to, SIZES.extra * scene.size, marks);
    d.dashes(a, b, colour, { entity: e.id, radius: SIZES.line * scene.size * (strength > 1 ? 1.5 : 1) });
    label(a[2] > b[2] ? a : b);
  }
}

/** Places beside points, both ways along directions: what shows that a plane goes on to points at infinity. */
const strips = (points: readonly Vec3[], ways: readonly Vec3[], reach: number): Vec3[] =>
  ways.flatMap((u) => points.flatMap((p) => [along(p, u, -reach), along(p, u, reach)]));

/** The place on a ring that is farthest from the labels of other entities and from marks, rather outside than inside. */
function apart(d: Drawing, { constructed = [] }: Scene, ring: Vec3[]): Vec3 {
  const others = [
    ...d.tags.filter((t) => t.look === "entity").map((t) => t.at),
    ...constructed.flatMap((c) => (c.kind === "point" ? [c.at] : [])),
  ];
  const worth = (p: Vec3) => Math.min(d.radius, ...others.map((o) => distance(o, p))) + 0.5 * distance(p, d.middle);
  return ring.reduce((a, b) => (worth(b) > worth(a) + 1e-9 ? b : a));
}

function constructions(d: Drawing, scene: Scene): void {
  (scene.constructed ?? []).forEach((c, i) => {
    if (c.kind === "point") {
      const away = distance(c.at, d.middle);
      const near = away <= SIZES.far * d.radius;
      const far = `${Number(away.toPrecision(3))}${scene.unit && ` ${scene.unit}`}`;
      d.marks.push({ at: c.at, label: c.label, words: `${c.label}, ${far} away`, colour: legible(d.colour("mark"), d.state.theme), drawn: near });
      if (!near) return;
      const radius = SIZES.joint * scene.size;
      d.ball(c.at, radius, d.colour("mark"), d.colour("paper"), 1.28);
      d.tag(c.label, c.at, d.colour("mark"), "construction", { clear: radius * 1.3, strong: true });
      return;
    }
    const ends = throughBall(c.at, c.direction, d.middle, 1.18 * d.radius);
    if (!ends) return;
    const colour = d.entityColour("colour" in c && typeof c.colour === "number" ? c.colour : scene.entities.length + i);
    d.line(ends[0], ends[1], colour, { radius: 1.25 * SIZES.line * scene.size });
    d.tag(c.label, ends[0][2] > ends[1][2] ? ends[0] : ends[1], colour, "construction");
  });
  (scene.planes ?? []).forEach((plane, i) => {
    const colour = d.entityColour(plane.colour ?? scene.entities.length + (scene.constructed?.length ?? 0) + i);
    const part = plane.through ? patch(plane.through, 0.5 * SIZES.margin * scene.size) : null;
    const ring = part ?? disc(plane.normal, plane.offset, d.middle, d.radius);
    if (distance(centre(ring), d.middle) > SIZES.far * d.radius) return;
    d.faces.push({ corners: ring, edges: ring.map(() => true), colour, fill: 0.2, rim: SIZES.edge * scene.size });
    d.tag(plane.label, apart(d, scene, ring), colour, "entity");
  });
}

/** Joints of the base are filled, those of the platform are rings, as in the figures on paper. */
function joints(d: Drawing): void {
  const { scene } = d;
  const marked = new Set(d.state.highlight?.points ?? []);
  const ringed = new Map(scene.entities.flatMap((e) => (e.kind === "point" ? e.points.map((n) => [n, e.colour] as const) : [])));
  const grips = new Map((scene.grips ?? []).flatMap(({ look, label, id }) => (look === "joint" ? [[label, id === scene.chosen]] : [])));
  const used = new Set([...scene.base, ...scene.platform, ...scene.legs.flat(), ...scene.entities.flatMap((e) => e.points)]);
  for (const name of used) {
    const at = scene.points[name];
    if (!at) continue;
    const strong = marked.has(name);
    const own = ringed.get(name);
    const dragged = grips.has(name); // it is ringed, so that this is seen
    const rim = strong || grips.get(name) ? d.colour("mark") : dragged ? d.colour("drive") : own !== undefined ? d.entityColour(own) : d.colour("ink");
    const radius = SIZES.joint * scene.size * (strong ? 1.35 : 1);
    const fill = scene.platform.includes(name) ? d.colour("paper") : strong ? d.colour("mark") : d.colour("ink");
    d.ball(at, radius, fill, rim, strong || dragged ? 1.6 : 1.36);
    d.tag(name, at, strong ? d.colour("mark") : d.colour("ink"), "joint", { clear: radius * 1.4, strong });
  }
}

/** 1, 2 or 5 times a power of ten, not above a length. */
function niceStep(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * ([5, 2, 1].find((k) => k * power <= length * (1 + 1e-9)) ?? 1);
}

function ground(d: Drawing): void {
  const { scene } = d;
  const step = niceStep(scene.size / 2.2);
  const feet = scene.base.flatMap((n) => (scene.points[n] ? [scene.points[n]] : []));
  const standing = feet.length ? feet : jointsOf(scene);
  if (!standing.length) return;
  const floor = Math.min(...standing.map((p) => p[2])) - 0.004 * scene.size;
  // the ground stays where it is while the platform moves
  const middle = feet.length ? centre(feet) : d.middle;
  const reach = Math.ceil((1.1 * scene.size) / step);
  const at = (i: number, axis: 0 | 1) => (Math.round(middle[axis] / step) + i) * step;
  for (let i = -reach; i <= reach; i++) {
    d.grid.push([[at(i, 0), at(-reach, 1), floor], [at(i, 0), at(reach, 1), floor]]);
    d.grid.push([[at(-reach, 0), at(i, 1), floor], [at(reach, 0), at(i, 1), floor]]);
  }
  d.gauge = `${String(Number(step.toPrecision(3)))}${scene.unit ? ` ${scene.unit}` : ""}`;
}
