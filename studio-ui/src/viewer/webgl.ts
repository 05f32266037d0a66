// The drawing by WebGL. Translucent faces are split and sorted by a tree, so that those that intersect look right.
import {
  AmbientLight,
  BackSide,
  BufferAttribute,
  BufferGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  DoubleSide,
  DynamicDrawUsage,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Quaternion,
  Scene as World,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
  type Material,
  type PerspectiveCamera,
} from "three";
import { painted, tree, type Piece, type Tree } from "./bsp";
import type { Face, Model } from "./drawing";
import type { Vec3 } from "./types";
import { VeilPainter } from "./veil-webgl";
import { distance, sub, unit } from "./vectors";

const UP = new Vector3(0, 1, 0);

/** Copies of one shape, as many as are wanted. */
class Copies {
  private mesh: InstancedMesh;
  private used = 0;

  constructor(private readonly world: World, private readonly geometry: BufferGeometry, private readonly material: Material) {
    this.mesh = this.grown(64);
  }
  private grown(capacity: number): InstancedMesh {
    const mesh = new InstancedMesh(this.geometry, this.material, capacity);
    mesh.frustumCulled = false;
    mesh.setColorAt(0, new Color());
    this.world.add(mesh);
    return mesh;
  }
  start(count: number): void {
    if (count > this.mesh.instanceMatrix.count) {
      this.world.remove(this.mesh);
      this.mesh.dispose();
      this.mesh = this.grown(2 * count);
    }
    this.used = 0;
  }
  put(matrix: Matrix4, colour: string): void {
    this.mesh.setMatrixAt(this.used, matrix);
    this.mesh.setColorAt(this.used++, SWATCH.set(colour));
  }
  finish(): void {
    this.mesh.count = this.used;
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }
  dispose(): void {
    this.mesh.dispose();
    this.geometry.dispose();
    this.material.dispose();
  }
}
const SWATCH = new Color();

const REST = 200; // milliseconds

let software: boolean | undefined;

/** Whether programs do what a graphics card would. */
function isSoftware(): boolean {
  if (software !== undefined) return software;
  const context = document.createElement("canvas").getContext("webgl2");
  const unmasked = context?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;
  software = Boolean(context && /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(context.getParameter(unmasked ?? context.RENDERER))));
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}

export class WebGLPainter {
  readonly world = new World();
  private readonly renderer: WebGLRenderer;
  private readonly legs: Copies;
  private readonly lines: Copies;
  private readonly balls: Copies;
  private readonly rims: Copies;
  private readonly heads: Copies;
  private readonly faces: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly grid: LineSegments<BufferGeometry, LineBasicMaterial>;
  private readonly veil: VeilPainter;
  private readonly lamp = new DirectionalLight(0xffffff, 1.7);
  private split: Tree<Face> | null = null;
  private first = new Map<Piece<Face>, number>();

  private readonly slow = isSoftware();
  private fine = false;
  private rest = 0;

