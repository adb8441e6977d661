// The arc of a throw and the ring where it comes down.
import {
  BufferGeometry,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  RingGeometry,
  type Vector3,
} from 'three';
import { arc_of, type Landing } from './teleport';

export class ThrowMark {
  readonly group = new Group();
  private readonly ink = new LineBasicMaterial({ fog: false });
  private readonly line = new Line(new BufferGeometry(), this.ink);
  private readonly ring: Mesh<RingGeometry, MeshBasicMaterial>;

  constructor() {
    const flat = new RingGeometry(0.35, 0.5, 32);
    flat.rotateX(-Math.PI / 2);
    this.ring = new Mesh(flat, new MeshBasicMaterial({ fog: false, depthTest: false }));
    this.line.frustumCulled = false;
    this.group.add(this.line, this.ring);
    this.hide();
  }

  hide(): void {
    this.group.visible = false;
  }

  show(from: Vector3, ahead: Vector3, landing: Landing | null, good: string, bad: string): void {
    this.group.visible = true;
    this.line.geometry.dispose();
    this.line.geometry = new BufferGeometry().setFromPoints(arc_of(from, ahead, landing));
    this.ink.color.set(landing === null ? bad : good);
    this.ring.visible = landing !== null;
    this.ring.material.color.set(good);
    if (landing !== null) this.ring.position.copy(landing.at);
  }

  dispose(): void {
    for (const part of [this.line, this.ring]) {
      part.geometry.dispose();
      part.material.dispose();
    }
  }
}
