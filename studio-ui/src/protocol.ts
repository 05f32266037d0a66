// What the page and the server say to each other over one websocket: JSON, one object a message.
//
// The server keeps nothing between messages but caches: a request holds all that it needs (the source, the pose), so
// that a restarted server goes on where the old one stopped. The same shapes are dataclasses in gcrules/apps/studio/views.py.

export type Vec3 = [number, number, number];
/** Unit quaternion, scalar first. */
export type Quaternion = [number, number, number, number];

// ------------------------------------------------------------------------------------------------------- messages

/** A request. Of one `channel` only the latest unanswered request is worked on; older ones are answered `superseded`. */
export interface Request<M extends Method = Method> {
  id: number;
  do: M;
  args: Methods[M]["args"];
  channel?: string;
}

export type Reply<M extends Method = Method> =
  | { id: number; ok: true; result: Methods[M]["result"]; ms: number }
  | { id: number; ok: false; error: Fault }
  | { id: number; progress: string };

/** A fault in words. `place` is where in a text that was sent: offsets in characters from its start. */
export interface Fault {
  kind: "input" | "limit" | "superseded" | "cancelled" | "fault";
  message: string;
  hint?: string;
  place?: { start: number; end: number; line: number; column: number };
  /** Further faults of the same text (files tell all faults at once). */
  more?: Fault[];
}

export interface Methods {
  hello: { args: Record<string, never>; result: Hello };
  gallery: { args: Record<string, never>; result: Gallery };
  open: { args: { source: Source }; result: Study };
  pose: { args: { source: Source; pose: Pose; threshold?: string }; result: Numbers };
  nearest: { args: { source: Source; pose: Pose; threshold?: string }; result: Nearest };
  along: { args: { source: Source; poses: Pose[]; threshold?: string }; result: Along };
  manual: { args: { source: Source; commands: string[] }; result: Manual };
  bench: { args: { text: string; source?: Source; pose?: Pose }; result: Bench };
  compose: { args: { drawing: Sketch }; result: { text: string } };
  save: { args: { source: Source; pose: Pose; what: Format; threshold?: string }; result: Saved };
  cancel: { args: { target: number }; result: { cancelled: boolean } };
}
export type Method = keyof Methods;

export interface Hello {
  version: string;
  /** Changes when the server is another process. */
  instance: string;
  /** What the command line named: opened by a page that holds nothing else. */
  opened?: Source | null;
}

// ---------------------------------------------------------------------------------------------- what is studied

export type Source =
  | { kind: "class"; id: string }
  | { kind: "legs"; legs: string }
  | { kind: "example"; name: string }
  | { kind: "robot"; id: string }
  /** The text of a platform file or of a robot file, told apart by its keys. */
  | { kind: "file"; text: string; name: string };

/** The platform's displacement from where the file puts it: turned about `about` of the study, then shifted. */
export interface Pose {
  translation: Vec3;
  quaternion: Quaternion;
  /** For robots with limbs: amounts of the actuators from home, in the sequence and in the units of `axes`. */
  coordinates?: number[];
}

export interface Gallery {
  classes: GalleryItem[];
  robots: GalleryItem[];
  examples: GalleryItem[];
}
export interface GalleryItem {
  id: string;
  title: string;
  /** A few words: the legs, the mobility. */
  detail: string;
  group: string;
  statement: string;
  /** An SVG drawing, trusted (made by the server). */
  svg: string;
  source: Source;
}

/** Everything about the structure that does not change with the pose. */
export interface Study {
  title: string;
  note: string;
  kind: "platform" | "robot";
  legs: [string, string][];
  base: string[];
  platform: string[];
  /** Coordinates at the file's own pose. */
  points: Record<string, Vec3>;
  unit: string;
  /** The coordinates are a sample shape, none were given. */
  invented: boolean;
  /** Centre of the platform's turns, and a length to scale sliders and the camera by. */
  about: Vec3;
  size: number;
  /** Independent coordinates: six for a platform; those of the robot's mobility otherwise. */
  axes: Axis[];
  class: { id: string; name: string } | null;
  /** SVG of the legs as a graph. Elements carry data-point="a" and data-leg="ab". */
  schematic: string;
  stages: Stage[];
  entities: Entity[];
  condition: Condition;
  readings: Condition[];
  robot: RobotView | null;
}

export interface Axis {
  name: string;
  unit: string;
  low: number;
  high: number;
  step: number;
}

export interface Entity {
  id: string;
  kind: "tetrahedron" | "plane" | "line" | "point";
  points: string[];
  /** With stars: A*bd. */
  label: string;
  /** Number of its colour in the palette. */
  colour: number;
}

export interface Condition {
  kind: string;
  /** TeX of the left and the right side of the identity, one piece for each monomial or factor. */
  left: Piece[];
  right: Piece[];
  text: string;
  cofactor: string;
  statement: string;
  certificate: { method: string; detail: string };
}

