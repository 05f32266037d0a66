// The three-dimensional view of a robot, independent of where it is shown.
export { explore, type Explorer } from "./explorer";
export { numbersAt } from "./numbers";
export { moved } from "./drives";
export { limbNumbers } from "./limb-margin";
export { driveTo, driven, home, named } from "./linkage";
export { createViewer } from "./viewer";
export { eulerAngles, fromEuler, IDENTITY, rotationVector } from "./pose";
export type * from "./types";
export { widget } from "./widget";
