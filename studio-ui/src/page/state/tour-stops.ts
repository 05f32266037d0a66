// The tour of three minutes: what the studio is for, along one robot. Each stop leads to a place of the page and points at a part of it.
import { effect, type ReadonlySignal } from "@preact/signals";
import type { Store } from "./store";

export interface Stop {
  title: string;
  words: string;
  /** What is pointed at: the test id of a part of the page; null for none. */
  at: string | null;
  /** The function that may be returned gives up what has not happened yet. */
  lead(store: Store): void | (() => void);
}

const OCTAHEDRAL = { kind: "example", name: "octahedral" } as const;
const DOWN = { translation: [0, 0, -380], quaternion: [1, 0, 0, 0] } as const;

/** The robot of the tour in a panel; what was open before is one step to undo away. */
const show =
  (panel: "guided" | "motion" | "where" | "dimensions" | "manual" | "take-away", stage?: "structure" | "condition" | "statement") =>
  (store: Store): void => {
    store.open(OCTAHEDRAL, panel);
    store.go({ panel, ...(stage && { stage }) });
  };

/** Acts as soon as there is something; the function that is returned gives it up. */
function once(known: ReadonlySignal<unknown>, act: () => void): () => void {
  let waits = true;
  return effect(() => {
    if (known.value === null || !waits) return;
    waits = false;
    queueMicrotask(act);
  });
}

export const STOPS: readonly Stop[] = [
  {
    title: "When does a robot lose control?",
    words: "A platform on six legs is stiff, but for some poses: there it can move although every leg keeps its length. The studio says when, and why, as geometry. The tour takes one robot from the start page; your own comes after.",
    at: null,
    lead: (store) => store.go({ panel: "start" }),
  },
  {
    title: "From six legs to a sentence",
    words: "Each step says what it does and why: the legs, their determinant (the superbracket), its shortest form, the planes in it. Next step leads on; the keys n and b do the same.",
    at: "stage-structure",
    lead: show("guided", "structure"),
  },
  {
    title: "The condition, proved",
    words: "The determinant equals the meet of four planes, term by term. Point at a plane in the formula, and it lights up in the sentence and in the robot.",
    at: "condition",
    lead: show("guided", "condition"),
  },
  {
    title: "Why, as geometry",
    words: "The robot is singular exactly when the four planes meet in a point. Turn the picture with the mouse or the arrow keys, or let it fill the window.",
    at: "viewer",
    lead: show("guided", "statement"),
  },
  {
    title: "Move it",
    words: "Sliders, handles and keys move the platform. Here it is driven 380 mm down, and it does not get there unharmed: the way crosses singular poses, which is reported at once.",
    at: "crossed",
    lead(store) {
      show("guided", "statement")(store);
      return once(store.posing.numbers, () => store.moving.to({ translation: [...DOWN.translation], quaternion: [...DOWN.quaternion] }));
    },
  },
  {
    title: "The way, proved",
    words: "Below, the way that was driven: its margin, and every singular pose on it by exact arithmetic. None is missed. Waypoints are added, played, read from a table.",
    at: "way",
    lead: show("guided", "statement"),
  },
  {
    title: "Maps, curves and surfaces",
    words: "Over any two coordinates, with the singular curves and what is proved free of them. A click moves the platform there.",
    at: "map-go",
    lead: show("motion"),
  },
  {
    title: "Where can it go?",
    words: "All ways to assemble it, the largest box around a pose without a singular one, and certificates of whole ranges.",
    at: "free",
    lead: show("where"),
  },
  {
    title: "Your dimensions",
    words: "Joints are dragged or typed; the condition stays, the numbers follow, and a second robot stands beside the first.",
    at: "plan",
    lead: show("dimensions"),
  },
  {
    title: "Take it away",
    words: "A report, a section for a paper, figures, code for a controller, and, by r, the lines of shell and Python that repeat what you see. Now your robot: type its legs, draw it, build it joint by joint, or open a file.",
    at: "offer-html",
    lead: show("take-away"),
  },
];
