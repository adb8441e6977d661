// Who wears a headset, in the scene: a group that holds eyes, hands and what goes with them. The
// scene stays in metres; who looks at it as a table is as many times larger.
import { Group, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import type { Spot } from './reading';

const UP = new Vector3(0, 1, 0);

export class Rig {
  readonly group = new Group();
  /** What the headset counts from: the floor, higher where one sits. */
  readonly inner = new Group();
  /** Between the eyes; three's camera is one eye's. */
  readonly head = new Group();
  readonly camera = new PerspectiveCamera(70, 1, 0.05, 20_000);

  constructor() {
    this.group.add(this.inner);
    this.inner.add(this.head, this.camera);
  }

  get scale(): number {
    return this.group.scale.x;
  }

  /** Sits, and is lifted to a standing person's height. */
  set lift_m(lift_m: number) {
    this.inner.position.y = lift_m;
    this.group.updateMatrixWorld(true);
  }

  take_head({ at, turned }: Spot): void {
    this.head.position.copy(at);
    this.head.quaternion.copy(turned);
    this.camera.position.copy(at);
    this.camera.quaternion.copy(turned);
    this.group.updateMatrixWorld(true);
  }

  /** A place of the headset's in the scene. */
  in_scene(at: Vector3): Vector3 {
    return this.inner.localToWorld(at.clone());
  }
  along(turned: Quaternion): Vector3 {
    const way = new Vector3(0, 0, -1).applyQuaternion(turned);
    return way.applyQuaternion(this.group.quaternion);
  }
  head_at(): Vector3 {
    return this.head.getWorldPosition(new Vector3());
  }
  looks_along(): Vector3 {
    return this.along(this.head.quaternion);
  }

  move(by: Vector3): void {
    this.group.position.add(by);
    this.group.updateMatrixWorld(true);
  }

  /** The place of the headset's comes to one of the scene, at a size. */
  bring(local: Vector3, to: Vector3, scale = this.scale): void {
    this.group.scale.setScalar(scale);
    this.group.updateMatrixWorld(true);
    this.move(to.clone().sub(this.in_scene(local)));
  }

  /** To the right, about the head. */
  turn(right_rad: number): void {
    const about = this.head.position.clone();
    const at = this.head_at();
    this.group.quaternion.multiply(new Quaternion().setFromAxisAngle(UP, -right_rad));
    this.bring(about, at);
  }

  /** The head looks that way in the level, from there. */
  face(at: Vector3, turn_rad: number, head_turn_rad: number): void {
    this.group.quaternion.setFromAxisAngle(UP, turn_rad - head_turn_rad);
    this.bring(this.head.position, at, 1);
  }

  /** The feet come to a place of the scene; the head is above it. */
  stand_at(at: Vector3): void {
    const { x, z } = this.head.position;
    this.bring(new Vector3(x, -this.inner.position.y, z), at, 1);
  }
}
