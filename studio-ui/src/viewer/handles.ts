// The handles as SVG. Their parts are convex, or rings: each is one shape.
import { Color, Mesh, SRGBColorSpace, TorusGeometry, Vector3, type MeshBasicMaterial, type Object3D } from "three";
import type { Sight } from "./sight";
import { convexHull } from "./solids";
import { element } from "./svg";

const CORNER = new Vector3();
const COLOUR = new Color();

export function paintHandles(root: SVGElement, helper: Object3D, sight: Sight): void {
  helper.updateMatrixWorld();
  const shapes: SVGElement[] = [];
  if (helper.visible) helper.traverseVisible((one) => (one instanceof Mesh && shown(one) ? shapes.push(shape(one, sight)) : 0));
  root.replaceChildren(...shapes);
}

/** Not the invisible parts that are only there to be grabbed. */
const shown = (mesh: Mesh): boolean => (mesh.material as MeshBasicMaterial).visible && mesh.geometry.attributes.position !== undefined;

function shape(mesh: Mesh, sight: Sight): SVGElement {
  const material = mesh.material as MeshBasicMaterial;
  const paint = `#${COLOUR.copy(material.color).getHexString(SRGBColorSpace)}`;
  const position = mesh.geometry.getAttribute("position")!;
  const place = (i: number): [number, number] => {
    CORNER.fromBufferAttribute(position, i).applyMatrix4(mesh.matrixWorld);
    const [x, y] = sight.place([CORNER.x, CORNER.y, CORNER.z]);
    return [x, y];
  };
  const points = (places: [number, number][]) => places.map((p) => p.map((c) => c.toFixed(1)).join(",")).join(" ");
  if (mesh.geometry instanceof TorusGeometry) {
    const ring = Array.from({ length: mesh.geometry.parameters.tubularSegments + 1 }, (_, i) => place(i));
    return element("polyline", { points: points(ring), fill: "none", stroke: paint, "stroke-width": 2.4, "stroke-opacity": material.opacity });
  }
  const hull = convexHull(Array.from({ length: position.count }, (_, i) => place(i)));
  return element("polygon", { points: points(hull), fill: paint, "fill-opacity": material.opacity, stroke: paint, "stroke-width": 1, "stroke-opacity": material.opacity });
}
