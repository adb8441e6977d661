// Foundations and whatever else stands in the water: round from near, with few faces from afar.
import { Color, CylinderGeometry, MeshLambertMaterial, type Scene } from 'three';
import type { Structure } from '../session/message';
import { at_place } from './axes';
import { seen_px, type Lens } from './detail';
import { Instances } from './instances';

const PAINT = new Color('#e7c53a'); // what stands out of the water
const STEEL = new Color('#8d979f');
const ROUND_PX = 40; // as wide as that its faces would be seen

export class Foundations {
  private readonly near: Instances;
  private readonly far: Instances;

  constructor(scene: Scene) {
    const paint = new MeshLambertMaterial();
    this.near = new Instances(scene, new CylinderGeometry(1, 1, 1, 64), paint, 'foundations');
    this.far = new Instances(scene, new CylinderGeometry(1, 1, 1, 10), paint, 'foundations');
  }

  show(structures: readonly Structure[], lens: Lens): void {
    this.near.begin();
    this.far.begin();
    for (const structure of structures) {
      const { top_m, bottom_m, radius_m } = structure;
      const high_m = Math.max(0.1, top_m - bottom_m);
      // Its place nearest to the height of the eye: one may be close to the foot of a high one.
      const up_m = Math.min(top_m, Math.max(bottom_m, lens.eye.y));
      const is_round = seen_px(lens, at_place({ ...structure, up_m }), 2 * radius_m) > ROUND_PX;
      const of = is_round ? this.near : this.far;
      of.part.position.copy(at_place({ ...structure, up_m: bottom_m + high_m / 2 }));
      of.part.scale.set(radius_m, high_m, radius_m);
      of.add(top_m > 2 ? PAINT : STEEL, structure.name);
    }
    this.near.end();
    this.far.end();
  }
}
