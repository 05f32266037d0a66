// What the page and the server say to each other over one websocket: JSON, one object a message.
// Written by `npm run protocol` from gcrules/apps/studio/protocol and from scene_data.py and glossary.py
// of gcrules/views; change those.

/** Those that the studio leads through, in sequence; a robot of joints begins with the first two. */
export const STAGE_IDS = ["limbs", "equivalent", "structure", "superbracket", "shortest", "tetrahedra", "planes", "lines", "left-over", "condition", "statement", "check"] as const;

/** In the order of the alphabet. `forms` are other words for the same, between bars; `page` is a page of the guide. */
export const GLOSSARY = [{"term": "actuator", "forms": "actuators|actuated", "meaning": "A joint that is driven. Its amount, an angle or a length, counts from home.", "guide": "Robots in motion", "page": "robot-numbers.md"}, {"term": "aspect", "forms": "aspects", "meaning": "A part of the poses of a robot within which it can go from any pose to any other without a singular pose in between.", "guide": "Which poses are connected", "page": "aspects.md"}, {"term": "assembly mode", "forms": "assembly modes", "meaning": "One of the poses that the platform can take while its actuators are held: a real solution of the direct kinematics.", "guide": "Assembly modes", "page": "modes.md"}, {"term": "associated points", "forms": "eight associated points", "meaning": "Eight points of space such that every quadric through seven of them contains the eighth; in general those in which three quadrics meet.", "guide": "A hexahedron with plane faces", "page": "theorems.md#a-hexahedron-with-plane-faces"}, {"term": "bracket", "forms": "brackets", "meaning": "The determinant [abcd] of four points. It is zero exactly when they lie in one plane.", "guide": "Bracket", "page": "course/bracket.md"}, {"term": "certificate", "forms": "certificates", "meaning": "How an answer was shown, so that it can be checked again. That of a whole range of poses is a file: the proof that none is singular, or a singular one.", "guide": "Certificates", "page": "certify.md"}, {"term": "codimension", "forms": "", "meaning": "How many equations have to hold at once: in codimension one a single one is enough.", "guide": "What the answer means", "page": "robots.md#what-the-answer-means"}, {"term": "cofactor", "forms": "cofactors", "meaning": "A factor by which the superbracket is multiplied in an identity. The identity decides nothing at poses where the cofactor is zero.", "guide": "Where the cofactor comes from", "page": "transversals.md#where-the-cofactor-comes-from"}, {"term": "couple", "forms": "couples", "meaning": "A pure moment, without a force. Its line lies at infinity.", "guide": "Joints at infinity and couples", "page": "lines.md#joints-at-infinity-and-couples"}, {"term": "discovery", "forms": "discoveries", "meaning": "An incidence of a construction that holds and is proved, and that does not follow at once from what is given.", "guide": "Discovering theorems", "page": "discover.md"}, {"term": "equivalent lines", "forms": "equivalent structure|equivalent line", "meaning": "Six lines that stand for everything the limbs can apply to the platform while the actuators are locked.", "guide": "From limbs to lines", "page": "procedure/four-dof.md#from-limbs-to-lines"}, {"term": "extensor", "forms": "extensors", "meaning": "Points written side by side: the point, line or plane that they span, with a weight and a sign.", "guide": "Extensors", "page": "course/extensor.md"}, {"term": "family", "forms": "families", "meaning": "All configurations and all dimensions that keep the relations of a robot's file. In a factorization: the kinds of expressions that were searched.", "guide": "A robot file", "page": "robots.md#points-and-directions"}, {"term": "gained motion", "forms": "", "meaning": "A motion that the platform can make at a singular pose, to first order, although its actuators are locked.", "guide": "At a singular pose", "page": "pose.md#at-a-singular-pose"}, {"term": "group of conditions", "forms": "group b|group c|group d|group e|group g", "meaning": "One of the sorts of condition in the published procedure, with its letter. The classes of the catalog are arranged by them.", "guide": "The classes of six-legged platforms", "page": "catalog/README.md"}, {"term": "idle freedom", "forms": "idle freedoms", "meaning": "A motion inside the limbs that leaves the platform at rest, such as a rod that turns about its own axis.", "guide": "What the answer means", "page": "robots.md#what-the-answer-means"}, {"term": "isotropic points", "forms": "isotropic point", "meaning": "The two points at infinity through which every circle of a plane runs. With them circles, right angles and equal lengths are said in brackets.", "guide": "The points at infinity", "page": "metric.md#the-points-at-infinity"}, {"term": "join", "forms": "joins", "meaning": "The smallest space that holds two others: of two points the line, of a line and a point the plane through them.", "guide": "Join", "page": "course/join.md"}, {"term": "Krawczyk's operator", "forms": "", "meaning": "Newton's method with bounds for all errors: it proves that a box holds exactly one solution.", "guide": "How it is solved", "page": "robot-numbers.md#how-it-is-solved"}, {"term": "left-over points", "forms": "left-over point", "meaning": "Points of the terms that no plane, line or tetrahedron takes up. They are shared out over the brackets in all ways, with signs.", "guide": "Left-over points", "page": "procedure/octahedral.md#7-left-over-points"}, {"term": "limb", "forms": "limbs", "meaning": "A chain of joints and links from the base to the platform.", "guide": "Robots and their joints", "page": "robots.md"}, {"term": "line variety", "forms": "line varieties", "meaning": "All the lines that depend on given ones: those through a point, in a plane, of a regulus, a congruence or a linear complex.", "guide": "At a singular pose", "page": "pose.md#at-a-singular-pose"}, {"term": "locus", "forms": "", "meaning": "The set of all singular poses: where one polynomial in the numbers of a pose is zero.", "guide": "The locus as a polynomial", "page": "locus.md"}, {"term": "margin", "forms": "σ|margins", "meaning": "The number σ from 0 at a singular pose to at most 1, the same in every frame and unit. It says how well the legs or limbs hold the platform.", "guide": "The measure", "page": "pose.md#the-measure"}, {"term": "meet", "forms": "", "meaning": "The space that two others have in common, as an extensor: of a line and a plane the point, of two planes the line.", "guide": "Meet", "page": "course/meet.md"}, {"term": "member", "forms": "members", "meaning": "One configuration of a family, with its dimensions. Random members are exact: their coordinates are fractions, or residues modulo a prime.", "guide": "A robot file", "page": "robots.md#points-and-directions"}, {"term": "null point", "forms": "null points|null plane|null planes", "meaning": "The point of a plane through which all lines of the plane pass that are reciprocal to a screw; the null plane of a point holds all lines through the point that are.", "guide": "Letters for screws", "page": "language.md#letters-for-screws"}, {"term": "operation mode", "forms": "operation modes", "meaning": "One of the sets of poses that the limbs leave to the platform while no actuator is locked.", "guide": "Operation modes", "page": "operation-modes.md"}, {"term": "over-constrained", "forms": "overconstraint|overconstraints|overconstrained", "meaning": "Some constraints of the limbs depend on others, as when two limbs forbid the same motion.", "guide": "Mobility", "page": "screws.md#mobility"}, {"term": "Plücker coordinates", "forms": "", "meaning": "Six numbers that say where a line is, up to a common factor.", "guide": "Coordinates of a line", "page": "course/extensor.md#coordinates-of-a-line"}, {"term": "reading", "forms": "readings", "meaning": "The same condition stated with other entities, or a number that says how nearly its entities satisfy it at a pose.", "guide": "Other readings", "page": "procedure/octahedral.md#11-other-readings"}, {"term": "replayed", "forms": "replay|replays", "meaning": "Done again step by step, to see that it still holds: a derivation at exact random points, a saved session by its commands. This checks, and does not prove.", "guide": "How sure an answer is", "page": "conventions.md#how-sure-an-answer-is"}, {"term": "shortest form", "forms": "", "meaning": "The superbracket written with the fewest terms over all orders of the six legs.", "guide": "Shortest form", "page": "procedure/octahedral.md#3-shortest-form"}, {"term": "singular pose", "forms": "singular poses|singular configuration|singularity|singularities", "meaning": "A pose in which the six lines depend on each other: the platform can move, to first order at least, although the actuators are locked.", "guide": "Superbracket", "page": "course/superbracket.md"}, {"term": "softest motion", "forms": "", "meaning": "The motion of the platform that its legs or limbs resist least. At a singular pose it is the gained motion.", "guide": "At a singular pose", "page": "pose.md#at-a-singular-pose"}, {"term": "standard tableau", "forms": "standard tableaux", "meaning": "A product of brackets, written as rows, whose rows increase from left to right while its columns do not decrease from top to bottom. Every bracket polynomial is a sum of standard tableaux in exactly one way.", "guide": "Tableaux", "page": "course/straightening.md#tableaux"}, {"term": "straightening", "forms": "normal form", "meaning": "Rewriting a polynomial in brackets into its one normal form of standard tableaux, by which equality is decided.", "guide": "Syzygies and straightening", "page": "course/straightening.md"}, {"term": "superbracket", "forms": "superbrackets", "meaning": "The determinant of six lines, written in brackets of their points. The robot is singular exactly when it is zero.", "guide": "Superbracket", "page": "course/superbracket.md"}, {"term": "tetrahedron", "forms": "tetrahedra", "meaning": "Four points, as a bracket: it is flat exactly when the bracket is zero. If all terms have the bracket in common, the robot is singular where it is flat.", "guide": "Tetrahedra", "page": "procedure/octahedral.md#4-tetrahedra"}, {"term": "threshold", "forms": "ε", "meaning": "What counts as close: how far a leg may turn, or how far the platform may shift. A pose is called close where σ does not exclude a singular pose that near.", "guide": "What the numbers mean", "page": "pose.md#what-the-numbers-mean"}, {"term": "twist", "forms": "twists", "meaning": "A motion at an instant: a turn about an axis together with a shift along it.", "guide": "Screws", "page": "screws.md"}, {"term": "value", "forms": "", "meaning": "The superbracket divided by its scale: without unit, with its sign, zero at a singular pose. Robots without equivalent lines have σ in its place.", "guide": "The studio", "page": "studio.md#in-space"}, {"term": "working mode", "forms": "working modes", "meaning": "One of the ways in which the limbs can hold the platform in the same place, such as elbows in or out.", "guide": "Working modes", "page": "working-modes.md"}, {"term": "wrench", "forms": "wrenches", "meaning": "What a limb applies to the platform: a force along a line together with a moment about it.", "guide": "Screws", "page": "screws.md"}] as const;

