// The viewer and the store, each told of the other's changes.
import { computed, effect, untracked } from "@preact/signals";
import type { Numbers } from "../../protocol";
import { createViewer, type Layer, type Viewer } from "../../viewer";
import { inSight } from "../parts/in-sight";
import { entityTarget, pointTarget, type Target } from "../state/lit";
import { samePose } from "../state/doc";
import { foundBy, posedPart, sceneOf, withOverlay } from "../state/scene";
import type { Store } from "../state/store";
import { isStale, meshOf } from "../state/surfacing";
import { IDENTITY } from "../../viewer/pose";
import { ghostNow, gripHandlers, showGrips } from "./grips";
import { createPace } from "./pace";
import { viewMemory } from "./view-memory";

export function connect(element: HTMLElement, store: Store): () => void {
  const { pose$, study, lit, space, taste, moving } = store;
  let held = false;
  const viewer = createViewer(element, {
    theme: taste.theme.peek(),
    onPose(pose, done) {
      moving.stop();
      held = !done;
      // where the hand lets go it has been before: what came since, undo for one, stays
      const robot = study.peek()?.kind === "robot";
      if (done) (robot ? store.leading.done : store.settle)();
      else if (robot) store.leading.to(pose);
      else store.edit({ pose }, "hand");
    },
    covered: () => [coveredBy(".warning.top", element), coveredBy(".warning.bottom", element)],
    onMarks(boxes) {
      if (JSON.stringify(boxes) !== JSON.stringify(space.marks.peek())) space.marks.value = boxes;
    },
    onTurn: (direction) => void (space.from.value = direction),
    ...gripHandlers(store),
    onPick: (name) => void (space.pick(name) || lit.pin(pointTarget(name))),
    onHover: (what) => lit.hover(hovered(store, what)),
  });
  space.viewer.value = viewer;
  const view = viewMemory(viewer, () => store.source$.peek());

  const stops = [
    view.stop,
    effect(() => {
      const shown = study.value;
      if (!shown) return;
      untracked(() => {
        const scene = { ...sceneOf(shown), entities: entitiesNow(store) };
        if (store.resizing.made.peek() === shown) viewer.update({ ...scene, pose: IDENTITY, constructed: [], motion: null }); // the view stays
        else viewer.show(scene);
        viewer.setPose(pose$.peek());
        view.restore();
      });
    }),
    effect(() => viewer.update({ entities: entitiesNow(store), ...extrasNow(store) })),
    followPose(store, viewer),
    showGrips(store, viewer),
    drawSurface(store, viewer),
    keepInSight(store, viewer, element, () => held),
    effect(() => viewer.highlight(highlightOf(lit.current.value))),
    effect(() => viewer.setMode(space.mode.value)),
    effect(() => viewer.setTheme(taste.theme.value)),
    effect(() => Object.entries(space.layers.value).forEach(([layer, on]) => viewer.setVisible(layer as Layer, on))),
    effect(() => viewer.animateMotion(space.playing.value)),
  ];
  return () => {
    stops.forEach((stop) => stop());
    space.viewer.value = null;
    viewer.dispose();
  };
}

const coveredBy = (what: string, element: HTMLElement): number => element.parentElement?.querySelector<HTMLElement>(what)?.offsetHeight ?? 0;

const REST = 500; // milliseconds without a move

/** Fits the view when a move has brought the platform out of sight; a view that the user has chosen so is kept. */
function keepInSight({ pose$, study }: Store, viewer: Viewer, element: HTMLElement, held: () => boolean): () => void {
  let timer = 0;
  let wasSeen = true;
  function rest(): void {
    const seen = inSight(viewer, element, study.peek()?.platform ?? []);
    if (held() || element.matches(":active")) timer = window.setTimeout(rest, REST); // not under a hand
    else if (wasSeen && !seen) viewer.setView("fit");
    else wasSeen = seen;
  }
  const stop = effect(() => {
    void pose$.value;
    window.clearTimeout(timer);
    timer = window.setTimeout(rest, REST);
  });
  return () => {
    window.clearTimeout(timer);
    stop();
  };
}

