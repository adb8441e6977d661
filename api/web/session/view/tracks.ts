// Where each vehicle has been while this page looked on: a point a second of the run, half an hour
// at most.
import type { Frame } from '../session/frame';

export interface TrackPoint {
  time_s: number;
  east_m: number;
  north_m: number;
  up_m: number;
  bed_up_m: number | null;
}

const POINTS_KEPT = 1800;
const APART_S = 1;

export class Tracks {
  private points = new Map<number, TrackPoint[]>();

  take(frame: Frame): void {
    for (const pose of frame.poses) {
      let track = this.points.get(pose.vehicle);
      if (track === undefined) this.points.set(pose.vehicle, (track = []));
      const last = track[track.length - 1];
      if (last !== undefined && frame.time_s < last.time_s)
        track.length = 0; // the run began again
      else if (last !== undefined && frame.time_s - last.time_s < APART_S) continue;
      track.push({
        time_s: frame.time_s,
        east_m: pose.east_m,
        north_m: pose.north_m,
        up_m: pose.up_m,
        bed_up_m: pose.bed_m === null ? null : pose.up_m - pose.bed_m,
      });
      if (track.length > POINTS_KEPT) track.splice(0, track.length - POINTS_KEPT);
    }
  }

  of(vehicle: number): readonly TrackPoint[] {
    return this.points.get(vehicle) ?? [];
  }

  clear(): void {
    this.points.clear();
  }
}