/** Words for terms that mean something else in most sentences: they are explained only where they are put as terms. */
export const EVERYDAY = ["join", "joins", "meet", "value", "ε"] as const;

export type Vec3 = [number, number, number];

export type LegEnds = [string, string];

export type Verdict = "singular" | "close" | "regular";

export type EntityKind = "tetrahedron" | "plane" | "line" | "point";

/** A joint, or a list of "join" or "meet" and two constructions or more. */
export type Construction = string | Construction[];

export interface Entity {
  id: string;
  kind: EntityKind;
  points: string[];
  /** As conditions and sentences have it: Abd. */
  label: string;
  /** As the steps that find it have it, stars telling repeated points apart: A*bd. */
  starred: string;
  /** Number of its colour, counted from 0; six colours repeat. */
  colour: number;
}

export interface NamedPoint {
  kind: "point";
  label: string;
  at: Vec3;
  entities: string[];
}

export interface NamedLine {
  kind: "line";
  label: string;
  at: Vec3;
  direction: Vec3;
  entities: string[];
  colour?: number;
}

/** Points and lines that the condition constructs: the common point of planes, the line p … */
export type Constructed = NamedPoint | NamedLine;

/** The plane normal · p = offset. */
export interface Plane {
  label: string;
  normal: Vec3;
  offset: number;
  /** Places around which a part of it is drawn. */
  through?: Vec3[];
  colour?: number;
  /** Points and directions that it is drawn through. */
  points?: string[];
}

/** What the platform can do although its actuators are locked. */
export interface Motion {
  axis: Vec3;
  through: Vec3;
  /** Advance for each radian; null where it is a translation. */
  pitch: number | null;
  text: string;
}

export interface Joint {
  kind: string;
  actuated: boolean;
  point: Vec3 | null;
  axes: Vec3[];
}

export interface Line {
  text: string;
  wrench: "force" | "couple";
  point: Vec3 | null;
  direction: Vec3;
}

export interface Limb {
  name: string;
  colour: number;
  wrenches: string[];
  joints: Joint[];
  lines: Line[];
}

/** What a page needs to decide as the engine does; said once, by the engine. */
export interface Thresholds {
  /** Below this singularity margin a pose is close to singular. */
  close: number;
  /** Accuracy of coordinates in units of the robot's size; what it may do to the margin counts as 0. */
  rounding: number;
  /** Accuracy of coordinates as floats, in units of the largest of them. */
  digits: number;
  /** Planes and lines that miss a point by less than this share of the size are shown with it, marked as near. */
  near: number;
  /** Below this share they meet in it. */
  met: number;
}

export interface RecipeLine {
  label: string;
  colour: number;
  of: Construction;
}

export interface RecipePoint {
  label: string;
  of: Construction[];
  entities: string[];
}

/** How what changes with the pose follows from the joints, for pages that have no server. */
export interface Recipe {
  lines: RecipeLine[];
  points: RecipePoint[];
  /** −1 where the legs are turned round with respect to those that the user wrote. */
  sign: 1 | -1;
  thresholds: Thresholds;
  /** The length of which `near` and `met` are shares. */
  size: number;
}

/** A sum of points or directions: name and factor. */
export type Terms = Record<string, number>;

/** A limb at home: elementary motions from the base to the platform. */
export interface Chain {
  /** (ω; v) of each motion. */
  screws: number[][];
  /** The coordinate that each motion takes. */
  uses: number[];
  signs: number[];
  /** Of each coordinate whether it is an angle. */
  turns: boolean[];
  end: Vec3;
  /** Whether it ends in a ball joint that is not driven. */
  ball: boolean;
  /** Of its twists; `passive` that of those that are not driven. */
  rank: number;
  passive: number;
  /** The dimension of its wrenches with locked actuators. */
  applied: number;
  /** Of a limb with bodies of its own its runs: their first motion, that after their last, the link on which they begin, and that by which an earlier run reaches the same body, −1 where there is none. */
  runs: number[][];
  /** The link that is the platform, of such a limb. */
  platform: number;
  /** With which sign each coordinate counts in the platform's twist, and in each loop of the limb's own. */
  shares: number[][];
}

/** A chain between two bodies, where limbs have loops of their own: its coordinates in its limb that are not driven, the rank of their twists, and the bodies, the platform being 0 and the base −1. */
export interface Span {
  limb: number;
  free: number[];
  rank: number;
  start: number;
  end: number;
}

/** An actuator, with the places of its limb and of its coordinate there. */
export interface Drive {
  name: string;
  text: string;
  limb: number;
  coordinate: number;
}

/** The names of which the place and the axes of a joint are made; no place where there are none. */
export interface DrawnJoint {
  point: Terms;
  axes: Terms[];
}

/** The direction u × v of two `args`; of four, (P, u, Q, n), the point of the line through P along u in the plane through Q perpendicular to n. */
export interface Derived {
  name: string;
  args: Terms[];
}

/** What links carry: limb and link of each, the share with which it counts, and the place that it carries, at home. Shares of 1 and −1 make a direction. */
export interface CarriedPlace {
  links: number[][];
  shares: number[];
  at: Vec3[];
}

export interface CarriedStroke {
  ends: CarriedPlace[];
  look: string;
}

export interface CarriedSign {
  kind: string;
  actuated: boolean;
  at: CarriedPlace;
  axes: CarriedPlace[];
}

