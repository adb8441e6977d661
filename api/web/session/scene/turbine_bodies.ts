// The bodies of turbines, round and twisted from near, with few faces from afar.
import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  MathUtils,
  MeshLambertMaterial,
  type Object3D,
  type Vector3,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Turbines } from '../session/farm';
import { Instances } from './instances';

export interface Detail {
  sides: number; // of a tower
  parts: number; // along a blade
}
export const NEAR: Detail = { sides: 48, parts: 16 };
export const FAR: Detail = { sides: 8, parts: 2 };

const WHITE = new MeshLambertMaterial({ color: '#e8eaec' });
// Of a turbine of 126 m diameter (NREL 5 MW), in proportion for others.
const [USUAL_DIAMETER_M, TOWER_RADIUS_M, NACELLE_M] = [126, 2.5, [5, 5, 14] as const];
const TWIST_DEG = 13; // of a blade's root against its tip

/** Three blades about the axis -z, the first upright. */
function rotor_of(diameter_m: number, { parts }: Detail): BufferGeometry {
  const size = diameter_m / USUAL_DIAMETER_M;
  const long = diameter_m / 2;
  const blades = [0, 1, 2].map((nth) => {
    const blade = new BoxGeometry(3.2 * size, long, 0.6 * size, 1, parts);
    blade.translate(0, long / 2, 0);
    const at = blade.getAttribute('position');
    // Narrower to the tip, and turned less.
    for (let i = 0; i < at.count; i += 1) {
      const out = at.getY(i) / long;
      const twist = MathUtils.degToRad(TWIST_DEG * (1 - out) ** 2);
      const [x, z] = [at.getX(i) * (1 - 0.75 * out), at.getZ(i) * (1 - 0.75 * out)];
      at.setX(i, x * Math.cos(twist) - z * Math.sin(twist));
      at.setZ(i, x * Math.sin(twist) + z * Math.cos(twist));
    }
    blade.rotateZ((-2 * Math.PI * nth) / 3);
    return blade;
  });
  const hub = new ConeGeometry(1.6 * size, 3 * size, parts > 2 ? 24 : 6);
  hub.rotateX(-Math.PI / 2);
  const made = mergeGeometries([...blades, hub]);
  made.computeVertexNormals();
  return made;
}

function nacelle_of(size: number, { parts }: Detail): BufferGeometry {
  const [wide, high, long] = NACELLE_M;
  const made =
    parts > 2
      ? new CapsuleGeometry(wide / 2, long - wide, 8, 24)
      : new BoxGeometry(wide, long, high);
  made.rotateX(Math.PI / 2);
  made.scale(size, size, size);
  made.translate(0, 0, (long / 2) * size);
  return made;
}

export class TurbineBodies {
  private readonly towers: Instances;
  private readonly nacelles: Instances;
  private readonly rotors: Instances;

  constructor(group: Object3D, { hub_height_m, rotor_diameter_m }: Turbines, detail: Detail) {
    const size = rotor_diameter_m / USUAL_DIAMETER_M;
    const foot_m = TOWER_RADIUS_M * size;
    const tower = new CylinderGeometry(0.65 * foot_m, foot_m, hub_height_m, detail.sides);
    tower.translate(0, -hub_height_m / 2, 0); // from the sea up: its foundation is wider
    this.towers = new Instances(group, tower, WHITE);
    this.nacelles = new Instances(group, nacelle_of(size, detail), WHITE);
    this.rotors = new Instances(group, rotor_of(rotor_diameter_m, detail), WHITE, 'rotors');
  }

  private each(): Instances[] {
    return [this.towers, this.nacelles, this.rotors];
  }
  begin(): void {
    for (const of of this.each()) of.begin();
  }
  add(hub: Vector3, faces_rad: number, turned_rad: number): void {
    for (const of of this.each()) of.part.position.copy(hub);
    this.nacelles.part.rotation.set(0, faces_rad, 0);
    // Clockwise for who stands upwind and looks at it, so against the clock about its -z.
    this.rotors.part.rotation.set(0, faces_rad, turned_rad, 'YXZ');
    for (const of of this.each()) of.add();
  }
  end(): void {
    for (const of of this.each()) of.end();
  }
  dispose(): void {
    for (const of of this.each()) of.dispose();
  }
}
