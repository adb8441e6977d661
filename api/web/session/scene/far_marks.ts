// What is too far away for its shape to be seen: one mark of its size, its tip ahead.
import { Color, ConeGeometry, Euler, MeshLambertMaterial, Vector3, type Scene } from 'three';
import { Instances } from './instances';

const PAINTS = { vehicle: new Color('#e2b33c'), vessel: new Color('#7c4136') };

export interface Size {
  long_m: number;
  wide_m: number;
}

export class FarMarks {
  private readonly marks: Instances;

  constructor(scene: Scene) {
    const mark = new ConeGeometry(0.5, 1, 5);
    mark.rotateX(-Math.PI / 2); // its tip along -z
    this.marks = new Instances(scene, mark, new MeshLambertMaterial(), 'far away');
  }

  begin(): void {
    this.marks.begin();
  }
  add(kind: keyof typeof PAINTS, name: string, at: Vector3, turn: Euler, size: Size): void {
    const { part } = this.marks;
    const { long_m, wide_m } = size;
    part.position.copy(at);
    part.rotation.copy(turn);
    part.scale.set(wide_m, wide_m, long_m);
    this.marks.add(PAINTS[kind], name);
  }
  end(): void {
    this.marks.end();
  }
}