/** A skeleton whose parts are carried by links. */
export interface CarriedSkeleton {
  strokes: CarriedStroke[];
  signs: CarriedSign[];
  platform: CarriedPlace[];
  base: CarriedPlace[];
}

/** How a robot of joints moves by its actuators, for pages that have no server. */
export interface Linkage {
  chains: Chain[];
  drives: Drive[];
  /** Limbs and coordinates of actuators that follow from the drives, where there are more of them than freedoms. */
  follows: number[][];
  /** The limbs and links that carry a name. */
  rides: Record<string, number[][]>;
  /** All points at home, and below all directions. */
  points: Record<string, Vec3>;
  directions: Record<string, Vec3>;
  derived: Derived[];
  /** Those of each of the `limbs` of the scene: a limb or, of one that has bodies of its own, one of its chains. */
  joints: DrawnJoint[][];
  /** The places in `chains` of those that end on the platform. */
  ends: (number | null)[];
  /** What is drawn of the limbs' own bodies, from one end to the other. */
  rods: Terms[][];
  /** The ends of the lines of each, as there. */
  lines: LegEnds[][];
  /** The bars of each, from one end to the other, and rods between them. */
  bars: Terms[][][];
  /** All chains between bodies, where limbs have loops of their own. */
  spans: Span[];
  /** What is drawn of it, where links carry it. */
  skeleton: CarriedSkeleton | null;
  /** Limbs and coordinates that stay at 0. */
  locked: number[][];
  plane: boolean;
  centre: Vec3;
  size: number;
  /** Below this singularity margin a configuration is close to singular. */
  close: number;
  /** Up to this margin it is singular. */
  floor: number;
}

export interface Stroke {
  ends: Vec3[];
  /** A link, a bar (thinner), a rail or an axis. */
  look: string;
}

/** A joint where its sign stands, with unit vectors along its axes. */
export interface JointSign {
  /** That of the joint, "carriage" for a slide on a rail, "pin" for a hinge of a parallelogram. */
  kind: string;
  actuated: boolean;
  at: Vec3;
  axes: Vec3[];
}

/** Links, signs of joints and corners of the bodies of a robot of joints, as they are drawn on paper. */
export interface Skeleton {
  strokes: Stroke[];
  signs: JointSign[];
  platform: Vec3[];
  base: Vec3[];
}

/** A robot in a pose, with its condition. */
export interface SceneData {
  points: Record<string, Vec3>;
  base: string[];
  platform: string[];
  legs: LegEnds[];
  /** Centre of the platform's turns. */
  about: Vec3;
  /** A length that the camera, the balls and the handles are scaled by. */
  size: number;
  unit: string;
  entities: Entity[];
  constructed?: Constructed[];
  motion?: Motion | null;
  limbs?: Limb[];
  skeleton?: Skeleton | null;
  /** Unit vectors of points at infinity, through which entities may go. */
  directions?: Record<string, Vec3>;
  /** Planes that are no entities. */
  planes?: Plane[];
  recipe?: Recipe;
  linkage?: Linkage;
}

export const FARTHEST = 1000000000000.0;

export const MOST_COORDINATES = 24;

export const MOST_POINTS = 40;

export const MOST_LEGS = 24;

export const MOST_COMMANDS = 200;

export const MOST_BOXES = 2000000;

export const MOST_WAYPOINTS = 200;

export const LONGEST_FILE = 400000;

export const LONGEST_RULES = 40000;

export const MOST_RULES = 200;

export const MOST_RULE_FILES = 12;

/** Closer than this is close, where nothing else is asked for. */
export const THRESHOLD = "0.5 deg";

export interface ClassSource {
  kind: "class";
  id: string;
}

export interface LegsSource {
  kind: "legs";
  legs: string;
}

export interface ExampleSource {
  kind: "example";
  name: string;
}

export interface RobotSource {
  kind: "robot";
  id: string;
  /** A working mode, "+-+", or an assembly mode, "assembly 3": the robot's home in that mode. */
  mode?: string;
}

/** The text of a platform file or of a robot file, told apart by its keys, or of a model. */
export interface FileSource {
  kind: "file";
  text: string;
  name: string;
  /** A working or an assembly mode, of a robot file. */
  mode?: string;
}

export type Source = ClassSource | LegsSource | ExampleSource | RobotSource | FileSource;

/** Unit quaternion, scalar first. */
export type Quaternion = [number, number, number, number];

/** The platform's displacement from where the file puts it: turned about `about` of the study, then shifted. */
export interface Pose {
  translation: [number, number, number];
  quaternion: Quaternion;
  /** For robots with limbs: amounts of the actuators from home, in the sequence and in the units of `axes`. */
  coordinates?: number[];
}

export interface Sketch {
  title: string;
  points: Record<string, [number, number, number]>;
  base: string[];
  platform: string[];
  legs: [string, string][];
}

export type NoArgs = Record<string, never>;

export interface OpenArgs {
  source: Source;
}

export interface PoseArgs {
  source: Source;
  pose: Pose;
  threshold?: string;
}

/** Where the `freedoms` of the study are to be, from home and in their units (`at`), or the platform (`to`): one with fewer freedoms follows as far as these go. The pose is the one near it now. */
export interface MoveArgs {
  source: Source;
  pose: Pose;
  at?: number[];
  to?: Pose;
}

export interface AlongArgs {
  source: Source;
  poses: Pose[];
  threshold?: string;
}

/** From `start` (home without it) to `goal`, or to the pose that the text `to` names; straight from pose to pose `through` others, or on a way around singular poses. */
export interface PathArgs {
  source: Source;
  start?: Pose;
  goal: Pose;
  through?: Pose[];
  to?: string;
  way?: "straight" | "around";
  threshold?: string;
}

/** Poses as a table of comma-separated values, or such a table as poses. */
export interface WaypointsArgs {
  source: Source;
  poses?: Pose[];
  table?: string;
}

/** Over two coordinates with their ranges ("x -1:1:21"), the others as they are at the pose. The bands of its picture are the `measure`, one of those of the study; the margin, where none is asked for. */
export interface MapArgs {
  source: Source;
  over: [string, string];
  pose: Pose;
  threshold?: string;
  measure?: string;
}

export interface ModesArgs {
  source: Source;
  threshold?: string;
}

/** The largest region of a shape around the pose. */
export interface FreeArgs {
  source: Source;
  pose: Pose;
  shape: "box" | "ball";
}

/** Whole ranges of coordinates ("x -1:1"), the others as they are at the pose, in so many boxes at most. Free poses have the `margin`; `limits` are those of legs or actuators. */
export interface BoxesArgs {
  source: Source;
  over: string[];
  pose: Pose;
  margin?: number;
  limits?: string;
  boxes: number;
}

/** The same ranges, to be certified: joints of rods keep to a `cone` ("40 deg", "base 30 deg, C1 40 deg"), the platform to a `tilt` ("40 deg"). */
export interface CertifyArgs extends BoxesArgs {
  cone?: string;
  tilt?: string;
}

/** Over these coordinates, without them over the position, else over all; the others as they are at the pose. */
export interface LocusArgs {
  source: Source;
  pose: Pose;
  over?: string[];
}

/** Over x, y and z with their ranges ("x -1:1:21"), the other coordinates as they are at the pose. */
export interface SurfaceArgs {
  source: Source;
  over: [string, string, string];
  pose: Pose;
}

/** The pose at a place of that map or of that surface, in the units of its axes. */
export interface PlaceArgs {
  source: Source;
  over: string[];
  pose: Pose;
  place: number[];
}

/** Where in a map over two coordinates the pose is. */
export interface HereArgs {
  source: Source;
  over: [string, string];
  pose: Pose;
}

export interface ManualArgs {
  source: Source;
  commands: string[];
}

/** A file of rules (`.gca`), or a catalog (`.yaml`), that the user has opened, as text; the rules, or classes, that are `off` are left out. */
export interface RuleFile {
  name: string;
  text: string;
  off: string[];
}

