// What can be taken away, in words.
import type { Format } from "../../../protocol";

/** `embedded` is the report of the robot in its pose alone, without notes and links of this machine. */
export type Thing = Exclude<Format, "png"> | "embedded" | "view-png" | "view-svg" | "view-way" | "view-motion";

export interface Offer {
  thing: Thing;
  title: string;
  badge: string;
  words: string;
}

/** What cannot be shown before it is saved. */
export const UNSEEN: readonly Thing[] = ["pdf", "view-way", "view-motion"];

export const SECTIONS: readonly { title: string; offers: readonly Offer[] }[] = [
  {
    title: "To read",
    offers: [
      {
        thing: "html",
        title: "Report",
        badge: "HTML",
        words:
          "One page of everything as it stands: pose and numbers, picture, way, the answers of the panels, every step, notes, and what repeats it. It opens anywhere, without a network.",
      },
      {
        thing: "latex",
        title: "Derivation",
        badge: "TEX",
        words: "Every step with its rule, as a document that compiles by itself.",
      },
    ],
  },
  {
    title: "Figures",
    offers: [
      { thing: "svg", title: "Figure", badge: "SVG", words: "Robot, entities and condition at this pose, as vectors." },
      { thing: "pdf", title: "Figure", badge: "PDF", words: "The same for LaTeX." },
      { thing: "view-png", title: "3D view", badge: "PNG", words: "The picture on the right as it stands." },
      { thing: "view-svg", title: "3D view", badge: "SVG", words: "The same as vectors." },
      { thing: "view-way", title: "The way, played once", badge: "WEBM", words: "A film of the picture on the right, of the way that was driven or given." },
      { thing: "view-motion", title: "The gained motion", badge: "WEBM", words: "A film of it, two swings to and fro, at a singular pose." },
    ],
  },
  {
    title: "Proofs that others check",
    offers: [
      {
        thing: "proof",
        title: "Proof file",
        badge: "PROOF",
        words: "The condition and all readings as theorems with their proofs, which a program of 400 lines checks without gcrules.",
      },
      { thing: "coq", title: "Script of Coq", badge: "COQ", words: "The same, down to coordinates; coqc proves it without axioms." },
    ],
  },
  {
    title: "Code for a controller",
    offers: [
      { thing: "c", title: "Check and kinematics", badge: "C", words: "Factors, margin and inverse kinematics as functions of the pose, with a test." },
      { thing: "cpp", title: "Check and kinematics", badge: "C++", words: "The same in C++17." },
      { thing: "py", title: "Check and kinematics", badge: "PY", words: "The same in Python, without any library." },
      { thing: "rs", title: "Check and kinematics", badge: "RS", words: "The same in Rust." },
    ],
  },
  {
    title: "Data",
    offers: [
      { thing: "yaml", title: "Robot file", badge: "YAML", words: "Legs and coordinates at this pose, to be opened here or with gcrules." },
      { thing: "json", title: "Analysis", badge: "JSON", words: "Everything that was found, and the numbers at this pose." },
    ],
  },
];
