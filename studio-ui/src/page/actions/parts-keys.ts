// Keys that parts of the page have while they are in use, for the list of keys; the parts themselves handle them.
export interface PartKeys {
  part: string;
  rows: readonly (readonly [keys: string, words: string])[];
}

export const PARTS: readonly PartKeys[] = [
  {
    part: "In the picture",
    rows: [
      ["Arrows", "Shift the platform along x and y; where it cannot be moved, turn the view"],
      ["PageUp", "Shift it along z, up; Page ↓ down"],
      ["Shift Arrows", "Turn the platform"],
      ["Alt Arrows", "Turn the view"],
      ["+", "Nearer; − further away"],
      ["Home", "Fit the robot into the picture"],
      [".", "Choose the next waypoint, or joint of the shape; the keys above then move it, as its handles do"],
      [",", "Choose the one before"],
      ["Insert", "Put a waypoint after the chosen one"],
      ["Delete", "Take the chosen waypoint out"],
      ["Escape", "Let it go"],
    ],
  },
  {
    part: "In a field of numbers",
    rows: [
      ["ArrowUp", "One step up; ↓ down"],
      ["PageUp", "Ten steps up; Page ↓ down"],
      ["Enter", "Accept the number"],
      ["Escape", "Leave it as it was"],
    ],
  },
  { part: "In the list of waypoints", rows: [["Alt ArrowUp", "Move the pose forward; Alt ↓ back"]] },
  { part: "On the bench", rows: [["Mod Enter", "Evaluate the expression"]] },
  {
    part: "On the drawing sheet",
    rows: [
      ["Arrows", "Move a point"],
      ["Enter", "Join two points by a leg"],
      ["Delete", "Remove a point"],
    ],
  },
  {
    part: "On a map",
    rows: [
      ["Arrows", "Choose a place"],
      ["Enter", "Take the robot there"],
    ],
  },
];
