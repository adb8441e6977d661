// Where one looks from. Dragging or the arrow keys turn, the wheel or plus and minus come closer.
import { MathUtils, PerspectiveCamera, Vector3 } from 'three';
import type { CameraPointing } from '../session/message';
import type { Pose } from '../session/frame';
import { at_place, turned } from './axes';
import { CAMERA_FIELD_RAD } from '../view/vehicle_shape';

export type Stand = 'follow' | 'free' | 'on_board' | 'above';

const NEAREST_M = 1;
const FARTHEST_M = 4000;
const FIELD_DEG = 55;

export class Eye {
  readonly camera = new PerspectiveCamera(FIELD_DEG, 1, 0.1, 20_000);
  stand: Stand = 'follow';
  private turn_rad = 0.6;
  private lift_rad = 0.25;
  private away_m = 12;
  private readonly about = new Vector3();

  turn(right_rad: number, up_rad: number): void {
    this.turn_rad -= right_rad;
    this.lift_rad = MathUtils.clamp(this.lift_rad + up_rad, -1.45, 1.45);
  }

  closer(factor: number): void {
    this.away_m = MathUtils.clamp(this.away_m / factor, NEAREST_M, FARTHEST_M);
  }

  come_within(away_m: number): void {
    this.away_m = Math.min(this.away_m, Math.max(NEAREST_M, away_m));
  }

  /** What it looks at, and how far about that is in view. */
  looks_at(): { about: Vector3; reach_m: number } {
    return { about: this.about, reach_m: 0.7 * this.away_m };
  }

  /** All of it in view. */
  see_all(places: readonly Vector3[]): void {
    this.about.set(0, 0, 0);
    for (const place of places) this.about.addScaledVector(place, 1 / places.length);
    const reach = Math.max(10, ...places.map((place) => place.distanceTo(this.about)));
    this.away_m = Math.min(FARTHEST_M, 2.2 * reach);
    this.lift_rad = Math.max(this.lift_rad, 0.2);
    this.stand = 'free';
  }

  place(chosen: Pose | undefined, pointing: CameraPointing | null, length_m: number): void {
    const { camera } = this;
    camera.fov = FIELD_DEG;
    if (chosen !== undefined && this.stand !== 'free') this.about.copy(at_place(chosen));
    if (this.stand === 'on_board' && chosen !== undefined) {
      camera.rotation.copy(turned(chosen));
      camera.position.copy(this.about);
      if (pointing !== null) {
        camera.rotateY(-MathUtils.degToRad(pointing.pan_deg));
        camera.rotateX(MathUtils.degToRad(pointing.tilt_deg));
        const field = 2 * Math.atan(Math.tan(CAMERA_FIELD_RAD / 2) / pointing.zoom);
        camera.fov = MathUtils.radToDeg(2 * Math.atan(Math.tan(field / 2) / camera.aspect));
      }
      camera.translateZ(-0.55 * length_m);
    } else {
      const lift = this.stand === 'above' ? Math.PI / 2 - 1e-3 : this.lift_rad;
      const turn = this.stand === 'above' ? 0 : this.turn_rad;
      camera.position
        .set(Math.sin(turn) * Math.cos(lift), Math.sin(lift), Math.cos(turn) * Math.cos(lift))
        .multiplyScalar(this.away_m)
        .add(this.about);
      camera.lookAt(this.about);
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}