/** Files of rules, to be checked. */
export interface RulesArgs {
  files: RuleFile[];
}

export interface BenchArgs {
  text: string;
  /** Rules that hold from the start, those that are wrong left out. */
  rules?: RuleFile[];
  source?: Source;
  pose?: Pose;
}

/** The text of the bench, to be saved as a script. */
export interface ScriptArgs {
  text: string;
  source?: Source;
}

/** The text of the bench up to the cursor. */
export interface CompleteArgs {
  text: string;
  source?: Source;
}

export interface ComposeArgs {
  drawing: Sketch;
}

export type Format = "html" | "latex" | "svg" | "png" | "pdf" | "json" | "yaml" | "proof" | "coq" | "c" | "cpp" | "py" | "rs";

/** The pose that Python or another page brings after the one of this number; `page` is a name of the page's own. */
export interface FollowArgs {
  page: string;
  after: number;
}

/** The pose that a page has moved the robot to. */
export interface ShowArgs {
  page: string;
  source: Source;
  pose: Pose;
}

/** Other coordinates of a platform's points, as they are written ("" keeps one), and other limits of its legs. */
export interface ResizeArgs {
  source: Source;
  points: Record<string, [string, string, string]>;
  limits?: string;
}

export interface CancelArgs {
  target: number;
}

/** Characters of a picture of the page that goes into a report. */
export const LARGEST_PICTURE = 400000;

/** Characters of the state in a link that programs take whole; what makes it longer is left out, and the reader is told. */
export const LONGEST_LINK = 65000;

export const LONGEST_TITLE = 200;

/** Characters of a title, and of a note, that go into a report. */
export const LONGEST_NOTE = 20000;

/** What a line repeats: methods, and the table of the actuators. */
export type Repeatable = "open" | "pose" | "actuators" | "path" | "map" | "surface" | "locus" | "assemblies" | "aspects" | "free" | "boxes" | "certify" | "manual" | "bench";

/** A method with its arguments, which are checked as if it were asked for. */
export interface RepeatArgs {
  source?: Source;
  what: Repeatable;
  args: Record<string, unknown>;
}

/** Methods whose answers have certificates of their own. */
export type Checkable = "path" | "map" | "free" | "boxes";

/** A method with its arguments, as for a line that repeats it. */
export interface CertificateFileArgs {
  source: Source;
  what: Checkable;
  args: Record<string, unknown>;
}

/** The same with a title, for a report; the source is that of the report. */
export interface Reported {
  title: string;
  what: Repeatable;
  args: Record<string, unknown>;
}

export interface Note {
  title: string;
  text: string;
}

/** What a report shows of the state of the page beside the analysis and the pose: answers of its panels, which lines repeat, the picture as it stands, notes, and the link that opens the state again. */
export interface State {
  answers: Reported[];
  picture: string;
  notes: Note[];
  link: string;
}

export interface SaveArgs extends PoseArgs {
  what: Format;
  state?: State;
}

/** A change of a robot's sheet; which fields it needs `do` says. Places count from 0. */
export interface SheetEdit {
  do: "title" | "limb add" | "limb remove" | "limb move" | "limb name" | "limb cable" | "limb duplicate" | "limb around" | "limb single" | "copies" | "joint add" | "joint remove" | "joint move" | "joint kind" | "joint drive" | "joint part" | "name add" | "name rename" | "name relation" | "home" | "mobility" | "unit";
  limb?: number;
  chain?: number;
  joint?: number;
  part?: number;
  to?: number;
  name?: string;
  text?: string;
  texts?: [string, string, string];
  degrees?: number;
  follow?: boolean;
}

/** The text of a robot file, after a change if there is one; without a text that of the robot in `start`, or of one to begin with. */
export interface LimbsArgs {
  text?: string;
  start?: Source;
  /** Whether the limb to begin with is that of a planar robot. */
  plane?: boolean;
  edit?: SheetEdit;
}

/** Where in a text that was sent: offsets in characters of JavaScript from its start. */
export interface Place {
  start: number;
  end: number;
  line: number;
  column: number;
}

/** A fault in words. */
export interface Fault {
  kind: "input" | "limit" | "superseded" | "cancelled" | "fault";
  message: string;
  hint?: string;
  place?: Place;
  /** Further faults of the same text (files tell all faults at once). */
  more?: Fault[];
}

export interface Hello {
  version: string;
  /** Changes when the server is another process. */
  instance: string;
  /** What the command line named: opened by a page that holds nothing else. */
  opened: Source | null;
  /** Whether Python shares the pose of what it has opened: the page follows it (`follow`), and tells it (`show`). */
  shared: boolean;
  /** Whether the guide is served below `guide/`. */
  guide: boolean;
}

export interface GalleryItem {
  id: string;
  title: string;
  /** A few words: the legs, the mobility. */
  detail: string;
  group: string;
  statement: string;
  /** More words by which it is found. */
  words: string;
  /** The place among the cards that a newcomer knows; null for all others. */
  familiar: number | null;
  /** A drawing, trusted (made by the server). */
  svg: string;
  source: Source;
}

/** A script for the bench. */
export interface Theorem {
  title: string;
  text: string;
}

export interface Gallery {
  classes: GalleryItem[];
  robots: GalleryItem[];
  examples: GalleryItem[];
  theorems: Theorem[];
}

/** A piece of a formula that stays on one line, with the points and entities in it. */
export interface Piece {
  tex: string;
  points: string[];
  brackets: string[][];
}

export interface Bracket {
  points: string[];
  tex: string;
}

export interface Monomial {
  sign: 1 | -1;
  coefficient: string;
  brackets: Bracket[];
}

export interface OrdersCount {
  terms: number;
  orders: number;
}

export interface Step {
  rule: string;
  why: string;
  before: Piece[];
  after: Piece[];
}

export interface TextItem {
  kind: "text";
  text: string;
}

export interface FactItem {
  kind: "fact";
  key: string;
  value: string;
}

/** The answer in a sentence, and what it consists of, with how sure it is. */
export interface Account {
  verdict: string;
  facts: FactItem[];
}

export interface FormulaItem {
  kind: "formula";
  left: Piece[];
  right: Piece[];
}

export interface MonomialsItem {
  kind: "monomials";
  monomials: Monomial[];
}

export interface OrdersItem {
  kind: "orders";
  tried: number;
  counts: OrdersCount[];
  best: string;
}

export interface EntitiesItem {
  kind: "entities";
  entities: string[];
}

export interface StepsItem {
  kind: "steps";
  steps: Step[];
}

export type Item = TextItem | FactItem | FormulaItem | MonomialsItem | OrdersItem | EntitiesItem | StepsItem;

export type StageId = "limbs" | "equivalent" | "structure" | "superbracket" | "shortest" | "tetrahedra" | "planes" | "lines" | "left-over" | "condition" | "statement" | "check";

export interface Stage {
  id: StageId;
  title: string;
  /** What is done and why, for a non-expert. */
  why: string;
  /** The theory, in a few paragraphs of text. */
  more: string[];
  items: Item[];
}

export interface Measure {
  name: string;
  meaning: string;
  unit: string;
}

export interface Axis {
  name: string;
  unit: string;
  low: number;
  high: number;
  step: number;
}

export interface Certificate {
  method: string;
  detail: string;
}

export interface Condition {
  kind: string;
  /** The left and the right side of the identity, one piece for each monomial or factor. */
  left: Piece[];
  right: Piece[];
  text: string;
  cofactor: string;
  statement: string;
  certificate: Certificate;
}

export interface Part {
  text: string;
  tex: string;
  kind: string;
  statement: string;
}

/** A robot with limbs: what Fig. 1 of the paper shows side by side. */
export interface Robot {
  mobility: number;
  /** When it is singular, in its own words. */
  statement: string;
  /** SVG: the robot with its wrenches, and beside it the lines that stand for them, at home. */
  figure?: string;
  limbs: Limb[];
  parts: Part[];
}

