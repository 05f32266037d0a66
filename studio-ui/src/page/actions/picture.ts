// What the picture in 3D offers: what the mouse does, standard views, what is shown.
import type { Layer, Mode, View } from "../../viewer";
import { download } from "../lib/download";
import { viewed } from "../panels/take-away/making";
import type { IconName } from "../parts/icon";
import type { Store } from "../state/store";
import type { Action } from "./table";

export const MODES: readonly (readonly [Mode, string, IconName])[] = [
  ["orbit", "Look around", "orbit"],
  ["translate", "Shift the platform", "translate"],
  ["rotate", "Turn the platform", "rotate"],
];
export const VIEWS: readonly (readonly [View, string])[] = [
  ["iso", "3D"],
  ["front", "Front"],
  ["side", "Side"],
  ["top", "Top"],
  ["fit", "Fit"],
];
export const LAYERS: readonly (readonly [Layer, string])[] = [
  ["entities", "Planes, lines, tetrahedra"],
  ["labels", "Labels"],
  ["legs", "Legs"],
  ["wrenches", "Joints and wrenches"],
  ["grid", "Ground grid"],
  ["motion", "Gained motion"],
  ["surface", "Singular surface"],
  ["way", "The way, with its waypoints"],
];

/** Platforms are moved by the mouse in space: on six legs, and on limbs as far as their freedoms go. */
export function isMovable(store: Store): boolean {
  const study = store.study.value;
  return (study?.kind === "robot" ? study.freedoms : (study?.axes ?? [])).length > 0;
}

export function show(store: Store, layer: Layer, on: boolean): void {
  store.space.layers.value = { ...store.space.layers.peek(), [layer]: on };
}

const isSeen = ({ study, space }: Store): boolean => study.value !== null && space.viewer.value !== null;

export function pictureActions(store: Store): Action[] {
  const { space } = store;
  const fits = () => isSeen(store);
  return [
    {
      id: "large",
      title: "The picture alone",
      group: "Picture",
      keys: ["f"],
      words: "full screen maximise",
      fits,
      act: () => void (space.large.value = !space.large.peek()),
    },
    ...(["png", "svg"] as const).map((kind): Action => ({
      id: `save-${kind}`,
      title: `Save the picture as ${kind.toUpperCase()}`,
      group: "Picture",
      words: "download export screenshot snapshot figure",
      fits,
      act: () => void viewed(store, kind).then(download),
    })),
    ...MODES.map(([mode, title]): Action => ({
      id: `mode-${mode}`,
      title: `Mouse: ${title.toLowerCase()}`,
      group: "Picture",
      fits: () => fits() && (mode === "orbit" || isMovable(store)),
      isOn: () => space.mode.value === mode,
      act: () => void (space.mode.value = mode),
    })),
    ...VIEWS.map(([view, title]): Action => ({
      id: `view-${view}`,
      title: view === "fit" ? "Fit the robot into the picture" : `View: ${title === "3D" ? title : title.toLowerCase()}`,
      group: "Picture",
      fits,
      act: () => space.viewer.peek()?.setView(view),
    })),
    ...LAYERS.map(([layer, title]): Action => ({
      id: `layer-${layer}`,
      title: `Show: ${title.charAt(0).toLowerCase()}${title.slice(1)}`,
      group: "Picture",
      words: "hide layer",
      fits,
      isOn: () => space.layers.value[layer],
      act: () => show(store, layer, !space.layers.peek()[layer]),
    })),
  ];
}
