// What is drawn fills the picture, of any shape and from any side, and nothing is cut off.
import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera, Vector3 } from "three";
import { framed, holds, tips, type Pane } from "../src/viewer/framing";
import { sightOf } from "../src/viewer/sight";
import type { Vec3 } from "../src/viewer/types";

const PANES: Pane[] = [[480, 215], [800, 400], [300, 640], [60, 40], [1600, 300]].map(([width, height]) => ({ width: width!, height: height!, covered: [0, 0], fov: 26, letter: 1 }));
const SHAPES: Record<string, Vec3[]> = {
  wide: [[-1, -2, 0], [1.2, 1.8, 0.2], [0, -1, 0.5]],
  tall: [[0, 0, 0], [0.9, 0, 4], [-0.8, 0.6, 2], [0.3, -0.7, 1]],
  flat: [[-3, -3, 0], [3, -3, 0], [3, 3, 0], [-3, 3, 0]],
  "beside the middle": [[7, 7, 7], [8, 7, 7.5], [7, 9, 8]],
  point: [[1, 2, 3]],
};
const SIDES: Vec3[] = [[1, 1, 0.6], [0, -1, 0], [1, 0, 0], [0, -1e-4, 1], [-0.3, 0.8, -0.5]];

function seen(places: Vec3[], from: Vec3, pane: Pane): { x: [number, number]; y: [number, number] } {
  const { eye, target } = framed(places, from, pane);
  const camera = new PerspectiveCamera(pane.fov, pane.width / pane.height, 0.01, 1000);
  camera.up.set(0, 0, 1);
  camera.position.set(...eye);
  camera.lookAt(new Vector3(...target));
  const sight = sightOf(camera, pane.width, pane.height);
  const at = places.map(sight.place);
  assert.ok(at.every(([, , depth]) => depth > 0));
  const range = (k: 0 | 1): [number, number] => [Math.min(...at.map((p) => p[k])), Math.max(...at.map((p) => p[k]))];
  return { x: range(0), y: range(1) };
}

test("what is drawn touches the margins of the picture, and is in its middle", () => {
  for (const [name, places] of Object.entries(SHAPES))
    for (const from of SIDES)
      for (const pane of PANES) {
        const { x, y } = seen(places, from, pane);
        const margins = [Math.min(44, 0.09 * pane.width), Math.min(30, 0.09 * pane.height)] as const;
        const free = [x[0] - margins[0], pane.width - margins[0] - x[1], y[0] - margins[1], pane.height - margins[1] - y[1]];
        const where = `${name} from ${from.join(" ")} in ${pane.width} × ${pane.height}`;
        assert.ok(free.every((f) => f > -1e-6), `${where}: ${free.join(" ")}`);
        if (places.length > 1) assert.ok(Math.min(Math.max(free[0]!, free[1]!), Math.max(free[2]!, free[3]!)) < 1e-6, `${where}: one side is filled ${free.join(" ")}`);
      }
});

test("more of the edges is left free where something covers them", () => {
  const pane = { ...PANES[1]!, covered: [80, 20] };
  const { y } = seen(SHAPES.tall!, [0, -1, 0], pane);
  assert.ok(y[0] > 80 + 29.9 && y[1] < pane.height - 20 - 29.9, "labels have their room too");
  assert.ok(y[0] + pane.height - y[1] < 100 + 60.1, "and no more is left free");
});

test("handles are as large in the picture from any distance", () => {
  const pane = PANES[1]!;
  for (const eye of [[0, -5, 0], [0, -50, 0]] as Vec3[]) {
    const far = tips({ at: [0, 0, 0], reach: 0.5 }, { eye, target: [0, 0, 0] }, pane.fov);
    const camera = new PerspectiveCamera(pane.fov, pane.width / pane.height, 0.01, 1000);
    camera.up.set(0, 0, 1);
    camera.position.set(...eye);
    camera.lookAt(new Vector3(0, 0, 0));
    const seen = far.map(sightOf(camera, pane.width, pane.height).place);
    const apart = seen.map(([x, y]) => Math.hypot(x - pane.width / 2, y - pane.height / 2));
    for (const a of apart) assert.ok(Math.abs(a - 0.25 * pane.height) < 1e-6, `${a}`);
  }
});

test("it is known whether all is in the picture", () => {
  const stand = framed(SHAPES.flat!, [1, 1, 0.6], PANES[1]!);
  assert.ok(holds(SHAPES.flat!, stand, PANES[1]!));
  assert.ok(!holds([...SHAPES.flat!, [0, 0, 30]], stand, PANES[1]!));
  assert.ok(!holds([stand.eye.map((c) => 2 * c) as Vec3], stand, PANES[1]!), "what is behind the eye is not in it");
});