/** An actuator, the joint of the model that it is, and what it reaches from home ("", where there is no limit). */
export interface Drive {
  name: string;
  joint: string;
  limits: string;
}

/** How a model was read as a robot. */
export interface Model extends Account {
  drives: Drive[];
}

export interface Entry {
  id: string;
  name: string;
}

export interface ShapeRow {
  name: string;
  /** Where it is in the file; null where that follows from others. */
  at: Vec3 | null;
}

export interface ShapeGroup {
  title: string;
  sort: "point" | "direction";
  axes: string[];
  rows: ShapeRow[];
}

/** The dimensions as they are changed, all of them at home. */
export interface Shape {
  groups: ShapeGroup[];
  /** What a plan joins by lines. */
  bars: LegEnds[];
}

/** Everything about the structure that does not change with the pose. */
export interface Study {
  title: string;
  note: string;
  kind: "platform" | "robot";
  legs: LegEnds[];
  base: string[];
  platform: string[];
  /** Coordinates at the file's own pose. */
  points: Record<string, Vec3>;
  unit: string;
  shape: Shape;
  /** What its file says that legs or actuators reach, as written. */
  limits: string;
  /** The coordinates are a sample shape, none were given. */
  invented: boolean;
  /** Centre of the platform's turns. */
  about: Vec3;
  /** A length to scale sliders and the camera by. */
  size: number;
  /** What the pose consists of: six coordinates of a platform; the actuators of a robot with limbs. */
  axes: Axis[];
  /** Of a robot with limbs: coordinates of its platform that are independent at home. */
  freedoms: Axis[];
  /** Coordinates of its pose, then its actuators, over which it can be mapped, with ranges to begin with. */
  ranges: Axis[];
  /** Coordinates of its pose over which a map of whole boxes can go, with ranges to begin with. */
  wholes: Axis[];
  /** What the bands of such a map can be, the margin first. */
  measures: Measure[];
  /** Pairs of coordinates of the map over which the singular poses may have a formula. */
  loci: string[][];
  /** Why they have none over any coordinates; "" where they may have one. */
  no_locus: string;
  /** The class of the catalog. */
  entry: Entry | null;
  /** SVG of the legs as a graph. Elements carry data-point="a" and data-leg="ab". */
  schematic: string;
  stages: Stage[];
  entities: Entity[];
  /** How what is constructed follows from the joints of a platform that moves, for poses that are drawn in passing. */
  recipe: Recipe | null;
  condition: Condition;
  readings: Condition[];
  robot: Robot | null;
  /** What was made of the model of links and joints that was opened; null for other files. */
  model: Model | null;
}

/** A leg with its length, or an actuator with its amount from home, and what the file says that it reaches; at its unit rate, the others locked, the `speed` of the platform's centre and the `turn` of the platform, with units ("" where there are none). */
export interface Actuator {
  name: string;
  value: number;
  unit: string;
  low: number | null;
  high: number | null;
  speed: string;
  turn: string;
}

/** A working mode at home; its drives are from the home of the file. */
export interface Mode {
  name: string;
  verdict: Verdict | null;
  margin: number | null;
  /** Those of the condition's factors whose zeros are singularities. */
  signs: string;
  /** The robot at home in this mode; empty where it does not assemble. */
  svg: string;
  drives: string;
}

export interface ModesAnswer {
  modes: Mode[];
  /** How many there are; of very many only some are listed. */
  number: number;
  /** How many ways the limbs have to hold the platform. */
  ways: string[];
}

export interface Reading {
  part: string;
  name: string;
  meaning: string;
  value: number | null;
  unit: string;
  why: string;
}

/** A number that changes continuously with the pose and is 0 in singular poses only. */
export interface Sign {
  expression: string;
  sign: number;
  /** What is singular where it is 0; "" for the determinant of the undriven joints' screws, which says no more. */
  statement: string;
}

/** What is said first of a pose. */
export interface Headline {
  /** The pose that this answers. */
  pose: Pose;
  /** Superbracket over its scale: dimensionless, with the sign of the superbracket. */
  value: number;
  /** The singularity margin σ: 0 at a singular pose, at most 1. */
  margin: number;
  /** Below this margin the pose counts as close; null where the threshold is a length. */
  close: number | null;
  verdict: Verdict;
}

export interface Numbers extends Headline {
  /** Those of the study there, in their units. */
  freedoms: number[];
  /** Where the platform of a robot with limbs is, from home; null for one on six legs, whose pose says it. */
  platform: Pose | null;
  points: Record<string, Vec3>;
  reason: string;
  causes: string[];
  readings: Reading[];
  constructed: Constructed[];
  /** Given near a singular pose. */
  motion: Motion | null;
  /** Ratios of the forces in the legs that balance, near a singular pose. */
  stress: number[];
  limbs: Limb[];
  /** Of a robot with limbs. */
  skeleton: Skeleton | null;
  /** Unit vectors of points at infinity, in this pose. */
  directions: Record<string, Vec3>;
  notes: string[];
  /** None where there are no legs or joints with numbers. */
  actuators: Actuator[];
  jacobian: FactItem[];
  /** Of the factors of the condition, and of the determinant of the undriven joints' screws: where one changes between two poses, every way between them is singular. */
  signs: Sign[];
}

export interface SingularPose {
  kind: string;
  distance: number;
  unit: string;
  certified: boolean;
  text: string;
  pose: Pose;
  causes: string[];
}

export interface Nearest {
  found: SingularPose[];
  /** Of a robot with limbs: what was searched, in words; the kinds are "along +z" …, the closest one stands first. */
  note?: string;
}

export interface Along {
  margin: number[];
  value: number[];
  verdicts: Verdict[];
}

export interface ManualStep {
  command: string;
  answer: "confirmed" | "refused" | "possible" | "done";
  words: string;
  monomial: number | null;
}

export interface Form {
  name: string;
  order: string;
  monomials: Monomial[];
}

export interface Hint {
  command: string;
  words: string;
}

export interface ExactPoint {
  at: Vec3;
  /** The same coordinates as fractions. */
  exactly: string[];
}

export interface Manual {
  /** The commands that were understood; the first faulty one stops the replay and is `fault`. */
  history: ManualStep[];
  form: Form;
  entities: Entity[];
  left: string[];
  hint: Hint | null;
  /** Points of an exact counterexample, if the last proposal was refused by one. */
  counterexample: Record<string, ExactPoint> | null;
  condition: Condition | null;
  fault: Fault | null;
}

export interface RepeatedFile {
  name: string;
  text: string;
}

export interface Repeated {
  shell: string;
  /** Empty where no function of Python does it. */
  python: string;
  /** What has to be saved first, since the lines name it. */
  files: RepeatedFile[];
}

export interface DrawnPlane extends Plane {
  kind: "plane";
}

/** Who brought a rule: gcrules, a plugin, a file that the page has opened, or the text of the bench. */
export interface RuleOwner {
  kind: "gcrules" | "plugin" | "file" | "text";
  /** Of the plugin or file; "" for others. */
  name: string;
  /** In the file. */
  line: number | null;
}

export interface AppliedRule {
  id: string;
  sentence: string;
  owner: RuleOwner;
}

export interface BenchResult {
  /** Offsets of the statement in the text. */
  start: number;
  end: number;
  name: string | null;
  /** The command of the prompt that was asked, if it is one. */
  command: string | null;
  verdict: "value" | "proved" | "refuted" | "undecided" | "done";
  text: string;
  /** Those with which an analysis opens. */
  sentences: string[];
  /** Whether rules have rewritten it in several steps, or in none. */
  way: boolean;
  /** The whole answer in LaTeX; "" where it is none, or too long. */
  tex: string;
  pieces: Piece[];
  /** How many pieces there are; of very many only the first are sent. */
  terms: number;
  step: number | null;
  /** What can be drawn in 3D with the points of the study, at its pose. */
  drawn: Constructed | DrawnPlane | null;
  /** The rules that led to it, in their order. */
  applied: AppliedRule[];
  /** The lines that give this answer alone; null where they would be too long. */
  repeat: Repeated | null;
}

