// The turbines of the site: towers, nacelles that face the wind, rotors that turn as fast as the
// twin says, and the wakes behind them, the darker the less they leave of the wind.
import {
  BoxGeometry,
  BufferGeometry,
  Color,
  CylinderGeometry,
  DoubleSide,
  Group,
  InstancedMesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MultiplyBlending,
  Object3D,
  PlaneGeometry,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Weather } from '../session/around';
import { BEHIND_DIAMETERS, type FarmNow, type Turbines } from '../session/farm';
import { at_place } from './axes';

const WHITE = new MeshLambertMaterial({ color: '#e8eaec' });
// Of a turbine of 126 m diameter (NREL 5 MW), in proportion for others.
const [USUAL_DIAMETER_M, TOWER_RADIUS_M, NACELLE_M] = [126, 2.5, [5, 5, 14] as const];

/** Three blades about the axis -z, the first upright. */
function rotor_of(diameter_m: number): BufferGeometry {
  const size = diameter_m / USUAL_DIAMETER_M;
  const long = diameter_m / 2;
  const blades = [0, 1, 2].map((nth) => {
    const blade = new BoxGeometry(3.2 * size, long, 0.6 * size, 1, 4);
    blade.translate(0, long / 2, 0);
    const at = blade.getAttribute('position');
    // Narrower to the tip.
    for (let i = 0; i < at.count; i += 1) at.setX(i, at.getX(i) * (1 - (0.75 * at.getY(i)) / long));
    blade.rotateZ((-2 * Math.PI * nth) / 3);
    return blade;
  });
  const hub = new CylinderGeometry(1.6 * size, 1.6 * size, 3 * size, 12);
  hub.rotateX(Math.PI / 2);
  return mergeGeometries([...blades, hub]);
}

export class FarmView {
  readonly group = new Group();
  private readonly towers: InstancedMesh;
  private readonly nacelles: InstancedMesh;
  private readonly rotors: InstancedMesh;
  private readonly wakes: InstancedMesh<PlaneGeometry, MeshBasicMaterial>[];
  private readonly turned_rad: number[];
  private time_s: number | null = null;
  private readonly part = new Object3D();

  constructor(private readonly turbines: Turbines) {
    const { hub_height_m, rotor_diameter_m, places } = turbines;
    const size = rotor_diameter_m / USUAL_DIAMETER_M;
    const foot_m = TOWER_RADIUS_M * size;
    const tower = new CylinderGeometry(0.65 * foot_m, foot_m, hub_height_m, 16);
    tower.translate(0, hub_height_m / 2, 0); // from the sea up: its foundation is wider
    const nacelle = new BoxGeometry(...NACELLE_M);
    nacelle.scale(size, size, size);
    nacelle.translate(0, 0, (NACELLE_M[2] / 2) * size);
    const many = places.length;
    this.towers = new InstancedMesh(tower, WHITE, many);
    this.nacelles = new InstancedMesh(nacelle, WHITE, many);
    this.rotors = new InstancedMesh(rotor_of(rotor_diameter_m), WHITE, many);
    this.turned_rad = places.map(() => 0);
    let from = 0;
    this.wakes = BEHIND_DIAMETERS.map((to) => {
      const strip = new PlaneGeometry(1.2 * rotor_diameter_m, (to - from) * rotor_diameter_m);
      strip.rotateX(-Math.PI / 2);
      strip.translate(0, 0, ((from + to) / 2) * rotor_diameter_m);
      from = to;
      // What is behind a wake is as much darker as it leaves less of the wind.
      const air = new MeshBasicMaterial({
        blending: MultiplyBlending,
        premultipliedAlpha: true,
        transparent: true,
        side: DoubleSide,
        depthWrite: false,
        fog: false,
      });
      return new InstancedMesh(strip, air, many);
    });
    for (const mesh of [this.towers, this.nacelles, this.rotors, ...this.wakes]) {
      mesh.frustumCulled = false; // their boxes are of one turbine
      this.group.add(mesh);
    }
    places.forEach((place, nth) => {
      this.part.position.copy(at_place({ ...place, up_m: 0 }));
      this.part.updateMatrix();
      this.towers.setMatrixAt(nth, this.part.matrix);
    });
    this.group.name = 'turbines';
  }

  /** At a time of the run. How far round a rotor is nobody tells, only how fast it turns. */
  show(weather: Weather | null, time_s: number, with_wakes: boolean): void {
    const { hub_height_m, places } = this.turbines;
    const farm: FarmNow | null = weather?.farm ?? null;
    const passed_s = this.time_s === null ? 0 : Math.max(0, time_s - this.time_s);
    this.time_s = time_s;
    // A rotor looks into the wind: its axis -z towards where it comes from.
    const faces_rad = -((weather?.hub_wind_from_deg ?? 0) * Math.PI) / 180;
    const { part } = this;
    const shade = new Color();
    places.forEach((place, nth) => {
      const now = farm?.each[nth];
      const on_rad = passed_s * (now?.rotor_speed_rad_s ?? 0);
      const turned_rad = (this.turned_rad[nth]! + on_rad) % (2 * Math.PI);
      this.turned_rad[nth] = turned_rad;
      part.position.copy(at_place({ ...place, up_m: hub_height_m }));
      part.rotation.set(0, faces_rad, 0);
      part.scale.setScalar(1);
      part.updateMatrix();
      this.nacelles.setMatrixAt(nth, part.matrix);
      // Clockwise for who stands upwind and looks at it, so against the clock about its -z.
      part.rotation.set(0, faces_rad, turned_rad, 'YXZ');
      part.updateMatrix();
      this.rotors.setMatrixAt(nth, part.matrix);
      part.rotation.set(0, faces_rad, 0);
      this.wakes.forEach((wake, i) => {
        const lost = with_wakes ? 1 - (now?.wind_left[i] ?? 1) : 0;
        part.scale.setScalar(lost > 0.01 ? 1 : 0);
        part.updateMatrix();
        wake.setMatrixAt(nth, part.matrix);
        wake.setColorAt(nth, shade.setScalar(1 - lost));
      });
    });
    for (const mesh of [this.towers, this.nacelles, this.rotors, ...this.wakes])
      mesh.instanceMatrix.needsUpdate = true;
    for (const wake of this.wakes) {
      wake.visible = with_wakes && farm !== null;
      if (wake.instanceColor !== null) wake.instanceColor.needsUpdate = true;
    }
  }

  dispose(): void {
    for (const mesh of [this.towers, this.nacelles, this.rotors, ...this.wakes]) {
      mesh.geometry.dispose();
      mesh.dispose();
    }
  }
}
