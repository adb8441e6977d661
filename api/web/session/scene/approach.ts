// Where a vehicle and a vessel that it is alarmed about come nearest, both going on as they go.
import type { Vessel } from '../session/around';
import type { Pose } from '../session/frame';
import type { Alarm } from '../session/message';
import type { Session } from '../session/state';
import type { Place } from './axes';

export interface Approach {
  vessel: string;
  in_s: number;
  distance_m: number;
  own: Place;
  others: Place;
}

/** Nothing where nobody tells when, or it is over. */
export function approach_of(alarm: Alarm, pose: Pose, vessel: Vessel): Approach | null {
  const in_s = alarm.cpa_s;
  if (in_s === null || in_s < 0 || alarm.cpa_m === null) return null;
  const course_rad = ((vessel.course_deg ?? 0) * Math.PI) / 180;
  return {
    vessel: vessel.name,
    in_s,
    distance_m: alarm.cpa_m,
    own: {
      east_m: pose.east_m + in_s * pose.east_m_s,
      north_m: pose.north_m + in_s * pose.north_m_s,
      up_m: pose.up_m,
    },
    others: {
      east_m: vessel.east_m + in_s * vessel.speed_m_s * Math.sin(course_rad),
      north_m: vessel.north_m + in_s * vessel.speed_m_s * Math.cos(course_rad),
      up_m: 0,
    },
  };
}

/** Of who comes too near. */
export function approaches_in(session: Session): Approach[] {
  const found: Approach[] = [];
  for (const alarm of session.alarms.values()) {
    const pose = session.poses.get(alarm.vehicle);
    const vessel = session.vessels.find((it) => it.name === alarm.with);
    const approach = pose && vessel ? approach_of(alarm, pose, vessel) : null;
    if (approach !== null) found.push(approach);
  }
  return found;
}
