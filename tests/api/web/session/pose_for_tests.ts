import type { Pose } from 'page/session/frame';

/** At rest at the origin, but for what is told. */
export function pose_with(more: Partial<Pose>): Pose {
  return {
    vehicle: 0,
    east_m: 0,
    north_m: 0,
    up_m: 0,
    roll_rad: 0,
    pitch_rad: 0,
    heading_rad: 0,
    east_m_s: 0,
    north_m_s: 0,
    up_m_s: 0,
    current_east_m_s: 0,
    current_north_m_s: 0,
    bed_m: null,
    charge: null,
    halted: false,
    ...more,
  };
}
