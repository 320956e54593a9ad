import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  DirectionalLight,
  EdgesGeometry,
  GridHelper,
  Group,
  HemisphereLight,
  LineSegments,
  Matrix4,
  Mesh,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Scene,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
  Color,
  type Material,
  type Object3D,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import type {ArmPoints, PlacedMark, Places, Point, Scene as RobotScene} from '../protocol.js';
import {areFinite} from '../numbers.js';
import {axesOf, kSigmas95In3D} from './geometry.js';
import type {Goal3d} from './goals_3d.js';
import {Materials} from './materials_3d.js';

export interface Shown3d {
  scene: RobotScene | null;
  arm: ArmPoints | null;
  places: Places | null;
  goals: Goal3d[];
  selected: string | null;
  colours: {ground: string; line: string; arm: string; commanded: string; muted: string};
}

/** m, how far the cameras' fields of view are drawn. */
const kFrustumDepth = 0.45;
/** m, smallest half axis of an ellipsoid that can still be seen. */
const kSmallestHalfAxis = 0.001;
/** m, of a mark whose size is not told, and of how thick any is drawn. */
const kMarkSize = 0.02;
const kMarkThickness = 0.002;

/** The scene in R: x forward, y left, z up. Drawn only when something has changed. */
export class Scene3d {
  private readonly renderer: WebGLRenderer;
  private readonly world = new Scene();
  private readonly camera = new PerspectiveCamera(40, 1, 0.02, 20);
  private readonly controls: OrbitControls;
  private readonly still = new Group();
  private readonly moving = new Group();
  private readonly materials = new Materials();
  private still_key = '';
  private moving_key = '';
  private asked = false;
  private disposed = false;

  /** Throws Error where there is no WebGL. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    select: (name: string) => void,
  ) {
    this.renderer = new WebGLRenderer({canvas, antialias: true, alpha: true, powerPreference: 'low-power'});
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(-0.55, -0.95, 1.15);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.listenToKeyEvents(canvas);
    this.controls.target.set(0.28, 0, 0.42);
    this.controls.addEventListener('change', () => this.draw());
    const sun = new DirectionalLight(0xffffff, 2);
    sun.position.set(-1, -1, 3);
    this.world.add(new HemisphereLight(0xffffff, 0x8899aa, 2), sun, this.still, this.moving);
    this.controls.update();
    canvas.addEventListener('click', (event) => this.pick(event, select));
    this.resize();
  }

  show(shown: Shown3d): void {
    const still_key = JSON.stringify([shown.scene?.cameras, shown.scene?.base, shown.colours]);
    // Without the times, which pass while nothing moves.
    const {arm, places} = shown;
    const moving = [arm?.measured, arm?.commanded, places?.marks, shown.goals];
    const moving_key = JSON.stringify([moving, shown.scene?.marks, shown.selected, shown.colours]);
    if (still_key !== this.still_key) {
      this.still_key = still_key;
      empty(this.still);
      this.buildStill(shown);
    } else if (moving_key === this.moving_key) return;
    this.moving_key = moving_key;
    empty(this.moving);
    this.buildMoving(shown);
    this.draw();
  }

  resize(): void {
    const box = this.canvas.parentElement!.getBoundingClientRect();
    if (box.width < 1 || box.height < 1) return;
    this.renderer.setSize(box.width, box.height, false);
    this.camera.aspect = box.width / box.height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  dispose(): void {
    this.disposed = true;
    empty(this.still);
    empty(this.moving);
    this.materials.dispose();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private draw(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.disposed) return;
      this.renderer.render(this.world, this.camera);
    });
  }

  private buildStill(shown: Shown3d): void {
    const grid = new GridHelper(2, 20, new Color(shown.colours.muted), new Color(shown.colours.line));
    grid.rotation.x = Math.PI / 2;
    this.still.add(grid);
    const base = shown.scene?.base;
    if (base) {
      const height = 0.22;
      const box = new BoxGeometry(base.front + base.rear, 2 * base.half_width, height);
      const edges = new LineSegments(new EdgesGeometry(box), this.materials.line(shown.colours.muted));
      edges.position.set((base.front - base.rear) / 2, 0, height / 2);
      this.still.add(edges);
    }
    const cameras = shown.scene?.cameras;
    if (!cameras) return;
    for (const side of [0, 1]) {
      const [x, y, z] = cameras.p_RC;
      const origin = new Vector3(x, y - side * cameras.baseline, z);
      const cx = side === 0 ? cameras.cx_left_px : cameras.cx_right_px;
      const corner = (u: number, v: number): Vector3 =>
        origin
          .clone()
          .add(
            new Vector3(1, -(u - cx) / cameras.fx_px, -(v - cameras.cy_px) / cameras.fy_px).multiplyScalar(
              kFrustumDepth,
            ),
          );
      const corners = [
        corner(0, 0),
        corner(cameras.width_px, 0),
        corner(cameras.width_px, cameras.height_px),
        corner(0, cameras.height_px),
      ];
      const ends = corners.flatMap((end, index) => [origin, end, end, corners[(index + 1) % 4]!]);
      this.still.add(lines(ends, this.materials.line(shown.colours.muted, 0.55)));
    }
  }

  private buildMoving(shown: Shown3d): void {
    if (shown.arm?.commanded?.every(areFinite)) this.addArm(shown.arm.commanded, shown.colours.commanded, 0.35, 0.009);
    if (shown.arm?.measured?.every(areFinite)) this.addArm(shown.arm.measured, shown.colours.arm, 1, 0.011);
    for (const mark of shown.places?.marks ?? []) {
      if (!mark.p_R || !areFinite(mark.p_R)) continue;
      const known = shown.scene?.marks.find((row) => row.name === mark.name);
      const selected = shown.selected === mark.name;
      const size = known?.size ?? kMarkSize;
      const box = new BoxGeometry(size, size, kMarkThickness);
      const square = new Mesh(box, this.materials.solid(known?.colour ?? '#888888'));
      square.position.set(...mark.p_R);
      face(square, mark);
      square.userData['name'] = mark.name;
      if (selected) square.scale.setScalar(1.6);
      this.moving.add(square);
      if (mark.covariance_R && areFinite(mark.covariance_R)) {
        this.addEllipsoid(mark.p_R, mark.covariance_R, known?.colour ?? '#888888');
      }
    }
    for (const goal of shown.goals) this.addGoal(goal, shown);
  }

  private addArm(points: Point[], colour: string, opacity: number, radius: number): void {
    const material = this.materials.solid(colour, opacity);
    points.forEach((point, index) => {
      const joint = new Mesh(new SphereGeometry(radius * 1.35, 16, 12), material);
      joint.position.set(...point);
      this.moving.add(joint);
      const next = points[index + 1];
      if (!next) return;
      const from = new Vector3(...point);
      const along = new Vector3(...next).sub(from);
      const link = new Mesh(new CylinderGeometry(radius, radius, along.length(), 16), material);
      link.position.copy(from).addScaledVector(along, 0.5);
      link.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), along.clone().normalize());
      this.moving.add(link);
    });
  }

  private addEllipsoid(centre: Point, covariance: readonly number[], colour: string): void {
    const {values, vectors} = axesOf(covariance);
    const axis = (k: number): Vector3 => new Vector3(vectors[0]![k], vectors[1]![k], vectors[2]![k]);
    const [x, y] = [axis(0), axis(1)];
    const ellipsoid = new Mesh(new SphereGeometry(1, 20, 14), this.materials.veil(colour));
    ellipsoid.quaternion.copy(
      new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(x, y, x.clone().cross(y))),
    );
    const half = (value: number): number => Math.max(kSmallestHalfAxis, kSigmas95In3D * Math.sqrt(Math.max(0, value)));
    ellipsoid.scale.set(half(values[0]!), half(values[1]!), half(values[2]!));
    ellipsoid.position.set(...centre);
    this.moving.add(ellipsoid);
  }

  /** The grip point's as a cross, the hand's as the outline of its mark, each with what is not known of it. */
  private addGoal(goal: Goal3d, shown: Shown3d): void {
    const colour = shown.colours.commanded;
    if (goal.covariance_R) this.addEllipsoid(goal.p_R, goal.covariance_R, colour);
    if (goal.mark) this.addOutline(goal.p_R, goal.mark, shown);
    else this.addCross(goal.p_R, colour);
  }