  /** Throws where there is no WebGL. */
  constructor(canvas: HTMLCanvasElement) {
    const wanted: WebGLContextAttributes = { antialias: !this.slow, alpha: true };
    const context = canvas.getContext("webgl2", wanted);
    if (!context) throw new Error("no WebGL");
    this.renderer = new WebGLRenderer({ canvas, context, ...wanted });
    this.renderer.setClearColor(0x000000, 0);
    const rod = new CylinderGeometry(1, 1, 1, 14, 1);
    this.legs = new Copies(this.world, rod, new MeshLambertMaterial());
    this.lines = new Copies(this.world, rod.clone(), new MeshBasicMaterial());
    this.balls = new Copies(this.world, new SphereGeometry(1, 16, 10), new MeshBasicMaterial());
    this.rims = new Copies(this.world, new SphereGeometry(1, 16, 10), new MeshBasicMaterial({ side: BackSide }));
    this.heads = new Copies(this.world, new ConeGeometry(1, 1, 20), new MeshBasicMaterial());
    this.faces = new Mesh(
      new BufferGeometry(),
      new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide, forceSinglePass: true }),
    );
    this.grid = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.3, depthWrite: false }));
    this.faces.frustumCulled = this.grid.frustumCulled = false;
    this.faces.renderOrder = 2;
    this.veil = new VeilPainter(this.world);
    this.world.add(this.faces, this.grid, new AmbientLight(0xffffff, 1.9), this.lamp, this.lamp.target);
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(this.fineness);
    this.renderer.setSize(width, height, false);
  }

  private get fineness(): number {
    return this.fine ? 2 : Math.min(window.devicePixelRatio || 1, 2);
  }

  /** Without a graphics card a pixel has one sample while the drawing moves; at rest it is drawn finer. */
  private refine(camera: PerspectiveCamera): void {
    clearTimeout(this.rest);
    this.rest = window.setTimeout(() => {
      this.sharpen(true);
      this.renderer.render(this.world, camera);
    }, REST);
  }

  private sharpen(fine: boolean): void {
    if (fine === this.fine) return;
    this.fine = fine;
    this.renderer.setPixelRatio(this.fineness);
  }

  load(model: Model, muted: string): void {
    for (const [copies, rods] of [
      [this.legs, model.rods.filter((r) => r.solid)],
      [this.lines, [...model.rods.filter((r) => !r.solid), ...edges(model)]],
    ] as const) {
      copies.start(rods.length);
      for (const rod of rods) copies.put(between(rod.a, rod.b, rod.radius), rod.colour);
      copies.finish();
    }
    this.balls.start(model.balls.length);
    this.rims.start(model.balls.length);
    for (const ball of model.balls) {
      this.balls.put(sized(ball.at, ball.radius), ball.fill);
      this.rims.put(sized(ball.at, ball.outer), ball.rim);
    }
    this.balls.finish();
    this.rims.finish();
    this.heads.start(model.cones.length);
    for (const cone of model.cones) this.heads.put(between(cone.base, cone.tip, cone.radius), cone.colour);
    this.heads.finish();
    this.loadFaces(model);
    this.veil.load(model.veil);
    this.grid.geometry.dispose();
    this.grid.geometry = new BufferGeometry();
    this.grid.geometry.setAttribute("position", new BufferAttribute(new Float32Array(model.grid.flat(2)), 3));
    this.grid.material.color.set(muted);
  }

  private loadFaces(model: Model): void {
    this.split = tree(model.faces.map((face) => ({ corners: face.corners, edges: face.edges, tag: face })), 1e-6 * model.radius);
    const positions: number[] = [];
    const colours: number[] = [];
    let triangles = 0;
    this.first = new Map();
    for (const piece of painted(this.split, model.middle)) {
      this.first.set(piece, positions.length / 3);
      triangles += piece.corners.length - 2;
      SWATCH.set(piece.tag.colour);
      for (const corner of piece.corners) {
        positions.push(...corner);
        colours.push(SWATCH.r, SWATCH.g, SWATCH.b, piece.tag.fill);
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 4));
    const index = new BufferAttribute(new Uint32Array(3 * triangles), 1);
    index.setUsage(DynamicDrawUsage);
    geometry.setIndex(index);
    this.faces.geometry.dispose();
    this.faces.geometry = geometry;
  }

  render(camera: PerspectiveCamera): void {
    const index = this.faces.geometry.getIndex();
    if (index) {
      let next = 0;
      for (const piece of painted(this.split, camera.position.toArray() as Vec3)) {
        const start = this.first.get(piece)!;
        for (let k = 2; k < piece.corners.length; k++) {
          index.setX(next++, start);
          index.setX(next++, start + k - 1);
          index.setX(next++, start + k);
        }
      }
      index.needsUpdate = true;
    }
    this.veil.sort(camera.position.toArray() as Vec3);
    // the light comes from over the viewer's left shoulder
    this.lamp.position.set(-0.5, 0.8, 1).applyQuaternion(camera.quaternion).add(this.lamp.target.position);
    this.sharpen(false);
    this.renderer.render(this.world, camera);
    if (this.slow) this.refine(camera);
  }

  dispose(): void {
    clearTimeout(this.rest);
    for (const copies of [this.legs, this.lines, this.balls, this.rims, this.heads]) copies.dispose();
    this.veil.dispose();
    this.faces.geometry.dispose();
    this.faces.material.dispose();
    this.grid.geometry.dispose();
    this.grid.material.dispose();
    this.renderer.dispose();
  }
}

/** The outlines of faces as thin rods. */
function edges(model: Model): { a: Vec3; b: Vec3; radius: number; colour: string }[] {
  return model.faces.flatMap((face) =>
    face.corners.flatMap((a, i) =>
      face.edges[i] ? [{ a, b: face.corners[(i + 1) % face.corners.length]!, radius: face.rim, colour: face.colour }] : [],
    ),
  );
}

const PLACE = new Vector3();
const TURN = new Quaternion();
const SIZE = new Vector3();

function between(a: Vec3, b: Vec3, radius: number): Matrix4 {
  PLACE.set((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2);
  TURN.setFromUnitVectors(UP, new Vector3(...unit(sub(b, a))));
  return new Matrix4().compose(PLACE, TURN, SIZE.set(radius, distance(a, b), radius));
}

function sized(at: Vec3, radius: number): Matrix4 {
  return new Matrix4().compose(PLACE.set(...at), TURN.identity(), SIZE.set(radius, radius, radius));
}
