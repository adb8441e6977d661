// Goes along with a vehicle, and does not turn with it.
import type { Vector3 } from 'three';
import { at_place } from '../scene/axes';
import type { Pose } from '../session/frame';

const FELT_FROM_M_S = 0.05;

export class Ride {
  private on: { vehicle: number; at: Vector3 } | null = null;

  get is_on(): boolean {
    return this.on !== null;
  }
  begin(pose: Pose): void {
    this.on = { vehicle: pose.vehicle, at: at_place(pose) };
  }
  end(): void {
    this.on = null;
  }

  /** How far it went since the last step; null: nobody rides. A vehicle that is gone ends it. */
  step(poses: ReadonlyMap<number, Pose>): Vector3 | null {
    const pose = this.on === null ? undefined : poses.get(this.on.vehicle);
    if (this.on === null || pose === undefined) {
      this.end();
      return null;
    }
    const at = at_place(pose);
    const by = at.clone().sub(this.on.at);
    this.on.at = at;
    return by;
  }

  /** Frames of the headset come between those of the vehicle: its speed tells, not each step. */
  is_felt(poses: ReadonlyMap<number, Pose>): boolean {
    const pose = this.on === null ? undefined : poses.get(this.on.vehicle);
    return pose !== undefined && speed_m_s(pose) > FELT_FROM_M_S;
  }
}

const speed_m_s = (pose: Pose): number => Math.hypot(pose.east_m_s, pose.north_m_s, pose.up_m_s);