export interface Bench {
  results: BenchResult[];
  fault: Fault | null;
}

/** One result, as soon as it is there, and its place among all of them. */
export interface BenchPart {
  index: number;
  result: BenchResult;
}

export interface Scripted {
  text: string;
}

/** What may stand at a place, in the place of the last `length` characters before it. */
export interface Completed {
  options: Completion[];
}

export interface Completion {
  text: string;
  length: number;
  help: string;
}

export interface Composed {
  text: string;
}

export interface Saved {
  name: string;
  mime: string;
  /** Text, or base64 where `binary`. */
  data: string;
  binary: boolean;
}

export interface Resized {
  source: FileSource;
}

export interface Cancelled {
  cancelled: boolean;
}

export interface Followed {
  after: number;
  pose: Pose;
}

export interface Shown {
  /** Whether it is a pose of the robot that is shared. */
  shared: boolean;
}

/** Where the axes are in a picture, as parts of its width and of its height from above. */
export interface Frame {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export interface PathSample {
  parameter: number;
  margin: number;
  /** null where it is not known that the sliders lead to this configuration from home. */
  pose: Pose | null;
  /** Where the platform is then, from home, turned about `about` of the study: of a platform on six legs, its pose. */
  platform: Pose | null;
}

/** A singular place on a path, with what happens there, why, and what is gained, in sentences. */
export interface PathPlace {
  parameter: number;
  /** The parameter as a fraction; "" where it is none. */
  exactly: string;
  /** The pose, as `gcrules pose --at` takes it. */
  at: string;
  words: string[];
  sure: string;
  pose: Pose | null;
}

export interface PathStretch {
  start: number;
  end: number;
  /** Every pose is singular; else it is not decided whether one is. */
  singular: boolean;
  words: string[];
}

export type PlanOutcome = "way" | "none" | "undecided";

/** What came of looking for a way around singular poses; where there is none the path is the straight one. */
export interface Detour {
  outcome: PlanOutcome;
  words: string;
  /** Those that the way goes straight through, as `gcrules path --pose` takes them. */
  poses: string[];
}

export interface PathAnswer {
  verdict: Verdict;
  reason: string;
  svg: string;
  frame: Frame;
  /** The parameter of the last pose; that of the first is 0. */
  end: number;
  samples: PathSample[];
  places: PathPlace[];
  /** Places that are left out. */
  more: number;
  stretches: PathStretch[];
  detour: Detour | null;
  facts: FactItem[];
}

export interface WaypointsAnswer {
  poses: Pose[];
  /** The same poses as `gcrules path --poses` reads them. */
  table: string;
  notes: string[];
}

export type CellStatus = "free" | "crossed" | "undecided" | "outside";

/** Singular poses in the coordinates of the axes, within the limits throughout (`reached`) or nowhere. */
export interface Curve {
  points: number[][];
  reached: boolean;
}

/** A map over two coordinates. Arrays run over the first axis, then over the second. */
export interface MapAnswer {
  axes: Axis[];
  curves: Curve[];
  /** σ at the nodes; null where the robot does not get. */
  margin: ((number | null)[])[];
  /** The measure at the nodes, where it is another one than the margin; null where it is infinite. */
  index: ((number | null)[])[];
  /** Of the cells between them. */
  status: CellStatus[][];
  /** What the coordinates are that no axis shows; empty where there are none. */
  fixed: string;
  guarantee: string;
  statement: string;
  facts: FactItem[];
}

/** The singular surface over x, y and z: how far the platform is from home where it is singular. */
export interface SurfaceAnswer {
  /** x, y, z of each corner in turn, in the unit of lengths. */
  vertices: number[];
  /** Three corners each, by number. */
  faces: number[];
  /** Which corners keep to the limits. */
  reached: boolean[];
  /** How many poses there are along each coordinate. */
  nodes: number[];
  /** Cells that are proved free of singular poses, of so many `cells`. */
  free: number;
  cells: number;
  guarantee: string;
  resolution: string;
  facts: FactItem[];
  /** Other freedoms of a robot with limbs, at which this holds: in radians or in its unit. Of a platform on six legs it holds at the turn of its pose. */
  held: Record<string, number>;
}

/** Where a pose is in a map: its coordinates in the units of the axes, and what the others are. */
export interface HereAnswer {
  at: number[];
  fixed: string;
}

export interface PlacedPose {
  pose: Pose;
}

export interface Polynomial {
  degree: number;
  terms: number;
  plain: string;
  latex: string;
  /** A function of its variables, for numbers, arrays and symbols; of roots it takes the signs, in home's mode 1. */
  python: string;
}

export interface LocusFactor {
  polynomial: Polynomial;
  multiplicity: number;
  /** It is 0 in no pose. */
  never: boolean;
  /** What its zeros are, "a plane with the normal (0, 0, 1)"; "" where they have no name. */
  zeros: string;
}

/** The polynomial of the condition, or of one of its factors: `statement` says which. */
export interface LocusPart {
  name: string;
  statement: string;
  polynomial: Polynomial;
  factors: LocusFactor[];
  /** Why its factors are not known; "" where they are. */
  undecided: string;
}

/** A root that is a variable of the polynomials: its `square`, and whose `sign` it has in home's mode ("" where it is positive there). */
export interface Root {
  name: string;
  places: string;
  square: Polynomial;
  sign: string;
}

export interface LocusAnswer {
  variables: string[];
  /** What the zeros are. */
  statement: string;
  /** How the pose was rounded. */
  notes: string[];
  parts: LocusPart[];
  roots: Root[];
  facts: FactItem[];
}

export interface AssemblyMode {
  number: number;
  /** It is the pose that was asked about. */
  given: boolean;
  verdict: Verdict;
  margin: number;
  signs: string;
  /** The pose, from that of the file. */
  at: string;
  /** What is proved of it. */
  sure: string;
  svg: string;
  /** null where the actuators do not lead there: the robot is opened in this `mode` instead. */
  pose: Pose | null;
  mode: string | null;
}

export interface AssembliesAnswer extends Account {
  modes: AssemblyMode[];
}

/** Poses of one aspect: how many, with which signs, the assembly modes among them, and the one farthest from being singular. */
export interface AspectSet {
  name: string;
  signs: string;
  poses: number;
  modes: number[];
  at: string;
  margin: number;
  /** null where the sliders do not lead to it. */
  pose: Pose | null;
}

export interface AspectsAnswer extends Account {
  least: number;
  most: number;
  sets: AspectSet[];
  /** Which assembly modes share an aspect, in sentences. */
  changes: string[];
}

/** What a coordinate may be, both ends rounded to the inside. */
export interface Range {
  name: string;
  low: string;
  high: string;
  unit: string;
}

export interface FreeAnswer extends Account {
  ranges: Range[];
}

/** A part of the volume, from 0 to 1, of which the same is known. */
export interface Share {
  kind: "free" | "other" | "outside" | "crossed" | "undecided";
  share: number;
  words: string;
}

export interface BoxesAnswer extends Account {
  /** The share of the volume that is proved to be free, or not to be reached. */
  decided: number;
  /** The same in a sentence. */
  so_much: string;
  shares: Share[];
  /** SVG in base64; empty where matplotlib is missing, or nothing is left to be seen. */
  picture: string;
  /** What it shows, in words. */
  seen: string;
}

/** A pose that is singular, or has a margin below the one asked for; else the one with the smallest margin that was seen. */
export interface CertifiedPlace {
  kind: "singular" | "below" | "least";
  /** Its coordinates over which the range goes. */
  words: string;
  margin: number;
  causes: string[];
  /** null where the sliders do not lead there. */
  pose: Pose | null;
  /** They end just short of it. */
  short: boolean;
}

/** Whether the whole range is free, with the file that says so. */
export interface CertificateAnswer extends BoxesAnswer {
  answer: "free" | "outside" | "singular" | "below" | "undecided";
  /** What the margin is at least in all boxes that are free, proved. */
  bound: number | null;
  place: CertifiedPlace | null;
  file: Saved;
  /** How it is checked again. */
  check: string;
}

/** The file of an answer that another program checks. */
export interface CertificateFile {
  file: Saved;
  /** How it is checked again. */
  check: string;
}

export interface PartKind {
  name: string;
  form: "point" | "direction" | "number";
}

/** A way to drive a joint: as it is written, and in words. */
export interface DriveKind {
  star: string;
  words: string;
}

export interface JointKind {
  symbol: string;
  name: string;
  parts: PartKind[];
  drives: DriveKind[];
}

/** A name that nothing defines yet, and what it should be. */
export interface Undefined {
  name: string;
  sort: "point" | "direction";
}

export interface JointRow {
  kind: string;
  /** As it is written: empty where it is not driven; with a number where one of two freedoms is. */
  star: string;
  /** For couplings. */
  name: string;
  parts: string[];
  undefined: Undefined[];
  faults: Fault[];
}

export interface ChainRow {
  /** Between which bodies it leads, "base to hub"; empty in a plain limb. */
  head: string;
  joints: JointRow[];
}

export interface WrenchRow {
  text: string;
  couple: boolean;
  role: "constraint" | "actuation" | "both";
}

export interface LimbRow {
  name: string;
  /** How many limbs it stands for. */
  copies: number;
  /** Whether it stands for the copies of the file. */
  numbered: boolean;
  /** Its joints in short. */
  chain: string;
  /** The points that a cable joins; none for a limb of joints. */
  cable: string[];
  /** Of the ends of a cable. */
  undefined: Undefined[];
  chains: ChainRow[];
  couplings: string;
  /** What it applies with its actuators locked, in words; empty as long as that is not known. */
  system: string;
  freedoms: number;
  constraints: number;
  /** Those of the first copy; none where no lines span them. */
  wrenches: WrenchRow[];
  colour: number;
  faults: Fault[];
}

export interface NamedPlace {
  name: string;
  /** Three coordinates at home as they are written; none where the relations determine them. */
  at: string[];
}

export interface NameRow {
  name: string;
  sort: "point" | "direction";
  relation: string;
  /** One for each copy. */
  places: NamedPlace[];
  faults: Fault[];
}

export interface LimbSheet {
  title: string;
  copies: number;
  /** Whether all copies are turned about z from the first one, evenly. */
  turned: boolean;
  plane: boolean;
  unit: string;
  platform: string;
  limbs: LimbRow[];
  names: NameRow[];
}

/** The freedoms of the platform; null as long as they are not known. `written` is what the file says. */
export interface Mobility {
  number: number | null;
  written: string;
  drives: number;
  sentence: string;
  faults: Fault[];
}

export interface LimbsAnswer {
  /** The file, after the change. */
  text: string;
  /** Null where the text is no table of limbs; `every` says why. */
  sheet: LimbSheet | null;
  /** Those that are in no row of the table. */
  faults: Fault[];
  /** All faults, at their places in the text. */
  every: Fault | null;
  mobility: Mobility;
  /** The robot at home, as far as it can be drawn. */
  scene: SceneData | null;
  kinds: JointKind[];
  units: string[];
}

/** The commands of the prompt that work on the bench, where none of them opens a file. */
export const BENCH_COMMANDS = ["expand", "straighten", "steps", "factor", "factors", "shorten", "transversals", "prove", "discover", "analyze", "latex"] as const;

/** Each with how it is written and what it is. */
export const BENCH_WORDS = [["rank", "rank N", "the rank, before everything else; 4 if left out"], ["points", "points NAMES", "long names, and the tableau order"], ["ideal", "ideal NAMES", "points at infinity"], ["isotropic", "isotropic i j", "in the plane: points at infinity on all circles, for metric words"], ["orthonormal", "orthonormal i j k", "in space: directions at right angles, for metric words; in the plane two"], ["line", "line NAMES", "letters that stand for lines, each with Plücker coordinates of its own"], ["plane", "plane NAMES", "letters that stand for planes"], ["hyperplane", "hyperplane NAMES", "letters that stand for hyperplanes, of one step less than the rank"], ["conic", "conic NAMES", "in the plane: letters that stand for conics, of which words speak: polar(p, K)"], ["quadric", "quadric NAMES", "in space: letters that stand for quadrics, of which words speak: polar(p, Q)"], ["screw", "screw NAMES", "in space: letters that stand for screws, wrenches and twists of any pitch"], ["given", "given collinear(a, b, c), …", "what is assumed: relations of points, lines and planes, LHS == RHS too"], ["let", "let NAME = EXPR", "a name for an expression"], ["claim", "claim [\"label\":] LHS == RHS", "an equation, or a relation, to prove and to save"], ["show", "show EXPR", "an expression to expand, and to save"], ["rule", "rule ID [\"sentence\"]: LHS => RHS [if …]", "a rule to prove and to rewrite by"], ["rewrite", "rewrite EXPR", "an expression rewritten by the rules so far"], ["midpoint", "midpoint(a, b)", "the midpoint of a and b"], ["centroid", "centroid(a, b, c, …)", "the centroid of the points"], ["reflection", "reflection(p, f)", "p reflected in f"], ["mirror", "mirror(p, ab)", "p reflected in a line of the plane, in a line or a plane in space"], ["direction", "direction(ab)", "the point at infinity of a line"], ["parallel_through", "parallel_through(c, ab)", "the line through c parallel to ab"], ["perpendicular_through", "perpendicular_through(c, ab)", "the perpendicular through c; in space of a line a plane, and of a plane a line"], ["foot", "foot(c, ab)", "the foot of the perpendicular from c to a line, or to a plane"], ["bisector", "bisector(a, b)", "the perpendicular bisector of a and b: a line, in space a plane"], ["circumcentre", "circumcentre(a, b, c)", "the centre of the circle through three points; in space of the sphere through four"], ["orthocentre", "orthocentre(a, b, c)", "where the altitudes of a triangle meet"], ["second_on_circle", "second_on_circle(p, a, b, c)", "the second point of the line pa on the circle through a, b and c"], ["second_on_conic", "second_on_conic(p, a, b, c, d, e)", "the second point of the line pa on the conic through a, b, c, d and e; second_on_conic(p, a, K): the second point of the line pa on the conic K, of which a is a point"], ["tangent", "tangent(a, b, c, d, e)", "the tangent at a of the conic through the five points; tangent(a, K): the tangent at a point a of the conic K; tangent(a, Q): the tangent plane at a point a of the quadric Q"], ["polar", "polar(p, a, b, c, d, e)", "the polar of p for the conic through the other points; polar(p, K): the polar of p for the conic K; polar(p, Q): the polar plane of p for the quadric Q, or the polar line of a line"], ["pole", "pole(pq, a, b, c, d, e)", "the pole of the line pq for the conic through the other points; pole(pq, K): the pole of any line for the conic K; pole(P, Q): the pole of any plane for the quadric Q"], ["conic", "conic(a, b, c, d, e, f)", "the scalar that is zero where the six points are on a conic; conic(p, K): the scalar that is zero where p is on the conic K"], ["quadric", "quadric(a, b, c, d, e, f, g, h, i, j)", "the scalar that is zero where the ten points are on a quadric; quadric(p, Q): the scalar that is zero where p is on the quadric Q"], ["parallel", "parallel(ab, cd)", "two lines have one direction, in space also a line and a plane; two planes meet at infinity"], ["perpendicular", "perpendicular(ab, cd)", "two lines are at right angles, in space also planes, or a line and a plane"], ["concyclic", "concyclic(a, b, c, d, …)", "the points are on a circle, or on a line"], ["cospherical", "cospherical(a, b, c, d, e, …)", "the points are on a sphere, or in a plane"], ["equidistant", "equidistant(o, a, b, …)", "o is as far from a as from b and the others"], ["equal_distance", "equal_distance(ab, cd, …)", "a is as far from b as c from d"], ["on_conic", "on_conic(a, b, c, d, e, f, …)", "the points are on a conic, which may be two lines; on_conic(p, q, …, K): the points are on the conic K"], ["on_quadric", "on_quadric(a, b, c, d, e, f, g, h, i, j, …)", "the points are on a quadric, which may be a cone or two planes; on_quadric(p, q, …, Q): the points are on the quadric Q"], ["second_on_quadric", "second_on_quadric(p, a, Q)", "the second point of the line pa on the quadric Q, of which a is a point"], ["touches", "touches(L, K)", "the line L touches the conic K; touches(P, Q): the plane P touches the quadric Q, or a line does"], [":expand", ":expand [EXPR]", "expand into brackets, as an expression alone does"], [":straighten", ":straighten [EXPR]", "the normal form of standard tableaux"], [":steps", ":steps [EXPR]", "straighten a scalar, every single syzygy shown"], [":factor", ":factor [EXPR]", "one expression of joins and meets that equals a scalar"], [":factors", ":factors [EXPR]", "the irreducible factors of a scalar, each with a form"], [":shorten", ":shorten [EXPR]", "the bracket polynomial of a scalar with the fewest terms"], [":transversals", ":transversals LEGS", "compare the turns about two lines that meet four legs"], [":prove", ":prove LHS == RHS", "decide an equation or a relation, as one alone does"], [":discover", ":discover [RELATION]", "what holds of the points so far, and is not trivial"], [":analyze", ":analyze LEGS", "when and why a robot with six legs is singular"], [":latex", ":latex [EXPR|on|off]", "LaTeX of an expression, or of all answers"]] as const;

/** How an operation is written, and what it is; from the tightest to the loosest. */
export const BENCH_OPERATIONS = [["abc", "points side by side: their join"], ["a \\/ bc", "join: ∨ \\vee"], ["ab /\\ cde", "meet: ∧ ^ \\wedge"], ["2 [abcd] * (ab /\\ cd)", "product; a space or nothing between scalars"], ["[abcd]**2", "power"], ["[abcd], [(ab /\\ cde), f, gh]", "bracket: the determinant of points, or of extensors"], ["[[ab, cd, ef, gh, ij, kl]]", "superbracket of six lines"], ["[.a d e f][.b g h i]", "dotted points: the signed sum over all ways to share them out"], ["midpoint(a, b), foot(c, ab), …", "points, lines and planes that words make; more with :help words"], ["LHS == RHS, collinear(a, b, c), …", "an equation or a relation, proved or refuted"], ["%, %%, …", "the last result, the one before it, …"]] as const;

/** The words of expressions that have arguments. */
export const BENCH_CONSTRUCTIONS = ["midpoint", "centroid", "reflection", "mirror", "direction", "parallel_through", "perpendicular_through", "foot", "bisector", "circumcentre", "orthocentre", "second_on_circle", "second_on_conic", "tangent", "polar", "pole", "conic", "quadric", "second_on_quadric"] as const;

/** The words that may begin an assumption. */
export const BENCH_RELATIONS = ["collinear", "coplanar", "concurrent", "incident", "parallel", "perpendicular", "concyclic", "cospherical", "equidistant", "equal_distance", "on_conic", "on_quadric", "touches", "ideal", "isotropic", "orthonormal", "line", "plane", "hyperplane", "conic", "quadric", "screw"] as const;

export interface CheckedRule {
  id: string;
  sentence: string;
  /** As it is written. */
  text: string;
  line: number;
  verdict: "proved" | "refuted" | "undecided" | "refused";
  reason: string;
  /** What is wrong with it, with its place in the file; it is not used then. Without a fault, a class that is not decided is used, and answers say that it is unproved. */
  fault: Fault | null;
}

export interface CheckedRuleFile {
  name: string;
  kind: "rules" | "catalog";
  /** The rules, or the classes of a catalog. */
  rules: CheckedRule[];
  /** Where the file as a whole cannot be read. */
  fault: Fault | null;
}

export interface CheckedRules {
  files: CheckedRuleFile[];
}

export interface PluginRule {
  id: string;
  family: string;
  sentence: string;
  /** An identity as it is written; "" for rules given in Python. */
  text: string;
  holds: boolean;
  /** What was checked, or what is wrong. */
  reason: string;
}

/** A plugin with what it brings; its checks are those of `gcrules rules check`. */
export interface Plugin {
  name: string;
  kind: "shipped" | "package" | "folder";
  rules: PluginRule[];
  robots: string[];
  catalogs: string[];
}

export interface PluginsAnswer {
  plugins: Plugin[];
  /** Those that the studio was started with. */
  folders: string[];
  /** How many plugins that come with gcrules bring a robot only. */
  robots: number;
}

export interface Methods {
  hello: { args: NoArgs; result: Hello; part: never };
  gallery: { args: NoArgs; result: Gallery; part: never };
  open: { args: OpenArgs; result: Study; part: never };
  pose: { args: PoseArgs; result: Numbers; part: Headline };
  move: { args: MoveArgs; result: PlacedPose; part: never };
  along: { args: AlongArgs; result: Along; part: never };
  nearest: { args: PoseArgs; result: Nearest; part: never };
  modes: { args: ModesArgs; result: ModesAnswer; part: never };
  path: { args: PathArgs; result: PathAnswer; part: never };
  waypoints: { args: WaypointsArgs; result: WaypointsAnswer; part: never };
  map: { args: MapArgs; result: MapAnswer; part: never };
  surface: { args: SurfaceArgs; result: SurfaceAnswer; part: never };
  place: { args: PlaceArgs; result: PlacedPose; part: never };
  here: { args: HereArgs; result: HereAnswer; part: never };
  locus: { args: LocusArgs; result: LocusAnswer; part: never };
  assemblies: { args: PoseArgs; result: AssembliesAnswer; part: never };
  aspects: { args: OpenArgs; result: AspectsAnswer; part: never };
  free: { args: FreeArgs; result: FreeAnswer; part: never };
  boxes: { args: BoxesArgs; result: BoxesAnswer; part: never };
  certify: { args: CertifyArgs; result: CertificateAnswer; part: never };
  certificate: { args: CertificateFileArgs; result: CertificateFile; part: never };
  manual: { args: ManualArgs; result: Manual; part: never };
  bench: { args: BenchArgs; result: Bench; part: BenchPart };
  rules: { args: RulesArgs; result: CheckedRules; part: never };
  plugins: { args: NoArgs; result: PluginsAnswer; part: never };
  complete: { args: CompleteArgs; result: Completed; part: never };
  script: { args: ScriptArgs; result: Scripted; part: never };
  compose: { args: ComposeArgs; result: Composed; part: never };
  resize: { args: ResizeArgs; result: Resized; part: never };
  limbs: { args: LimbsArgs; result: LimbsAnswer; part: never };
  save: { args: SaveArgs; result: Saved; part: never };
  repeat: { args: RepeatArgs; result: Repeated; part: never };
  follow: { args: FollowArgs; result: Followed; part: never };
  show: { args: ShowArgs; result: Shown; part: never };
  cancel: { args: CancelArgs; result: Cancelled; part: never };
}
export type Method = keyof Methods;

/** Of one `channel` only the latest unanswered request is worked on; older ones are answered `superseded`. */
export interface Request<M extends Method = Method> {
  id: number;
  do: M;
  args: Methods[M]["args"];
  channel?: string;
}

export type Reply<M extends Method = Method> =
  | { id: number; ok: true; result: Methods[M]["result"]; ms: number }
  | { id: number; ok: false; error: Fault }
  | { id: number; progress: string }
  | { id: number; part: Methods[M]["part"] };
