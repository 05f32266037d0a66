// The pure parts of the page. `npm test` bundles this file and runs it with Node.
import "./framing";
import { strict as assert } from "node:assert";
import test from "node:test";
import { digitsOf } from "../src/page/pose/axis-slider";
import { hangOf } from "../src/page/lib/hanging";
import { fitting, readNumber } from "../src/page/parts/number-field";
import { litPoints, pointTarget, bracketTarget } from "../src/page/state/lit";
import { wordsOf } from "../src/page/lib/prose";
import { ANGLES, between, fromAngles, sameTurn, toAngles } from "../src/page/lib/rotation";
import { along, degreesOf } from "../src/page/lib/scale";
import { splitBrackets, splitOperator } from "../src/page/lib/tex";
import { tintOf } from "../src/page/lib/tint";
import { chosen } from "../src/page/start/filter";
import { EMPTY, HOME, TOUR, atHome, isHome, samePose, type Doc, type Range, type Tour } from "../src/page/state/doc";
import { linkOf, plainFragment, readFragment } from "../src/page/state/fragment";
import { LONGEST_LINK } from "../src/protocol";
import { begin, closed, moved, record, redone, undone } from "../src/page/state/history";
import { readDoc } from "../src/page/state/read";
import { isProject, readProject, writeProject, NO_PROJECT, type Project } from "../src/page/state/project-file";
import { readHistory, writeHistory } from "../src/page/state/undo-memory";
import { isPressed, namesOf } from "../src/page/actions/keys";
import { changed, inWords, rangeOf, rangesOf } from "../src/page/state/touring";
import { boxOf, isStale, meshOf, nearestCorner } from "../src/page/state/surfacing";
import { nearest } from "../src/page/panels/motion/samples";
import { stepped, valueOf, within } from "../src/page/panels/motion/spots";
import { latest } from "../src/page/net/latest";
import { openClient } from "../src/page/net/client";
import { openEngine } from "../src/page/net/engine";
import { differing, inWords as poseInWords, spanned } from "../src/page/lib/pose-words";
import { driven, lastPassed, liesBetween, poseAt, type Driven } from "../src/page/lib/way";
import { moved as shifted } from "../src/page/state/timeline";
import { fileAt, seenAt, snapped } from "../src/page/state/joint-places";
import { placeOf } from "../src/page/shell/warning-place";
import { isDrawn, modelOf } from "../src/viewer/model";
import { swung } from "../src/viewer/motion";
import { contrast, legible, ROLES } from "../src/viewer/palette";
import { sideBySide } from "../src/viewer/names";
import { rotationVector } from "../src/viewer/pose";
import { MOST_WAYPOINTS } from "../src/protocol";
import type { Axis, Entity, GalleryItem, Numbers, PathPlace, Pose, Study, SurfaceAnswer, Vec3 } from "../src/protocol";

const GRID = [-180, -135, -90, -37, 0, 12.5, 90, 179, 180];
const TURNED: Pose = { translation: [1, -2, 3.5], quaternion: [0.5, 0.5, -0.5, 0.5], coordinates: [0.25] };
const plane = (id: string, points: string, colour: number): Entity => ({
  id,
  kind: "plane",
  points: [...points.replaceAll("*", "")],
  label: points.replaceAll("*", ""),
  starred: points,
  colour,
});

for (const kind of ANGLES) {
  test(`angles and turns, ${kind}: there and back, gimbal lock too`, () => {
    for (const a of GRID) for (const b of GRID) for (const c of GRID) {
      const turn = fromAngles(kind, [a, b, c]);
      assert.ok(sameTurn(turn, fromAngles(kind, toAngles(kind, turn))), `${kind} ${a} ${b} ${c}`);
    }
  });
}

test("the way between two poses begins and ends at them, and turns steadily", () => {
  assert.ok(samePose(between(HOME, TURNED, 1), TURNED));
  const half = between({ ...HOME, coordinates: [0] }, TURNED, 0.5);
  assert.deepEqual(half.translation, [0.5, -1, 1.75]);
  const [whole, part] = [TURNED, half].map(({ quaternion }) => Math.hypot(...rotationVector(quaternion))) as [number, number];
  assert.ok(Math.abs(part - whole / 2) < 1e-9);
});

