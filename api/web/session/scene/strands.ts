// Cables and mooring lines: thin lines from afar, rods one can go along from near; dashed where
// they are buried.
import {
  BufferAttribute,
  BufferGeometry,
  CylinderGeometry,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  MeshBasicMaterial,
  Vector3,
  type Object3D,
} from 'three';
import { Instances } from './instances';

export interface Strand {
  through: Vector3[];
  is_dashed: boolean;
}

const [DASH_M, GAP_M] = [6, 4];
const NEAR_M = 60;
const ANEW_M = 5; // as far as the eye goes before rods are laid anew
const RADIUS_M = 0.1; // nobody tells how thick they are

/** Pairs of ends, and how far along its strand each end is. */
function lines_of(strands: readonly Strand[]): BufferGeometry {
  const ends: Vector3[] = [];
  const along: number[] = [];
  for (const { through } of strands) {
    let far_m = 0;
    for (let i = 1; i < through.length; i += 1) {
      const [from, to] = [through[i - 1]!, through[i]!];
      const long_m = from.distanceTo(to);
      ends.push(from, to);
      along.push(far_m, far_m + long_m);
      far_m += long_m;
    }
  }
  const made = new BufferGeometry().setFromPoints(ends);
  made.setAttribute('lineDistance', new BufferAttribute(Float32Array.from(along), 1));
  return made;
}

/** Pieces of a strand near a place; of a dashed one its dashes. */
export function pieces_near({ through, is_dashed }: Strand, about: Vector3): [Vector3, Vector3][] {
  const made: [Vector3, Vector3][] = [];
  const period_m = is_dashed ? DASH_M + GAP_M : DASH_M;
  let far_m = 0;
  for (let i = 1; i < through.length; i += 1) {
    const [from, to] = [through[i - 1]!, through[i]!];
    const way = to.clone().sub(from);
    const long_m = way.length();
    const [begin_m, end_m] = [far_m, far_m + long_m];
    far_m = end_m;
    if (long_m < 1e-6) continue;
    way.divideScalar(long_m);
    // Only what can be near, however long the whole is.
    const abreast_m = about.clone().sub(from).dot(way);
    const first_m = begin_m + Math.max(0, abreast_m - NEAR_M);
    const last_m = Math.min(end_m, begin_m + abreast_m + NEAR_M);
    for (let nth = Math.floor(first_m / period_m); nth * period_m < last_m; nth += 1) {
      const a_m = Math.max(begin_m, nth * period_m);
      const b_m = Math.min(end_m, nth * period_m + DASH_M);
      if (b_m - a_m < 1e-3) continue;
      const at = (m: number): Vector3 => from.clone().addScaledVector(way, m - begin_m);
      const piece: [Vector3, Vector3] = [at(a_m), at(b_m)];
      if (piece[0].distanceTo(about) < NEAR_M || piece[1].distanceTo(about) < NEAR_M)
        made.push(piece);
    }
  }
  return made;
}

export class Strands {
  readonly group = new Group();
  private readonly solid = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly dashed = new LineSegments(
    new BufferGeometry(),
    new LineDashedMaterial({ dashSize: DASH_M, gapSize: GAP_M }),
  );
  private readonly rod_paint = new MeshBasicMaterial();
  private readonly rods: Instances;
  private strands: readonly Strand[] = [];
  private laid_about: Vector3 | null = null;

  constructor(scene: Object3D) {
    const rod = new CylinderGeometry(RADIUS_M, RADIUS_M, 1, 8, 1);
    this.rods = new Instances(this.group, rod, this.rod_paint);
    for (const lines of [this.solid, this.dashed]) {
      lines.frustumCulled = false;
      this.group.add(lines);
    }
    scene.add(this.group);
  }

  lay(strands: readonly Strand[]): void {
    this.strands = strands;
    this.laid_about = null;
    this.solid.geometry.dispose();
    this.dashed.geometry.dispose();
    this.solid.geometry = lines_of(strands.filter((it) => !it.is_dashed));
    this.dashed.geometry = lines_of(strands.filter((it) => it.is_dashed));
  }

  show(eye: Vector3, colour: string): void {
    this.group.visible = this.strands.length > 0;
    for (const paint of [this.solid.material, this.dashed.material, this.rod_paint])
      paint.color.set(colour);
    if (this.laid_about !== null && eye.distanceTo(this.laid_about) < ANEW_M) return;
    this.laid_about = eye.clone();
    const { rods } = this;
    const up = new Vector3(0, 1, 0);
    rods.begin();
    for (const strand of this.strands)
      for (const [from, to] of pieces_near(strand, eye)) {
        const way = to.clone().sub(from);
        rods.part.position.copy(from).add(to).multiplyScalar(0.5);
        rods.part.scale.set(1, way.length(), 1);
        rods.part.quaternion.setFromUnitVectors(up, way.normalize());
        rods.add();
      }
    rods.end();
  }

  hide(): void {
    this.group.visible = false;
  }
}
