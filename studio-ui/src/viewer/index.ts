// The three-dimensional view of a robot, independent of where it is shown.
export { explore, type Explorer } from "./explorer";
export { numbersAt } from "./numbers";
export { createViewer } from "./viewer";
export { eulerAngles, fromEuler, IDENTITY, rotationVector } from "./pose";
export type * from "./types";
export { widget } from "./widget";