const DOCS: Record<string, Doc> = {
  nothing: EMPTY,
  class: { ...EMPTY, source: { kind: "class", id: "3-3.3" }, panel: "guided", stage: "planes" },
  "file, pose, bench": {
    ...EMPTY,
    source: { kind: "file", name: "ü.yaml", text: "legs: ab\n".repeat(200) },
    pose: TURNED,
    panel: "bench",
    threshold: "20 mm",
    commands: ["plane a b c"],
    bench: "let p = a ∨ b",
    tour: { start: TURNED, to: "z=1", over: [{ name: "x", low: -1, high: 2 }, { name: "roll", low: 0, high: 30 }], nodes: 41, measure: "isotropy", box: [-1, 0, 1].map((low, i) => ({ name: "xyz".charAt(i), low, high: 2 })) as Tour["box"], fineness: 13 },
    sketch: { title: "t", points: { a: [0, 0, 1], b: [0, 0, 2] }, base: ["a"], platform: ["b"], legs: [["a", "b"]] },
    making: "limbs",
    limbs: "title: T\nlimbs: []\n",
  },
  "a way": { ...EMPTY, source: { kind: "class", id: "3-3.3" }, pose: TURNED, way: [HOME, TURNED, { ...HOME, translation: [1, 2, 3] }] },
  "a way that was driven": { ...EMPTY, source: { kind: "class", id: "3-3.3" }, pose: TURNED, driven: [HOME, TURNED] },
};
for (const [name, doc] of Object.entries(DOCS)) {
  test(`a link restores the document: ${name}`, async () => {
    for (const link of [(await linkOf(doc)).fragment, plainFragment(doc)]) {
      assert.match(link, /^(#[sz]=[\w-]+)?$/);
      if (link) assert.deepEqual(await readFragment(link), doc);
    }
  });
}

test("a link that would be too long with the way leaves it out, and says so; so does one of a broken way", async () => {
  const noise = Array.from({ length: 72_000 }, (_, i) => Math.sin(i * i).toString(36).slice(-1)).join("");
  const doc: Doc = { ...EMPTY, bench: noise, way: Array.from({ length: MOST_WAYPOINTS }, (_, i) => ({ ...HOME, translation: [Math.sin(i), Math.cos(i), Math.tan(i)] })) };
  const { fragment, short } = await linkOf(doc);
  assert.ok(short && fragment.length <= LONGEST_LINK);
  assert.deepEqual(await readFragment(fragment), { ...doc, way: [] });
  assert.equal((await linkOf({ ...doc, bench: "" })).short, false);
  assert.deepEqual(readDoc({ way: [HOME, { translation: [0, 0], quaternion: [1, 0, 0, 0] }] }).way, []);
  assert.deepEqual(readDoc({ way: Array.from({ length: MOST_WAYPOINTS + 1 }, () => HOME) }).way, []);
});

const HOSTILE = ["", "#s=", "#s=!!", "#z=AAAA", "#x=e30", `#s=${btoa("[]")}`, `#s=${btoa("null")}`, `#z=${btoa("{}")}`];
test("a link that is no link, or a broken one, opens nothing", async () => {
  for (const link of HOSTILE) {
    const doc = await readFragment(link);
    assert.ok(doc === null || JSON.stringify(doc) === JSON.stringify(EMPTY), link);
  }
  assert.deepEqual(await readFragment(""), EMPTY);
  assert.equal(await readFragment("#s=!!"), null);
});

test("what a link says is checked field by field", () => {
  const doc = readDoc({ source: { kind: "class", id: 3 }, pose: { translation: [1], quaternion: [] }, panel: "x", bench: {} });
  assert.deepEqual(doc, EMPTY);
  assert.deepEqual(readDoc({ pose: { translation: [0, 0, 0], quaternion: [2, 0, 0, 0] } }).pose, HOME);
  assert.equal(readDoc({ panel: "guided" }).panel, "start");
  const numbers = { "1/3": 1 / 3, "-2/4": -0.5, "1,5": 1.5, "−2": -2, "1e-3": 0.001, "0x10": null, "1/0": null, "1 000": null, "12.5 in": null, "": null };
  for (const [typed, meant] of Object.entries(numbers)) assert.equal(readNumber(typed), meant, typed);
  const wrong = [7, { over: [{ name: "x", low: 0, high: 1 }] }, { nodes: 1e9, to: 3, start: "home" }, { fineness: 10, box: [{ name: "x", low: 0, high: 1 }] }, { over: [{ name: "x", low: "0" }, 1] }];
  for (const tour of wrong) assert.deepEqual(readDoc({ tour }).tour, TOUR);
});

const at = (x: number): Partial<Doc> => ({ pose: { ...HOME, translation: [x, 0, 0] } });
test("a drag is undone as one step, navigation is none", () => {
  let history = begin(EMPTY);
  for (const x of [1, 2, 3]) history = record(history, at(x), "x");
  history = record(closed(history), at(4), "x");
  history = moved(history, { stage: "planes" });
  const places = [undone(history), undone(undone(history))].map(({ present }) => present.pose.translation[0]);
  assert.deepEqual(places, [3, 0]);
  assert.equal(undone(history).present.stage, "planes");
  assert.equal(redone(redone(undone(undone(history)))).present.pose.translation[0], 4);
  assert.equal(record(undone(history), at(9), null).future.length, 0);
});

const TRIANGLE: Record<string, Vec3> = { a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0], d: [0, 0, 1], e: [0.3, 0.2, 1], f: [0, 1, 1.5] };
const SHAPE = { kind: "platform", points: TRIANGLE, base: ["a", "b", "c"], platform: ["d", "e", "f"], size: 1 } as unknown as Study;
test("a joint is under the pointer whatever the platform's turn, and the centroid goes along with it", () => {
  for (const name of ["a", "e"]) {
    const seen: Vec3 = [0.3, -2, 1.7];
    const to = fileAt(SHAPE, {}, TURNED, name, seen);
    const moved = { ...SHAPE, points: { ...TRIANGLE, [name]: to } };
    seenAt(moved, {}, TURNED, name).forEach((c, i) => assert.ok(Math.abs(c - seen[i]!) < 1e-12, `${name} ${c}`));
  }
  assert.deepEqual(fileAt(SHAPE, {}, HOME, "e", [1, 0, 2]).map((c) => Number(c.toFixed(12))), [1, 0, 2]);
  assert.deepEqual(snapped([1.26, 0.333, -7.01], [1, 1 / 3, -7], 0.5), [1.5, 1 / 3, -7]);
});

test("planes and the point in which they meet are drawn where the platform swings to", () => {
  const recipe = {
    lines: [],
    points: [{ label: "M", of: [["join", "a", "b", "d"], ["join", "b", "c", "e"], ["join", "a", "c", "f"], ["join", "b", "a", "d"]], entities: ["p"] }],
    sign: 1 as const,
    size: 1,
    thresholds: { close: 0.01, rounding: 1e-12, digits: 1e-15, near: 0.03, met: 1e-9 },
  };
  const scene = {
    points: TRIANGLE, base: SHAPE.base, platform: SHAPE.platform, legs: [], about: [0, 0, 1] as Vec3, size: 1, unit: "m", recipe,
    entities: [plane("p", "abd", 0)],
    motion: { axis: [0, 1, 0] as Vec3, through: [0, 0, 0] as Vec3, pitch: 0.1, text: "" },
    constructed: [{ kind: "point" as const, label: "M", at: [9, 9, 9] as Vec3, entities: ["p"] }],
  } as unknown as Parameters<typeof modelOf>[0];
  const state = { theme: "light" as const, highlight: null, hidden: new Set<never>(), swing: 0.5, centre: [0, 0, 1] as Vec3 };
  const drawn = modelOf(scene, state);
  const points = swung(scene, scene.motion!, 0.5);
  const there = modelOf({ ...scene, points, motion: null, constructed: drawn.marks.map(({ at }) => ({ kind: "point", label: "M", at, entities: ["p"] })) }, { ...state, swing: null });
  const planesOf = ({ faces }: typeof drawn) => faces.filter(({ entity }) => entity === "p").map(({ corners }) => corners);
  assert.deepEqual(planesOf(drawn), planesOf(there));
  assert.notDeepEqual(planesOf(drawn), planesOf(modelOf(scene, { ...state, swing: null })));
  assert.deepEqual(drawn.marks.map(({ label }) => label), ["M"]);
  assert.ok(Math.hypot(...drawn.marks[0]!.at) < 5, "it is worked out anew");
});

test("a warning gives way to what it would cover, and stays as long as it covers nothing", () => {
  const at = (y: number): [number, number, number, number] => [100, y - 10, 120, y + 10];
  assert.equal(placeOf("top", 300, 26, 500, 400, []), "top");
  assert.equal(placeOf("top", 300, 26, 500, 400, [at(200)]), "top");
  assert.equal(placeOf("top", 300, 26, 500, 400, [at(20)]), "bottom");
  assert.equal(placeOf("bottom", 300, 26, 500, 400, [at(200)]), "bottom");
  assert.equal(placeOf("bottom", 450, 26, 500, 400, [at(20), at(385)]), "below");
  assert.equal(placeOf("below", 450, 26, 500, 400, [at(200)]), "top");
});

test("latest wins: one request under way, then the newest", async () => {
  const [sent, seen]: [number[], number[]] = [[], []];
  let free = (): void => undefined;
  const ask = latest(
    (n: number) => (sent.push(n), new Promise<number>((resolve) => (free = () => resolve(n)))),
    (n) => seen.push(n),
    () => assert.fail(),
  );
  [1, 2, 3].forEach(ask);
  free();
  await new Promise((resolve) => setTimeout(resolve));
  free();
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual([sent, seen], [[1, 3], [1, 3]]);
});

test("a bracket lights up where all of its points are, a point everywhere", () => {
  assert.deepEqual(litPoints(["a", "b", "c", "d"], bracketTarget(["d", "c"])), ["d", "c"]);
  assert.deepEqual(litPoints(["a", "b", "c", "e"], bracketTarget(["d", "c"])), []);
  assert.deepEqual(litPoints(["a", "b"], pointTarget("b")), ["b"]);
  assert.deepEqual(litPoints(["a"], null), []);
});

test("each entity colours one bracket of a monomial", () => {
  const brackets = ["abce", "abdf", "cdef"].map((points) => ({ points: [...points], tex: "" }));
  const tint = tintOf({ sign: 1, coefficient: "", brackets }, [plane("1", "abc", 0), plane("2", "b*df", 1), plane("3", "abd", 2)]);
  assert.deepEqual(tint.map((map) => [...map.keys()].join("")), ["abc", "bdf", ""]);
});

test("names of entities and sources are found in sentences, not in words", () => {
  const words = wordsOf("The planes abc and b*df meet; cabal. [White1991]", [plane("1", "abc", 0), plane("2", "b*df", 1)]);
  assert.deepEqual(words.filter((w) => w.entity).map((w) => w.text), ["abc", "b*df"]);
  assert.deepEqual(words.filter((w) => w.source).map((w) => w.text), ["White1991"]);
  assert.equal(wordsOf("a sentence", []).length, 1);
});

test("formulas are split into operator, bracket and parentheses of others", () => {
  assert.deepEqual(splitOperator("{}\\wedge aef"), ["{}\\wedge{}", "aef", ""]);
  assert.deepEqual(splitOperator("{}\\wedge Ef)"), ["{}\\wedge{}", "Ef", ")"]);
  assert.deepEqual(splitOperator("-(AB"), ["{}-{}(", "AB", ""]);
  assert.deepEqual(splitOperator("(a \\vee b)"), ["", "(a \\vee b)", ""]);
  assert.deepEqual(splitBrackets("2[abcd][efgh]", 2), { before: "2", brackets: ["[abcd]", "[efgh]"] });
  assert.equal(splitBrackets("[\\![ab,\\, cd]\\!]", 2), null);
});

test("thresholds are angles or lengths; the gauge is logarithmic", () => {
  assert.ok(Math.abs(degreesOf(Math.sin((7 * Math.PI) / 180)) - 7) < 1e-12);
  assert.deepEqual([0, 1e-4, 1e-2, 1, 3].map((s) => Math.round(along(s) * 100)), [0, 0, 50, 100, 100]);
});

test("numbers are read as people type them", () => {
  assert.deepEqual(["1.5", "−2", " 1e-3 ", "1,5", "", "x", "1/0"].map(readNumber), [1.5, -2, 0.001, 1.5, null, null, null]);
  assert.deepEqual([0, 12.5, -408.32, 1 / 3].map((n) => fitting(n, 0)), ["0", "12.5", "−408.32", "0.33"]);
  assert.deepEqual([1, 0.1, 0.001, 5].map(digitsOf), [0, 1, 3, 0]);
});

const zero: Vec3 = [0, 0, 0];
test("an entity is said to be drawn only where it has a shape", () => {
  const scene = { points: { A: zero, B: [1, 0, 0] as Vec3 }, directions: { u: [1, 0, 0] as Vec3, v: [0, 1, 0] as Vec3, w: [0, 0, 1] as Vec3 } };
  const drawn = (kind: string, ...points: string[]) => isDrawn(scene, { kind, points } as Entity);
  assert.ok(drawn("plane", "u", "v", "A") && drawn("line", "u", "v") && drawn("line", "A", "u") && drawn("tetrahedron", "u", "v", "w", "A"));
  assert.ok(!drawn("plane", "u", "v", "w"), "the plane at infinity");
  assert.ok(!drawn("plane", "A", "B", "i"), "an unknown point");
});

test("the gallery finds cards by every word, and shows those first that a newcomer knows", () => {
  const item = (id: string, group: string, more: Partial<GalleryItem> = {}): GalleryItem => ({
    ...{ id, title: id, detail: "", group, statement: "four planes", words: "Schönflies", familiar: null, svg: "" },
    source: { kind: "class", id },
    ...more,
  });
  const classes = [item("6-3", "c"), item("3-3", "c", { familiar: 1 }), item("6-6", "a")];
  const gallery = { classes, robots: [item("delta", "3", { familiar: 0 }), item("3-RP*S", "3")], examples: [] };
  const titles = (query: string) => chosen(gallery, "all", query).map(({ title, items }) => `${title}:${items.map(({ id }) => id)}`);
  assert.deepEqual(titles(""), ["Well known:delta,3-3", "3:3-RP*S", "c:6-3", "a:6-6"]);
  assert.deepEqual(titles("Planes 6-3"), ["c:6-3"]);
  assert.deepEqual(titles("3rps"), ["3:3-RP*S"]);
  assert.deepEqual(titles("schonflies 66"), ["a:6-6"]);
  assert.deepEqual(titles("nothing"), []);
  const named = [item("old", "x", { familiar: 0, words: "six legs hexapod" }), item("new", "y", { words: "hexapod" }), item("hexapod", "z")];
  const ranked = (query: string) => chosen({ ...gallery, examples: named }, "examples", query).map(({ title }) => title);
  assert.deepEqual(ranked("hexapod"), ["z", "y", "x"]);
  const robots = [item("h4", "4 freedoms", { words: "pick 4-dof" }), item("4-legs", "3 freedoms", { words: "3-dof" })];
  const freedoms = (query: string) => chosen({ ...gallery, robots }, "robots", query).map(({ title }) => title);
  for (const four of ["4 dof", "4-DoF", "4dof", "four freedoms", "4 degrees of freedom", "pick four DOFs"]) assert.deepEqual(freedoms(four), ["4 freedoms"], four);
  assert.deepEqual(freedoms("dof"), ["4 freedoms", "3 freedoms"]);
});

test("poses compare by value", () => {
  assert.ok(samePose(HOME, { translation: zero, quaternion: [1, 0, 0, 0] }));
  assert.ok(!samePose(HOME, { ...HOME, coordinates: [0] }));
});

const axis = (name: string, unit = ""): Axis => ({ name, unit, low: -0.69267, high: 0.69267, step: 0.001 });
const study = { ranges: [axis("z"), axis("roll", "deg"), axis("q1")] } as Study;
const range = (name: string, low = 0): Range => ({ name, low, high: 1 });

test("a map begins with the first coordinates, and keeps those that were chosen", () => {
  const first = rangesOf(study, TOUR);
  assert.deepEqual(first, [{ name: "z", low: -0.69, high: 0.69 }, { name: "roll", low: -0.69, high: 0.69 }]);
  assert.deepEqual(rangesOf(study, { ...TOUR, over: [range("q1"), range("z")] }), [range("q1"), range("z")]);
  assert.deepEqual(rangesOf(study, { ...TOUR, over: [range("gone"), range("z")] }), first);
  assert.equal(rangesOf({ ranges: [] as Axis[] } as Study, TOUR), null);
});

test("the two coordinates of a map are never the same one", () => {
  assert.deepEqual(changed([range("z"), range("roll")], 0, range("q1", 0.5)), [range("q1", 0.5), range("roll")]);
  assert.deepEqual(changed([range("z"), range("roll")], 0, range("roll", 0.5)), [range("roll"), range("z")]);
  assert.deepEqual(changed([range("z"), range("roll")], 1, range("z", 0.5)), [range("roll"), range("z")]);
  assert.deepEqual(changed([range("z"), range("roll")], 1, range("roll", 0.5)), [range("z"), range("roll", 0.5)]);
});

test("ranges are written as the command takes them", () => {
  assert.equal(inWords(range("x", -1.5), "mm", 25), "x -1.5:1:25");
  assert.equal(inWords(rangeOf(axis("roll", "deg")), "deg", 11), "roll -0.69:0.69:11 deg");
});

test("places of a map: nodes, cells and values, at the edges too", () => {
  const margin = [[1, 2, 3], [4, 5, 6], [7, 8, null]];
  assert.deepEqual(stepped([0.5, 0.5], [1, 0], margin), [1, 0.5]);
  assert.deepEqual(stepped([1, 0], [1, 0], margin), [1, 0]);
  assert.deepEqual(stepped([0, 0.4], [0, -1], margin), [0, 0]);
  assert.deepEqual([0, 0.49, 0.51, 1].map((part) => within(part, 2)), [0, 0, 1, 1]);
  const { low, high } = axis("z");
  assert.deepEqual([0, 0.5, 1].map((part) => valueOf(axis("z"), part)), [low, 0, high]);
});

test("the sample of a path that is nearest to a parameter", () => {
  const samples = [0, 0.4, 0.42, 1].map((parameter) => ({ parameter, margin: 0, pose: null }));
  assert.deepEqual([-1, 0.1, 0.409, 0.415, 0.6, 5].map((p) => nearest(samples, p)), [0, 0, 1, 2, 2, 3]);
});

test("home is home with the robot's actuators or without", () => {
  assert.ok(isHome(HOME) && isHome({ ...HOME, coordinates: [0, 0] }));
  assert.ok(!isHome(TURNED) && !isHome({ ...HOME, coordinates: [0, 0.1] }));
  assert.deepEqual(atHome(TURNED), { ...HOME, coordinates: [0] });
});

const SCALES = { length: 100, coordinates: [] };
const goneTo = (way: readonly Pose[]): Driven => way.reduce((so, one) => driven(so, one, SCALES, 5), { stops: [], passed: [] } as Driven);
const pose = (x: number, y = 0, turn = 0): Pose => ({ translation: [x, y, 0], quaternion: [Math.cos(turn / 2), 0, 0, Math.sin(turn / 2)] });

test("a straight way has two stops, a corner and a way back one more each", () => {
  const straight = Array.from({ length: 50 }, (_, i) => between(pose(0), pose(80, 40, 2), i / 49));
  assert.deepEqual(goneTo(straight).stops, [straight[0], straight[49]]);
  assert.equal(goneTo([pose(0), pose(50), pose(100), pose(100, 50), pose(100, 99)]).stops.length, 3);
  assert.deepEqual(goneTo([pose(0), pose(50), pose(100), pose(40), pose(10)]).stops, [pose(0), pose(100), pose(10)]);
  assert.equal(goneTo([pose(0), pose(0), pose(0)]).stops.length, 1);
  const round = Array.from({ length: 40 }, (_, i) => pose(50 * Math.cos(i), 50 * Math.sin(i)));
  assert.equal(goneTo(round).stops.length, 5, "no more than so many");
});

test("no pose that was passed is farther from the way than a hand is steady", () => {
  const bend = Array.from({ length: 200 }, (_, i) => pose(i, (i * i) / 4000));
  const { stops } = driven({ stops: [], passed: [] }, bend[0]!, SCALES, 50);
  const way = bend.reduce((so, one) => driven(so, one, SCALES, 50), { stops, passed: [] } as Driven).stops;
  assert.ok(way.length > 3 && way.length < 20, String(way.length));
  assert.ok(bend.every((one) => way.slice(1).some((to, i) => liesBetween(way[i]!, to, one, SCALES))));
});

test("waypoints change places, and the way is led between its samples", () => {
  assert.deepEqual(shifted(["a", "b", "c", "d"], 0, 2), ["b", "c", "a", "d"]);
  assert.deepEqual(shifted(["a", "b", "c", "d"], 3, 0), ["d", "a", "b", "c"]);
  const sample = (parameter: number, at: Pose | null) => ({ parameter, margin: 1, pose: at });
  const samples = [sample(0, pose(0)), sample(0.5, pose(10)), sample(1, null)];
  assert.deepEqual(poseAt({ samples }, 0.25)?.translation, [5, 0, 0]);
  assert.deepEqual(poseAt({ samples }, 0)?.translation, [0, 0, 0]);
  assert.equal(poseAt({ samples }, 0.75), null);
});

test("what is passed last between two places of a way, forth and back", () => {
  const places = [0.2, 0.5, 0.9].map((parameter) => ({ parameter }) as PathPlace);
  const last = (from: number, to: number) => lastPassed(places, from, to)?.parameter ?? null;
  assert.deepEqual([last(0, 1), last(1, 0), last(0, 0.6), last(0.6, 0)], [0.9, 0.2, 0.5, 0.2]);
  assert.deepEqual([last(0.3, 0.4), last(0.4, 0.3), last(0.3, 0.5)], [null, null, 0.5]);
});

test("words in the colours of entities can be read, and keep a colour that can be", () => {
  for (const [role, colours] of Object.entries(ROLES).filter(([role]) => role.startsWith("entity"))) {
    for (const [i, theme] of (["light", "dark"] as const).entries()) {
      const own = colours[i]!;
      const found = legible(own, theme);
      assert.ok(contrast(found, ROLES.paper[i]!) >= 4.5, role);
      if (contrast(own, ROLES.paper[i]!) >= 4.5) assert.equal(found.toLowerCase(), own.toLowerCase());
    }
  }
});

test("long names are found in sentences, and stand apart", () => {
  assert.equal(sideBySide(["A1", "b*", "c'"]), "A1b*c'");
  const points = ["base_left", "base_right", "top"];
  const entity: Entity = { id: "e0", kind: "plane", points, label: "base_left base_right top", starred: "base_left* base_right top", colour: 0 };
  const words = wordsOf("the planes base_left base_right top and x meet", [entity]);
  assert.deepEqual(words.map(({ entity }) => entity?.id), [undefined, "e0", undefined]);
});

const LEGS: Doc = { ...EMPTY, source: { kind: "legs", legs: "ab af cb cd ed ef" }, pose: TURNED, panel: "manual", commands: ["plane abf"] };
const PROJECT: Project = {
  title: "Two robots",
  note: "compare",
  robots: [{ name: "Octahedral", note: "", state: LEGS, way: [HOME, TURNED], poses: [{ name: "near", pose: TURNED }] }],
};

test("a project comes back from its file as it was", () => {
  const text = writeProject(PROJECT);
  assert.ok(isProject(text));
  assert.deepEqual(readProject(text, "a.json"), { project: PROJECT });
  assert.deepEqual(readProject(writeProject(NO_PROJECT), "a.json"), { project: NO_PROJECT });
});

test("a project with a fault is not half read, and the fault has a place", () => {
  const whole = JSON.parse(writeProject(PROJECT));
  const broken = (change: (x: typeof whole) => void): string => {
    const copy = structuredClone(whole);
    change(copy);
    const found = readProject(JSON.stringify(copy), "a.json");
    assert.ok("fault" in found);
    return found.fault.message;
  };
  assert.equal(broken((x) => (x.format = 2)), "a.json: its format is 2, and this studio reads 1");
  assert.equal(broken((x) => delete x.format), "a.json: it does not give the number of its format");
  assert.equal(broken((x) => (x.colour = 1)), 'a.json: the file has "colour", which is not known');
  assert.equal(broken((x) => (x.robots[0].state.source.kind = "robo")), "a.json: robots[1].state.source is not understood");
  assert.equal(broken((x) => (x.robots[0].way[1].translation = [0, 1])), "a.json: robots[1].way[2].translation is not understood");
  assert.equal(broken((x) => (x.robots[0].state.commands = [1])), "a.json: robots[1].state.commands is not understood");
  assert.equal(broken((x) => (x.robots[0].poses[0].name = 1)), "a.json: robots[1].poses[1].name is not text");
  assert.equal(broken((x) => (x.robots = {})), "a.json: robots is not a list");
  assert.equal(broken((x) => delete x.robots[0].state.source), "a.json: robots[1].state names no robot");
  const found = readProject("{", "a.json");
  assert.ok("fault" in found && found.fault.message.startsWith("a.json: it is not JSON"));
  assert.ok(!isProject("robot: 3"));
});

test("undo and redo come back after a reload, of the same document only", () => {
  const other = { ...LEGS, bench: "ab" };
  let history = record(record(begin(EMPTY), LEGS, null), other, null);
  history = undone(history);
  const text = writeHistory(history);
  const found = readHistory(text, LEGS);
  assert.deepEqual(found.past, [EMPTY]);
  assert.deepEqual(found.future, [other]);
  assert.deepEqual(redone(found).present, other);
  assert.deepEqual(readHistory(text, other).past, []);
  assert.deepEqual(readHistory("{", LEGS).past, []);
  const long = writeHistory({ ...history, past: Array.from({ length: 500 }, () => LEGS) });
  assert.equal(readHistory(long, LEGS).past.length, 60);
});

test("keys are pressed as the table writes them", () => {
  const press = (key: string, held: Partial<Record<"ctrlKey" | "metaKey" | "shiftKey" | "altKey", boolean>> = {}) =>
    ({ key, ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...held });
  assert.ok(isPressed("Mod z", press("z", { ctrlKey: true })) && isPressed("Mod z", press("z", { metaKey: true })));
  assert.ok(!isPressed("Mod z", press("Z", { ctrlKey: true, shiftKey: true })));
  assert.ok(isPressed("Mod Shift z", press("Z", { ctrlKey: true, shiftKey: true })));
  assert.ok(isPressed("?", press("?", { shiftKey: true })) && isPressed("?", press("?")));
  assert.ok(!isPressed("f", press("f", { ctrlKey: true })) && !isPressed("f", press("f", { altKey: true })));
  assert.deepEqual(namesOf("Mod Shift z").slice(1), ["Shift", "Z"]);
});

const SURFACE: SurfaceAnswer = {
  vertices: [0, 0, 1, 0, 0, -4, 2, 0, 0],
  faces: [0, 1, 2],
  reached: [false, true, true],
  nodes: [7, 7, 7],
  free: 200,
  cells: 216,
  guarantee: "",
  resolution: "",
  facts: [],
  held: { yaw: Math.PI / 6 },
};

test("a surface lies around the platform's centre, its nearest corner is one within the limits", () => {
  assert.deepEqual(meshOf(SURFACE, [1, 2, 3], false).vertices, [1, 2, 4, 1, 2, -1, 3, 2, 3]);
  assert.deepEqual(nearestCorner(SURFACE, [0, 0, 0]), [2, 0, 0]);
  assert.deepEqual(nearestCorner({ ...SURFACE, reached: [false, false, false] }, [0, 0, 0]), [0, 0, 1]);
  assert.equal(nearestCorner({ ...SURFACE, vertices: [], reached: [] }, [0, 0, 0]), null);
});

test("a surface holds for one turn, and for the other freedoms of a robot", () => {
  const over: [string, string, string] = ["x -1:1:7", "y -1:1:7", "z -1:1:7"];
  const shown = { asked: { source: { kind: "example", name: "octahedral" } as const, over, pose: HOME }, result: SURFACE };
  const platform = { kind: "platform", freedoms: [] } as unknown as Study;
  assert.ok(!isStale(shown, { ...HOME, translation: [1, 2, 3], quaternion: [-1, 0, 0, 0] }, null, platform));
  assert.ok(isStale(shown, { ...HOME, quaternion: [0.999, 0.0447, 0, 0] }, null, platform));
  const robot = { kind: "robot", freedoms: [{ name: "x", unit: "" }, { name: "yaw", unit: "deg" }] } as unknown as Study;
  const at = (...freedoms: number[]) => ({ freedoms }) as unknown as Numbers;
  assert.ok(!isStale(shown, HOME, at(5, 30), robot));
  assert.ok(isStale(shown, HOME, at(5, 31), robot));
  assert.equal(boxOf({ ranges: [{ name: "x" }, { name: "yaw" }] } as unknown as Study), null);
});

// --- without a server ----------------------------------------------------------------------------------------------

class Worker {
  static all: Worker[] = [];
  asked: { id: number; kind: string; text: string }[] = [];
  ended = false;
  onmessage: (event: { data: unknown }) => void = () => undefined;
  onerror: () => void = () => undefined;

  constructor() {
    Worker.all.push(this);
  }

  postMessage(asked: { id: number; kind: string; text: string }): void {
    this.asked.push(asked);
  }

  terminate(): void {
    this.ended = true;
  }

  says(data: unknown): void {
    this.onmessage({ data });
  }

  answers(id: number, result: unknown): void {
    this.says({ kind: "answer", id, reply: JSON.stringify({ id, ok: true, result, ms: 1 }) });
  }
}

function engineClient() {
  Object.assign(globalThis, { Worker, window: globalThis });
  Worker.all = [];
  const client = openClient((on) => openEngine(new URL("http://localhost/worker.mjs"), on), true);
  const now = (): Worker => Worker.all.at(-1) as Worker;
  return { client, now };
}

test("the engine is asked one request after the other, once it is there", async () => {
  const { client, now } = engineClient();
  const words: string[] = [];
  const first = client.ask("gallery", {}, { progress: (text) => words.push(text) });
  const second = client.ask("hello", {});
  assert.deepEqual(now().asked, []);
  now().says({ kind: "ready" });
  assert.deepEqual(now().asked.map(({ id, kind }) => [id, kind]), [[1, "request"]]);
  now().says({ kind: "piece", id: 1, piece: JSON.stringify({ id: 1, progress: "analysing" }) });
  now().answers(1, "one");
  now().answers(2, "two");
  assert.deepEqual([await first, await second, words], ["one", "two", ["analysing"]]);
});

test("of a channel only the latest request is computed", async () => {
  const { client, now } = engineClient();
  now().says({ kind: "ready" });
  const asks = ["a", "b", "c"].map((legs) => client.ask("open", { source: { kind: "legs", legs } }, { channel: "preview" }));
  now().answers(1, "first");
  now().answers(3, "last");
  assert.equal(await asks[0], "first");
  await assert.rejects(asks[1] as Promise<unknown>, /later request/);
  assert.equal(await asks[2], "last");
});

test("what nobody waits for ends the engine; what waits is asked of the next one", async () => {
  const { client, now } = engineClient();
  now().says({ kind: "ready" });
  const stop = new AbortController();
  const long = client.ask("gallery", {}, { signal: stop.signal });
  const other = client.ask("hello", {});
  stop.abort();
  await assert.rejects(long, /Cancelled/);
  const before = now();
  await new Promise((done) => {
    const stopWatching = client.line.subscribe((line) => line === "connecting" && done(null));
    void stopWatching;
  });
  assert.ok(before.ended && now() !== before);
  now().says({ kind: "ready" });
  now().answers(2, "there");
  assert.equal(await other, "there");
});

test("an engine that cannot be loaded is said to be lost, and tried again when that is wished", () => {
  const { client, now } = engineClient();
  now().says({ kind: "fault", text: "gcrules.zip: 404" });
  assert.equal(client.line.value, "lost");
  client.retry();
  assert.equal(client.line.value, "connecting");
  assert.equal(Worker.all.length, 2);
});

test("a fault of the engine is told, and another one begins", async () => {
  const { client, now } = engineClient();
  now().says({ kind: "ready" });
  const asked = client.ask("gallery", {});
  now().says({ kind: "fault", id: 1, text: "memory access out of bounds" });
  await assert.rejects(asked, /out of bounds/);
  assert.equal(Worker.all.length, 2);
});

test("a link whose robot cannot be told is not opened as another one", async () => {
  assert.equal(await readFragment(`#s=${btoa('{"source":3}').replace(/=+$/, "")}`), null);
  assert.deepEqual((await readFragment(`#s=${btoa('{"panel":"bench"}').replace(/=+$/, "")}`))?.source, null);
});

test("poses of a way are named by the coordinates in which they differ", () => {
  const at = (z: number, turn = 0): Pose => ({ translation: [1, 2, z], quaternion: [Math.cos(turn), 0, 0, Math.sin(turn)] });
  const platform = { kind: "platform", axes: [], unit: "mm", size: 100 } as const;
  assert.equal(differing(at(-350), [at(0), at(-400)], platform), "z = −350 mm");
  assert.equal(differing(at(-350, Math.PI / 12), [at(0), at(-400, Math.PI / 6)], platform), "z = −350 mm, turned by 30°");
  assert.equal(differing(at(3), [at(3), at(3)], platform), "");
  assert.equal(spanned(at(-340), at(-352), platform), "z = −340 and −352 mm");
  assert.equal(spanned(at(0), at(0, 1), platform), "");
  assert.equal(poseInWords(at(3, Math.PI / 12), platform), "1, 2, 3 mm; turned by 30°");
  const axis = (name: string): Axis => ({ name, unit: "deg", low: -90, high: 90, step: 1 });
  const robot = { kind: "robot", axes: [axis("q1, arm 1"), axis("q2, arm 2")], unit: "mm", size: 100 } as const;
  const driven = (a: number, b: number): Pose => ({ ...at(0), coordinates: [a, b] });
  assert.equal(differing(driven(5, 2.5), [driven(5, 0), driven(5, 10)], robot), "q2 = 2.5°");
  assert.equal(poseInWords(driven(5, 2.5), robot), "q1 5, q2 2.5");
});

test("broken lines of answers go on below their words", () => {
  assert.equal(hangOf("a sentence of words"), 2);
  assert.equal(hangOf("   indented"), 5);
  assert.equal(hangOf("  certificate  normal-form: both sides"), 15);
  assert.equal(hangOf("  a name that is much too long for this  value"), 4);
});
