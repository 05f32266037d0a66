// What is drawn: faces, rods, balls, cones and labels in space with their colours, whoever draws them.
import type { Veil } from "./mesh";
import { blend, colourOf, entityRole, legible, type Role } from "./palette";
import type { Outline } from "./solids";
import type { Highlight, Layer, Scene, Theme, Vec3 } from "./types";
import { add, along, distance, mix, sub, unit } from "./vectors";

export interface Face extends Outline {
  colour: string;
  /** Opacity of the area. */
  fill: number;
  /** Radius of the edges in space. */
  rim: number;
  entity?: string;
}
export interface Rod {
  a: Vec3;
  b: Vec3;
  radius: number;
  colour: string;
  /** Shaded as a round body; lines are not. */
  solid: boolean;
  entity?: string;
}
export interface Ball {
  at: Vec3;
  radius: number;
  fill: string;
  rim: string;
  /** Radius with the rim. */
  outer: number;
}
export interface Cone {
  base: Vec3;
  tip: Vec3;
  radius: number;
  colour: string;
}
export interface Tag {
  text: string;
  at: Vec3;
  /** Radius in space to keep clear of. */
  clear: number;
  colour: string;
  look: "joint" | "entity" | "construction";
  strong: boolean;
  upright: boolean;
}
/** A place that is pointed to where it is not seen. */
export interface Mark {
  at: Vec3;
  label: string;
  /** With its distance from the middle of the robot. */
  words: string;
  colour: string;
  /** Whether it is drawn where it is. */
  drawn: boolean;
}
export interface Model {
  faces: Face[];
  rods: Rod[];
  balls: Ball[];
  cones: Cone[];
  tags: Tag[];
  marks: Mark[];
  /** A curved surface, translucent. */
  veil: Veil | null;
  /** Thin lines of the ground. */
  grid: [Vec3, Vec3][];
  /** The width of a square of the grid, in words. */
  gauge: string;
  /** A ball around all joints. */
  middle: Vec3;
  radius: number;
  /** What the camera is fitted to: all that is drawn, of what goes on far away the part near the robot. */
  frame: readonly Vec3[];
}

export interface State {
  theme: Theme;
  highlight: Highlight | null;
  hidden: ReadonlySet<Layer>;
  /** Place in the swing of the gained motion, from −1 to 1; null while it rests. */
  swing: number | null;
  /** Where the platform's centre is. */
  centre: Vec3;
}

/** Lengths as shares of the scene's size. */
export const SIZES = { joint: 0.021, leg: 0.0085, line: 0.0055, edge: 0.003, margin: 0.13, extra: 0.3, far: 2.2 };

/** Of one line: through joints far apart they grow longer, not more. */
const MOST_DASHES = 120;

/** Collects what is drawn, in the colours of a theme. */
export class Drawing implements Model {
  readonly faces: Face[] = [];
  readonly rods: Rod[] = [];
  readonly balls: Ball[] = [];
  readonly cones: Cone[] = [];
  readonly tags: Tag[] = [];
  readonly marks: Mark[] = [];
  readonly grid: [Vec3, Vec3][] = [];
  veil: Veil | null = null;
  gauge = "";
  readonly middle: Vec3;
  readonly radius: number;

  get frame(): Vec3[] {
    const corners = [...this.faces.flatMap((f) => f.corners), ...this.rods.flatMap((r) => [r.a, r.b]), ...this.cones.map((c) => c.tip)];
    const balls = this.balls.flatMap(({ at, outer }) => ([-outer, outer] as const).flatMap((s) => ([[s, 0, 0], [0, s, 0], [0, 0, s]] as Vec3[]).map((u) => add(at, u))));
    const drawn = [...corners, ...balls].map((p) => this.within(p, 1.45));
    const veil = (this.veil?.corners ?? []).map((p) => this.within(mix(this.middle, p, 0.85), SIZES.far));
    const all = [...drawn, ...veil];
    return all.length ? all : [this.middle];
  }

  /** A place, or where the way to it leaves the ball of so many radii around the robot. */
  private within(p: Vec3, radii: number): Vec3 {
    const away = distance(p, this.middle);
    return mix(this.middle, p, Math.min(1, (radii * this.radius) / (away || 1)));
  }

  constructor(readonly scene: Scene, readonly state: State) {
    const places = [...jointsOf(scene), ...(scene.plate ?? []), ...(scene.bars ?? []).flat(), ...framed(scene)];
    const bound = (k: 0 | 1 | 2, of: (...numbers: number[]) => number) => of(...places.map((p) => p[k]));
    const half = (k: 0 | 1 | 2) => (bound(k, Math.min) + bound(k, Math.max)) / 2;
    this.middle = places.length ? [half(0), half(1), half(2)] : [0, 0, 0];
    this.radius = Math.max(...places.map((p) => distance(p, this.middle)), scene.size * 0.3);
  }

  colour = (role: Role): string => colourOf(role, this.state.theme);
  entityColour = (number: number): string => this.colour(entityRole(number));
  pale = (colour: string, share: number): string => blend(colour, this.colour("paper"), share);
  shows = (layer: Layer): boolean => !this.state.hidden.has(layer);

  line(a: Vec3, b: Vec3, colour: string, more: Partial<Rod> = {}): void {
    this.rods.push({ a, b, colour, radius: SIZES.line * this.scene.size, solid: false, ...more });
  }
  dashes(a: Vec3, b: Vec3, colour: string, more: Partial<Rod> = {}): void {
    const count = Math.min(Math.max(1, Math.round(distance(a, b) / (0.085 * this.scene.size))), MOST_DASHES);
    for (let k = 0; k < count; k++) this.line(mix(a, b, (k + 0.2) / count), mix(a, b, (k + 0.8) / count), colour, more);
  }
  ball(at: Vec3, radius: number, fill: string, rim: string, width = 1): void {
    this.balls.push({ at, radius, fill, rim, outer: radius * width });
  }
  arrow(a: Vec3, b: Vec3, colour: string, thick = 1): void {
    const size = this.scene.size * thick;
    const neck = along(b, unit(sub(b, a)), -0.075 * size);
    this.line(a, neck, colour, { radius: SIZES.line * 1.3 * size });
    this.cones.push({ base: neck, tip: b, radius: 0.024 * size, colour });
  }
  tag(text: string, at: Vec3, colour: string, look: Tag["look"], more: Partial<Tag> = {}): void {
    if (!this.shows("labels")) return;
    const dims = Boolean(this.state.highlight?.entities?.length); // what is not pointed at is pale on purpose
    this.tags.push({ text, at, colour: dims ? colour : legible(colour, this.state.theme), look, clear: 0, strong: false, upright: false, ...more });
  }
}

/** The places of a skeleton, its axes apart, which may be long. */
const framed = ({ skeleton }: Scene): Vec3[] =>
  skeleton ? [...skeleton.platform, ...skeleton.base, ...skeleton.strokes.flatMap(({ ends, look }) => (look === "axis" ? [] : ends))] : [];

/** The places of the points that are drawn. */
export function jointsOf(scene: Scene): Vec3[] {
  const names = new Set([...scene.base, ...scene.platform, ...scene.legs.flat()]);
  const places = [...names].flatMap((n) => (scene.points[n] ? [scene.points[n]] : []));
  for (const limb of scene.limbs ?? []) places.push(...limb.joints.flatMap((j) => (j.point ? [j.point] : [])));
  return places.length ? places : Object.values(scene.points);
}
