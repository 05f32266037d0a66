// The viewer with what is needed to move the platform where there is no page around it: in the HTML report and in
// notebooks. Six sliders, standard views, and the numbers of the pose, computed here.
import { colourOf, entityRole } from "./palette";
import { eulerAngles, fromEuler, IDENTITY } from "./pose";
import { button, figure, make, named } from "./elements";
import { drivesOf, type Driven, type Drives } from "./drives";
import { numbersAt, type PoseNumbers } from "./numbers";
import { STYLE } from "./style";
import type { LimbNumbers } from "./limb-margin";
import type { Mode, Pose, Scene, Theme, Vec3, Verdict, View, Viewer } from "./types";
import { createViewer } from "./viewer";

export interface Explorer {
  readonly viewer: Viewer;
  /** Those of the platform's pose; null for a robot that is not moved here. */
  readonly numbers: PoseNumbers | null;
  setPose(pose: Pose): void;
  /** The actuators of a robot of joints to these amounts from home, in radians and lengths; null for other robots. */
  drive(amounts: number[]): Driven | null;
  setScene(scene: Scene): void;
  dispose(): void;
}

export interface ExplorerOptions {
  onPose?(pose: Pose, done: boolean): void;
  renderer?: "auto" | "svg";
}

const VERDICTS = {
  regular: "Regular: the six legs control the platform here.",
  close: "Warning: close to singular.",
  singular: "Warning: singular within rounding: the legs do not control the platform here.",
};
const LIMB_VERDICTS = {
  regular: "Regular: the limbs control the platform here.",
  close: "Warning: close to singular.",
  singular: "Warning: singular within rounding: the limbs do not control the platform here.",
};
const SUPERBRACKET = "The superbracket is the determinant of the six lines, 0 at a singular pose.";
const MARGIN = "The margin is 0 at a singular pose and at most 1; it is the same in every frame and unit.";
type Row = [string, HTMLElement | string];
/** Where the margin of six legs is 0 within rounding, so is their superbracket. */
const shown = (value: number, verdict: Verdict, unit = ""): Row[1] =>
  verdict === "singular" ? "0, within rounding" : figure(value, unit);
const gain = (motion: PoseNumbers["motion"]): Row[] => (motion ? [["Gained motion", motion.text]] : []);
const MODES: [Mode, string, string][] = [
  ["orbit", "View", "Drag turns the view"],
  ["translate", "Shift", "Handles that shift the platform"],
  ["rotate", "Turn", "Handles that turn the platform"],
];
const VIEWS: [View, string][] = [
  ["iso", "3D"],
  ["front", "Front"],
  ["side", "Side"],
  ["top", "Top"],
  ["fit", "Fit"],
];
const AXES = ["x", "y", "z", "about z", "about y", "about x"];