/** A piece of a formula that stays on one line, with the points and entities in it. */
export interface Piece {
  tex: string;
  points: string[];
  brackets: string[][];
}

export interface Stage {
  id: StageId;
  title: string;
  /** What is done and why, for a non-expert. */
  why: string;
  /** The theory, in a few paragraphs of text. */
  more: string[];
  items: Item[];
}
export type StageId =
  | "structure"
  | "superbracket"
  | "shortest"
  | "tetrahedra"
  | "planes"
  | "lines"
  | "left-over"
  | "condition"
  | "statement"
  | "check"
  | "limbs"
  | "equivalent";

export type Item =
  | { kind: "text"; text: string }
  | { kind: "fact"; key: string; value: string }
  | { kind: "formula"; left: Piece[]; right: Piece[] }
  | { kind: "monomials"; monomials: Monomial[] }
  | { kind: "orders"; tried: number; counts: { terms: number; orders: number }[]; best: string }
  | { kind: "entities"; entities: string[] }
  | { kind: "steps"; steps: { rule: string; why: string; before: Piece[]; after: Piece[] }[] };

export interface Monomial {
  sign: 1 | -1;
  coefficient: string;
  brackets: { points: string[]; tex: string }[];
}

/** A robot with limbs: what Fig. 1 of the paper shows side by side. */
export interface RobotView {
  mobility: number;
  /** SVG: the robot with its wrenches, and beside it the lines that stand for them, at home. */
  figure?: string;
  limbs: LimbView[];
  parts: { text: string; tex: string; kind: string; statement: string }[];
}
export interface LimbView {
  name: string;
  colour: number;
  wrenches: string[];
  joints: { kind: string; actuated: boolean; point: Vec3 | null; axes: Vec3[] }[];
  lines: { text: string; wrench: "force" | "couple"; point: Vec3 | null; direction: Vec3 }[];
}

// -------------------------------------------------------------------------------------------- numbers at a pose

export type Verdict = "regular" | "close" | "singular";

export interface Numbers {
  /** The pose that this answers. */
  pose: Pose;
  points: Record<string, Vec3>;
  /** Superbracket over its scale: dimensionless, with the sign of the superbracket. */
  value: number;
  closeness: number;
  verdict: Verdict;
  reason: string;
  causes: string[];
  readings: { part: string; name: string; meaning: string; value: number | null; unit: string; why: string }[];
  /** Constructed points and lines of the condition at this pose: the common point of planes, the line p … */
  constructed: Constructed[];
  /** What the platform can do although its actuators are locked; given near a singular pose. */
  motion: { axis: Vec3; through: Vec3; pitch: number | null; text: string } | null;
  /** Ratios of the forces in the legs that balance, near a singular pose. */
  stress: number[];
  limbs: LimbView[];
  notes: string[];
}
export type Constructed =
  | { kind: "point"; label: string; at: Vec3; entities: string[] }
  | { kind: "line"; label: string; at: Vec3; direction: Vec3; entities: string[]; colour?: number };

export interface Nearest {
  found: { kind: string; distance: number; unit: string; certified: boolean; text: string; pose: Pose; causes: string[] }[];
  /** For a robot with limbs: what was searched, in words; the kinds are "along +z" …, the closest one stands first. */
  note?: string;
}

export interface Along {
  closeness: number[];
  value: number[];
  verdicts: Verdict[];
}

// ---------------------------------------------------------------------------------- manual mode, bench, take away

export interface Manual {
  /** The commands that were understood; the first faulty one stops the replay and is `fault`. */
  history: { command: string; answer: "confirmed" | "refused" | "possible" | "done"; words: string; monomial: number | null }[];
  form: { name: string; order: string; monomials: Monomial[] };
  entities: Entity[];
  left: string[];
  hint: { command: string; words: string } | null;
  /** Points of an exact counterexample, if the last proposal was refused by one. */
  counterexample: Record<string, Vec3> | null;
  condition: Condition | null;
  fault: Fault | null;
}

export interface Bench {
  results: BenchResult[];
  fault: Fault | null;
}
export interface BenchResult {
  /** Offsets of the statement in the text. */
  start: number;
  end: number;
  name: string | null;
  verdict: "value" | "proved" | "refuted" | "undecided" | "done";
  text: string;
  pieces: Piece[];
  step: number | null;
  /** What can be drawn in 3D with the points of the study, at its pose. */
  drawn: Constructed | { kind: "plane"; label: string; normal: Vec3; offset: number } | null;
}

export interface Sketch {
  title: string;
  points: Record<string, Vec3>;
  base: string[];
  platform: string[];
  legs: [string, string][];
}

export type Format = "html" | "latex" | "svg" | "png" | "pdf" | "json" | "yaml";
export interface Saved {
  name: string;
  mime: string;
  /** Text, or base64 where `binary`. */
  data: string;
  binary: boolean;
}
