// What the vehicle's own conduct makes of a stick, in words.
import type { Shaped, Shaping, Vehicle } from '../session/message';

/** How fast full stick can be asked of it. */
export function stick_speed_m_s(vehicle: Vehicle | undefined): number {
  return vehicle?.most_speed_m_s ?? vehicle?.cruise_m_s ?? (vehicle === undefined ? 0 : 1);
}

/**
 * "slowed to the vehicle's 0.5 m/s, kept 0.8 m off"; where an answer has no number, that of the
 * vehicle.
 */
export function shaped_text(
  answered: Shaped,
  speed_text: (speed_m_s: number) => string,
  vehicle: Pick<Vehicle, 'most_speed_m_s' | 'stand_off_m' | 'fence_m'> | null = null,
): string {
  const told = (shaping: Shaping, own: number | null | undefined): Shaping =>
    shaping === true ? (own ?? true) : shaping;
  const shaped: Shaped = {
    speed: told(answered.speed, vehicle?.most_speed_m_s),
    stand_off: told(answered.stand_off, vehicle?.stand_off_m),
    fence: told(answered.fence, vehicle?.fence_m),
  };
  const parts: string[] = [];
  if (shaped.speed !== null) {
    parts.push(
      typeof shaped.speed === 'number'
        ? `slowed to the vehicle's ${speed_text(shaped.speed)}`
        : "slowed to the vehicle's most speed",
    );
  }
  if (shaped.stand_off !== null) {
    parts.push(
      typeof shaped.stand_off === 'number'
        ? `kept ${shaped.stand_off.toFixed(1)} m off`
        : 'kept off a structure',
    );
  }
  if (shaped.fence !== null) {
    parts.push(
      typeof shaped.fence === 'number'
        ? `kept inside the fence of ${shaped.fence.toFixed(0)} m`
        : 'kept inside the fence',
    );
  }
  return parts.join(', ');
}
