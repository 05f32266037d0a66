// Texts to begin with. The first one is made of the structure that is open.
import type { Study } from "../../../protocol";

export interface Example {
  title: string;
  text: string;
}

const FIXED: readonly Example[] = [
  {
    title: "Meet and join",
    text: `# The point in which the line ab meets the plane cde, and the line in which two planes meet.
let p = ab /\\ cde
let l = abc /\\ def

# Scalars are expanded into brackets.
p \\/ cdf

# The four meets of a line with a plane are one: Cramer's rule.
[abcd] e == [ebcd] a + [aecd] b + [abed] c + [abce] d
`,
  },
  {
    title: "Octahedral platform",
    text: `# Four alternate faces of the octahedron meet in a point, and so do the other four.
let M = ace /\\ abf /\\ cbd
[[ab, af, cb, cd, ed, ef]] == ace /\\ abf /\\ cbd /\\ edf
[[ab, af, cb, cd, ed, ef]] == bdf /\\ acb /\\ ced /\\ eaf

[[ab, af, cb, cd, ed, ef]]
`,
  },
  {
    title: "Two pencils of legs",
    text: `# The platform turns about p and about q; each of the other two legs allows the turns in one ratio.
let p = AB
let q = Aab /\\ Bcd
[[Aa, Ab, Bc, Bd, Ce, Df]] == (p /\\ Df)(q /\\ Ce) - (p /\\ Ce)(q /\\ Df)
`,
  },
  {
    title: "Desargues in the plane",
    text: `rank 3

let x = bc /\\ b'c'
let y = ca /\\ c'a'
let z = ab /\\ a'b'
claim "Desargues": [x, y, z] == [abc][a'b'c'] * (aa' /\\ bb' /\\ cc')
`,
  },
  {
    title: "A claim that is wrong",
    text: `# It is refuted by exact points.
[abcd][efgh] == [abce][dfgh]
`,
  },
];

export function examplesFor(study: Study | null): readonly Example[] {
  const own = study && ofStudy(study);
  return own ? [own, ...FIXED] : FIXED;
}

const SHORT = /^[A-Za-z](_?\d+)?'*$/;

function ofStudy(study: Study): Example | null {
  const { legs, condition, entities, points } = study;
  if (legs.length !== 6 || !Object.keys(points).every((name) => SHORT.test(name))) return null;
  const written = condition.text;
  const factor = condition.cofactor === "1" ? "" : `(${condition.cofactor}) * `;
  const planes = entities.filter(({ kind }) => kind === "plane").slice(0, 3);
  const lines = planes.length > 1 ? [`let m = ${planes.map((e) => e.points.join("")).join(" /\\ ")}`] : [];
  const claim = written && !condition.kind.includes("complex") ? [`${factor}[[${legs.map((l) => l.join("")).join(", ")}]] == ${written}`] : [];
  const text = ["# The condition of this robot.", ...lines, ...claim, ""].join("\n");
  return { title: "This robot", text };
}
