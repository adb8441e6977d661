// How a hand is seen by who wears the headset: a controller as a plain grip with its ray, a bare
// hand as its 25 joints and bones.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  Line,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import { BONES, JOINTS } from './joints';
import type { HandReading } from './reading';

const JOINT_M = 0.006;
const RAY_M = 1.5;
const LIGHT = '#d9e2e8';
const SOLID = { color: LIGHT, fog: false, transparent: true };
const HELD = '#ffb000'; // on the vehicle's stick

export class HandModel {
  readonly group = new Group();
  // As see-through things are: drawn late, so that they are before the signs.
  private readonly paint = new MeshBasicMaterial(SOLID);
  private readonly ink = new LineBasicMaterial(SOLID);
  private readonly controller = new Group();
  private readonly ray: Line;
  private readonly joints: InstancedMesh;
  private readonly bones: LineSegments;

  constructor() {
    const grip = new Mesh(new BoxGeometry(0.035, 0.035, 0.12), this.paint);
    const front = new Mesh(new ConeGeometry(0.02, 0.04, 10), this.paint);
    front.rotation.x = -Math.PI / 2;
    front.position.z = -0.08;
    this.controller.add(grip, front);
    const along = [new Vector3(), new Vector3(0, 0, -RAY_M)];
    this.ray = new Line(new BufferGeometry().setFromPoints(along), this.ink);
    this.joints = new InstancedMesh(new SphereGeometry(JOINT_M, 6, 4), this.paint, JOINTS.length);
    this.joints.instanceMatrix.setUsage(DynamicDrawUsage);
    const ends = new BufferAttribute(new Float32Array(6 * BONES.length), 3);
    this.bones = new LineSegments(new BufferGeometry().setAttribute('position', ends), this.ink);
    for (const part of [this.joints, this.bones, this.ray]) part.frustumCulled = false;
    for (const part of [this.joints, this.bones, this.ray, grip, front]) part.renderOrder = 200;
    this.group.add(this.controller, this.ray, this.joints, this.bones);
    this.show(null, false, false);
  }

  /** How many joints of it are drawn: 25, or none. */
  get joints_drawn(): number {
    return this.joints.visible ? this.joints.count : 0;
  }
  get controller_is_drawn(): boolean {
    return this.controller.visible;
  }

  show(hand: HandReading | null, is_on_stick: boolean, has_ray: boolean): void {
    const grip = hand?.kind === 'controller' ? hand.grip : null;
    this.controller.visible = grip !== null;
    if (grip !== null) {
      this.controller.position.copy(grip.at);
      this.controller.quaternion.copy(grip.turned);
    }
    const ray = hand?.ray ?? null;
    this.ray.visible = ray !== null && has_ray;
    if (ray !== null) {
      this.ray.position.copy(ray.at);
      this.ray.quaternion.copy(ray.turned);
    }
    const joints = hand?.joints ?? null;
    this.joints.visible = this.bones.visible = joints !== null;
    if (joints !== null) this.place_joints(joints);
    for (const it of [this.paint, this.ink]) it.color.set(is_on_stick ? HELD : LIGHT);
  }

  dispose(): void {
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof Line) part.geometry.dispose();
    });
    this.joints.dispose();
    this.paint.dispose();
    this.ink.dispose();
  }

  private place_joints(joints: readonly Vector3[]): void {
    const to = new Matrix4();
    joints.forEach((at, nth) => this.joints.setMatrixAt(nth, to.setPosition(at)));
    this.joints.instanceMatrix.needsUpdate = true;
    const ends = this.bones.geometry.getAttribute('position');
    BONES.forEach(([from, into], nth) => {
      ends.setXYZ(2 * nth, ...joints[from]!.toArray());
      ends.setXYZ(2 * nth + 1, ...joints[into]!.toArray());
    });
    ends.needsUpdate = true;
  }
}
