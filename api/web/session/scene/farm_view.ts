// The turbines of the site: towers, nacelles that face the wind, rotors that turn as fast as the
// twin says, and the wakes behind them, the darker the less they leave of the wind.
import {
  Color,
  DoubleSide,
  Group,
  InstancedMesh,
  MeshBasicMaterial,
  MultiplyBlending,
  Object3D,
  PlaneGeometry,
  type Vector3,
} from 'three';
import type { Weather } from '../session/around';
import { BEHIND_DIAMETERS, type FarmNow, type Turbines } from '../session/farm';
import { at_place } from './axes';
import { set_all_about } from './met';
import { FAR, NEAR, TurbineBodies } from './turbine_bodies';

const NEAR_DIAMETERS = 8;

export class FarmView {
  readonly group = new Group();
  private readonly near: TurbineBodies;
  private readonly far: TurbineBodies;
  private readonly wakes: InstancedMesh<PlaneGeometry, MeshBasicMaterial>[];
  private readonly turned_rad: number[];
  private faces_rad = 0;
  private time_s: number | null = null;
  private readonly part = new Object3D();

  constructor(private readonly turbines: Turbines) {
    const { rotor_diameter_m, places } = turbines;
    this.near = new TurbineBodies(this.group, turbines, NEAR);
    this.far = new TurbineBodies(this.group, turbines, FAR);
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
      return new InstancedMesh<PlaneGeometry, MeshBasicMaterial>(strip, air, places.length);
    });
    for (const wake of this.wakes) {
      wake.frustumCulled = false; // its box is of one of them
      this.group.add(wake);
    }
    this.group.name = 'turbines';
    set_all_about(this.group);
  }

  /** At a time of the run. How far round a rotor is nobody tells, only how fast it turns. */
  show(weather: Weather | null, time_s: number, with_wakes: boolean, eye: Vector3): void {
    const { hub_height_m, rotor_diameter_m, places } = this.turbines;
    const farm: FarmNow | null = weather?.farm ?? null;
    const passed_s = this.time_s === null ? 0 : Math.max(0, time_s - this.time_s);
    this.time_s = time_s;
    // A rotor looks into the wind: its axis -z towards where it comes from. In a calm it stays.
    const from_deg = weather?.hub_wind_from_deg ?? null;
    if (from_deg !== null) this.faces_rad = (-from_deg * Math.PI) / 180;
    const { part, near, far, faces_rad } = this;
    const shade = new Color();
    near.begin();
    far.begin();
    places.forEach((place, nth) => {
      const now = farm?.each[nth];
      const on_rad = passed_s * (now?.rotor_speed_rad_s ?? 0);
      const turned_rad = (this.turned_rad[nth]! + on_rad) % (2 * Math.PI);
      this.turned_rad[nth] = turned_rad;
      part.position.copy(at_place({ ...place, up_m: hub_height_m }));
      const is_near = part.position.distanceTo(eye) < NEAR_DIAMETERS * rotor_diameter_m;
      (is_near ? near : far).add(part.position, faces_rad, turned_rad);
      part.rotation.set(0, faces_rad, 0);
      this.wakes.forEach((wake, i) => {
        const lost = with_wakes ? 1 - (now?.wind_left[i] ?? 1) : 0;
        part.scale.setScalar(lost > 0.01 ? 1 : 0);
        part.updateMatrix();
        wake.setMatrixAt(nth, part.matrix);
        wake.setColorAt(nth, shade.setScalar(1 - lost));
      });
    });
    near.end();
    far.end();
    for (const wake of this.wakes) {
      wake.visible = with_wakes && farm !== null;
      wake.instanceMatrix.needsUpdate = true;
      if (wake.instanceColor !== null) wake.instanceColor.needsUpdate = true;
    }
  }

  dispose(): void {
    this.near.dispose();
    this.far.dispose();
    for (const wake of this.wakes) {
      wake.geometry.dispose();
      wake.material.dispose();
      wake.dispose();
    }
  }
}
