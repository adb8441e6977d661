// What the inspections would report as of now, as marks where it was found.
import { MeshBasicMaterial, OctahedronGeometry, type Scene } from 'three';
import type { Finding } from '../session/inspected';
import { at_place } from './axes';
import { Instances } from './instances';

const LEAST_M = 0.12; // so that a small one is seen, too

export class FindingsView {
  private readonly paint = new MeshBasicMaterial({ fog: false });
  private readonly marks: Instances;

  constructor(scene: Scene) {
    this.marks = new Instances(scene, new OctahedronGeometry(1), this.paint);
  }

  show(findings: Iterable<readonly Finding[]>, colour: string): void {
    this.paint.color.set(colour);
    this.marks.begin();
    for (const of_vehicle of findings)
      for (const { at, size_m } of of_vehicle) {
        this.marks.part.position.copy(at_place(at));
        this.marks.part.scale.setScalar(Math.max(LEAST_M, (size_m ?? 0) / 2));
        this.marks.add();
      }
    this.marks.end();
  }

  hide(): void {
    this.marks.clear();
  }
}