  private addOutline(point: Point, mark: PlacedMark, shown: Shown3d): void {
    const size = shown.scene?.marks.find((row) => row.name === mark.name)?.size ?? kMarkSize;
    const box = new BoxGeometry(size, size, kMarkThickness);
    const outline = new LineSegments(new EdgesGeometry(box), this.materials.line(shown.colours.commanded));
    box.dispose();
    outline.position.set(...point);
    face(outline, mark);
    this.moving.add(outline);
  }

  private addCross(point: Point, colour: string): void {
    const ends: Vector3[] = [];
    for (const direction of [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const) {
      const arm = new Vector3(...direction).multiplyScalar(0.03);
      ends.push(new Vector3(...point).sub(arm), new Vector3(...point).add(arm));
    }
    this.moving.add(lines(ends, this.materials.line(colour)));
  }

  private pick(event: MouseEvent, select: (name: string) => void): void {
    const box = this.canvas.getBoundingClientRect();
    const pointer = new Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1,
      1 - ((event.clientY - box.top) / box.height) * 2,
    );
    const ray = new Raycaster();
    ray.setFromCamera(pointer, this.camera);
    const hit = ray.intersectObjects(this.moving.children).find((found) => found.object.userData['name']);
    if (hit) select(hit.object.userData['name'] as string);
  }
}

/** Turns a mark's drawing as the mark lies. */
function face(object: Object3D, mark: PlacedMark): void {
  if (!mark.normal_R || !(Math.hypot(...mark.normal_R) > 0.5)) return;
  object.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...mark.normal_R).normalize());
}

function lines(ends: Vector3[], material: Material): LineSegments {
  return new LineSegments(new BufferGeometry().setFromPoints(ends), material);
}

/** Takes all out of a group, and gives the graphics card's memory back. */
function empty(group: Group): void {
  group.traverse((object: Object3D) => (object as Mesh).geometry?.dispose());
  group.clear();
}