/** Milliseconds that a picture waits for the numbers of its pose: legs follow the platform without them, limbs do not. */
const PATIENCE = { legs: 40, limbs: 150 };

/** Numbers come faster than pictures are made: of those that come meanwhile only the newest are drawn. */
function followPose(store: Store, viewer: Viewer): () => void {
  const { posing, pose$ } = store;
  let drawn: Numbers | null = null;
  const pace = createPace(() => {
    const pose = pose$.peek();
    const numbers = posing.numbers.peek();
    if (!samePose(pose, viewer.pose)) viewer.setPose(pose);
    if (numbers && numbers !== drawn) {
      const dragged = Object.keys(store.resizing.wanted.peek()).length > 0; // the joints are elsewhere by now
      if (!dragged) viewer.update({ ...posedPart(numbers, samePose(numbers.pose, pose)), constructed: constructedNow(store, numbers) });
      viewer.whole(); // links come with the first numbers
    }
    drawn = numbers;
  });
  const stops = [
    effect(() => {
      if (!samePose(pose$.value, viewer.pose)) pace.ask(store.study.peek()?.kind === "robot" ? PATIENCE.limbs : PATIENCE.legs);
    }),
    effect(() => {
      if (posing.numbers.value) pace.ask(0);
    }),
    pace.stop,
  ];
  return () => stops.forEach((stop) => stop());
}

/** The surface that was asked for, pale once it is that of another orientation. */
function drawSurface({ touring, study, pose$, posing }: Store, viewer: Viewer): () => void {
  const stale = computed(() => {
    const [shown, robot] = [touring.surface.shown.value, study.value];
    return shown !== null && robot !== null && isStale(shown, pose$.value, posing.numbers.value, robot);
  });
  let there = false;
  return effect(() => {
    const [shown, robot] = [touring.surface.shown.value, study.value];
    const surface = shown && robot ? meshOf(shown.result, robot.about, stale.value) : null;
    viewer.update({ surface });
    const drawn = surface !== null && surface.faces.length > 0;
    if (drawn && !there) viewer.setView("fit"); // it is seen whole when it comes, then the user's view is kept
    there = drawn;
  });
}

/** The entities that the guided steps have come to; null for all, as at a singular pose of the way, whose words name them. */
export function foundNow({ study, panel$, stage$, timeline }: Store): string[] | null {
  const shown = study.value;
  return shown && panel$.value === "guided" && timeline.place.value === null ? foundBy(shown.stages, stage$.value) : null;
}

function entitiesNow(store: Store) {
  const shown = store.study.value;
  return shown ? withOverlay(sceneOf(shown), foundNow(store), store.space.overlay.value) : [];
}

/** What panels add. Constructions of the condition belong to the steps from the condition on. */
function extrasNow(store: Store) {
  const extra = store.space.overlay.value;
  const numbers = store.posing.numbers.peek();
  return { planes: extra?.planes ?? [], ghost: extra?.ghost ?? ghostNow(store), constructed: constructedNow(store, numbers) };
}

function constructedNow(store: Store, numbers: Numbers | null) {
  const extra = store.space.overlay.value;
  const own = foundNow(store) === null && !extra?.alone ? (numbers?.constructed ?? []) : [];
  return [...own, ...(extra?.constructed ?? [])];
}

function hovered({ study, space }: Store, what: { point?: string; entity?: string } | null): Target | null {
  if (!what) return null;
  const all = [...(space.overlay.peek()?.entities ?? []), ...(study.peek()?.entities ?? [])];
  const entity = all.find(({ id }) => id === what.entity);
  if (entity) return entityTarget(entity);
  return what.point === undefined ? null : pointTarget(what.point);
}

function highlightOf(target: Target | null) {
  if (!target) return null;
  const { kind, points, entity } = target;
  if (entity !== undefined) return { entities: [entity], points };
  return kind === "leg" ? { legs: [[points[0] ?? "", points[1] ?? ""] as [string, string]] } : { points };
}
