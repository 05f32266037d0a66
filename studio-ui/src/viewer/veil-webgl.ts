// A curved translucent surface by WebGL: shaded by its normals, its triangles sorted for each place of the eye.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, Mesh, MeshLambertMaterial, type Scene } from "three";
import { farthestFirst, type Veil } from "./mesh";
import type { Vec3 } from "./types";
import { distance } from "./vectors";

export class VeilPainter {
  private readonly mesh = new Mesh(
    new BufferGeometry(),
    new MeshLambertMaterial({ vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide, forceSinglePass: true }),
  );
  private veil: Veil | null = null;
  private sorted: Vec3 | null = null;

  constructor(world: Scene) {
    this.mesh.frustumCulled = this.mesh.visible = false;
    this.mesh.renderOrder = 1;
    world.add(this.mesh);
  }

  load(veil: Veil | null): void {
    const before = this.veil;
    this.veil = veil;
    this.mesh.visible = veil !== null;
    if (!veil) return;
    this.mesh.material.opacity = veil.fill;
    if (before?.corners !== veil.corners) this.shape(veil);
    const colours = this.mesh.geometry.getAttribute("color") as BufferAttribute;
    const swatch = new Color();
    veil.colours.forEach((colour, i) => colours.setXYZ(i, swatch.set(colour).r, swatch.g, swatch.b));
    colours.needsUpdate = true;
  }

  private shape({ corners, triangles }: Veil): void {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners.flat()), 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(3 * corners.length), 3));
    const index = new BufferAttribute(new Uint32Array(triangles.flat()), 1);
    index.setUsage(DynamicDrawUsage);
    geometry.setIndex(index);
    geometry.computeVertexNormals();
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
    this.sorted = null;
  }

  /** Puts the triangles in order for an eye; nothing is done while it stays where it is. */
  sort(eye: Vec3): void {
    const index = this.mesh.geometry.getIndex();
    if (!this.veil || !index || (this.sorted && distance(this.sorted, eye) === 0)) return;
    this.sorted = eye;
    let next = 0;
    for (const i of farthestFirst(this.veil, eye)) for (const corner of this.veil.triangles[i]!) index.setX(next++, corner);
    index.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