export function explore(host: HTMLElement, first: Scene, options: ExplorerOptions = {}): Explorer {
  let scene = first;
  let pose = first.pose ?? IDENTITY;
  let numbers: PoseNumbers | null = null;
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const theme = (): Theme => (dark.matches ? "dark" : "light");

  const root = make("div", { class: "gcx" });
  const canvas = make("div", { class: "gcx-view" });
  const side = make("div", { class: "gcx-side" });
  const verdict = make("p", { class: "gcx-verdict", role: "status" });
  const table = make("dl", { class: "gcx-numbers" });
  const meaning = make("p", { class: "gcx-meaning" });
  const legend = make("ul", { class: "gcx-legend" });
  const sliders = AXES.map((name, i) => slider(name, i));
  const swing = make("input", { type: "checkbox" });
  const gained = make("label", { class: "gcx-motion" }, swing, " show the motion that the platform gains");
  const home = button("Home", "The pose of the file", () => move(IDENTITY, true));
  side.append(verdict, table, meaning, gained, make("div", { class: "gcx-sliders" }, ...sliders.map((s) => s.row)), home, legend);
  let drives: Drives | null = null;
  const bar = make("div", { class: "gcx-bar" });
  root.append(bar, canvas, side);
  if (!document.getElementById("gcx-style")) document.head.append(make("style", { id: "gcx-style" }, STYLE));
  host.replaceChildren(root);

  const viewer = createViewer(canvas, {
    theme: theme(),
    renderer: options.renderer ?? "auto",
    gizmo: Boolean(first.recipe),
    wheel: "focused",
    onPose: (p, done) => move(p, done),
  });
  const modes = MODES.map(([mode, name, words]) => {
    const one = button(name, words, () => chosen(mode));
    one.dataset.mode = mode;
    return one;
  });
  const chosen = (mode: Mode) => {
    viewer.setMode(mode);
    modes.forEach((b) => b.setAttribute("aria-pressed", String(b.dataset.mode === mode)));
  };
  bar.append(
    make("span", { class: "gcx-modes", role: "group", "aria-label": "What dragging does" }, ...modes),
    make("span", { role: "group", "aria-label": "Views" }, ...VIEWS.map(([view, name]) => button(name, `View: ${name}`, () => viewer.setView(view)))),
  );
  swing.addEventListener("change", () => viewer.animateMotion(swing.checked));
  const themed = () => {
    viewer.setTheme(theme());
    showLegend();
  };
  dark.addEventListener("change", themed);
  start(first);
  chosen("orbit");

  function start(next: Scene): void {
    scene = next;
    root.classList.toggle("gcx-still", !next.recipe && !next.linkage);
    meaning.textContent = next.recipe ? `${SUPERBRACKET} ${MARGIN}` : MARGIN;
    root.classList.toggle("gcx-driven", Boolean(next.linkage)); // a robot of joints, moved by its actuators
    drives?.root.remove();
    pose = next.pose ?? IDENTITY;
    viewer.show(next);
    drives = next.linkage ? drivesOf(viewer, { ...next, linkage: next.linkage }, tell) : null;
    if (drives) {
      meaning.after(gained, drives.root);
      drives.start();
    }
    sliders.forEach((s, i) => {
      s.reach(i < 3 ? 1.2 * next.size : 180);
      s.measure(i < 3 ? next.unit : "°");
    });
    showLegend();
    settle();
  }

  /** The platform to a pose, the numbers after it. */
  function move(next: Pose, done: boolean): void {
    pose = next;
    viewer.setPose(next);
    settle();
    options.onPose?.(next, done);
  }

  function settle(): void {
    if (!scene.recipe) return;
    const found = numbersAt({ ...scene, recipe: scene.recipe, points: viewer.points() });
    numbers = found;
    viewer.update({ constructed: found.constructed, motion: found.motion });
    judge(found.verdict, VERDICTS[found.verdict], found.motion);
    const places = [...pose.translation, ...eulerAngles(pose.quaternion)];
    sliders.forEach((s, i) => s.set(places[i]!));
    const value: Row = ["Superbracket", shown(found.superbracket, found.verdict, scene.unit && `${scene.unit}⁹`)];
    tabulate([value, ["Margin", shown(found.margin, found.verdict)], ...gain(found.motion)]);
  }

  /** What a robot of joints is like where its actuators brought it. */
  function tell(found: LimbNumbers): void {
    judge(found.verdict, LIMB_VERDICTS[found.verdict], found.motion);
    tabulate([["Margin σ", figure(found.margin)], ...gain(found.motion)]);
  }

  function judge(word: Verdict, sentence: string, motion: PoseNumbers["motion"]): void {
    root.dataset.verdict = verdict.dataset.verdict = word;
    verdict.textContent = sentence;
    gained.hidden = !motion;
  }

  function tabulate(rows: Row[]): void {
    table.replaceChildren(...rows.flatMap(([key, value]) => [make("dt", {}, key), make("dd", {}, value)]));
  }

  function showLegend(): void {
    legend.replaceChildren(
      ...scene.entities.map((e) => {
        const item = entry(e.colour, e.kind, " ", named(e.label));
        item.tabIndex = 0;
        for (const [name, on] of [["pointerenter", 1], ["focus", 1], ["pointerleave", 0], ["blur", 0]] as const)
          item.addEventListener(name, () => viewer.highlight(on ? { entities: [e.id], points: e.points } : null));
        return item;
      }),
      ...(scene.planes ?? []).flatMap((p) => (p.colour === undefined ? [] : [entry(p.colour, "plane ", named(p.label))])),
      ...(scene.recipe?.lines ?? []).map((line) => entry(line.colour, "line ", named(line.label))),
      ...(scene.limbs ?? []).filter((limb, i, all) => all[i + 1]?.name !== limb.name).map((limb) => entry(limb.colour, `${limb.name}: ${limb.wrenches.join(", ")}`)),
    );
  }

  function entry(colour: number, ...words: (Node | string)[]): HTMLLIElement {
    const item = make("li", {}, ...words);
    item.style.setProperty("--own", colourOf(entityRole(colour), theme()));
    return item;
  }

  function slider(name: string, i: number) {
    const range = make("input", { type: "range", "aria-label": i < 3 ? `shift along ${name}` : `turn ${name}`, step: "any" });
    const box = make("input", { type: "number", "aria-label": i < 3 ? `shift along ${name}` : `turn ${name}, degrees`, step: "any" });
    const read = (value: string, done: boolean) => {
      const number = Number(value);
      if (value === "" || !Number.isFinite(number)) return;
      const places = [...pose.translation, ...eulerAngles(pose.quaternion)];
      places[i] = number;
      const turn = places.slice(3) as Vec3;
      move({ translation: places.slice(0, 3) as Vec3, quaternion: i < 3 ? pose.quaternion : fromEuler(turn) }, done);
    };
    range.addEventListener("input", () => read(range.value, false));
    range.addEventListener("change", () => read(range.value, true));
    box.addEventListener("change", () => read(box.value, true));
    const unit = make("span", { class: "gcx-unit" });
    const row = make("label", { class: "gcx-row" }, make("span", {}, i < 3 ? named(name) : name), range, box, unit);
    return {
      row,
      measure: (word: string) => {
        unit.textContent = word;
        if (i < 3) box.setAttribute("aria-label", [`shift along ${name}`, word].filter(Boolean).join(", "));
      },
      reach: (far: number) => [range.min, range.max] = [String(-far), String(far)],
      set: (value: number) => {
        const shown = Number(value.toPrecision(5));
        if (document.activeElement !== range) range.value = String(value);
        if (document.activeElement !== box) box.value = String(Math.abs(shown) < 1e-9 * scene.size ? 0 : shown);
      },
    };
  }

  return {
    viewer,
    get numbers() {
      return numbers;
    },
    setPose(next) {
      pose = next;
      viewer.setPose(next);
      settle();
    },
    drive: (amounts) => drives?.to(amounts) ?? null,
    setScene: start,
    dispose() {
      dark.removeEventListener("change", themed);
      viewer.dispose();
      root.remove();
    },
  };
}
