// Who passes by, on the plan: a vessel, where it will be in a minute, and whom it comes near.
import { colours } from '../look/palette';
import { metres_text, speed_text, type SpeedUnit } from '../look/units';
import type { Session } from '../session/state';
import type { Camera } from './camera';
import { circle, label, line, type Context } from './draw';

const LEAST_LENGTH_PX = 16;
const AHEAD_S = 60;

export function draw_traffic(
  context: Context,
  camera: Camera,
  session: Session,
  speed_unit: SpeedUnit,
): void {
  const c = colours();
  const alarms = new Set([...session.alarms.values()].map((it) => it.with));
  for (const vessel of session.vessels) {
    const at = camera.to_pixel(vessel);
    const is_near = alarms.has(vessel.name);
    const colour = is_near ? c.alarm : c.ink;
    const course_rad = ((vessel.course_deg ?? 0) * Math.PI) / 180;
    const length = Math.max(LEAST_LENGTH_PX, (vessel.length_m ?? 0) * camera.pixels_per_metre);
    const way_m = vessel.speed_m_s * AHEAD_S;
    const then = camera.to_pixel({
      east_m: vessel.east_m + way_m * Math.sin(course_rad),
      north_m: vessel.north_m + way_m * Math.cos(course_rad),
    });
    line(context, [at, then], colour, 1.5, [10, 4]);
    circle(context, then, 2.5, colour, 1.5);
    context.save();
    context.translate(at.x, at.y);
    context.rotate(course_rad);
    context.beginPath();
    context.moveTo(0, -length / 2);
    context.lineTo(length * 0.22, -length * 0.2);
    context.lineTo(length * 0.22, length / 2);
    context.lineTo(-length * 0.22, length / 2);
    context.lineTo(-length * 0.22, -length * 0.2);
    context.closePath();
    context.fillStyle = c.paper;
    context.fill();
    context.strokeStyle = colour;
    context.lineWidth = is_near ? 3 : 1.8;
    context.stroke();
    context.restore();
    label(
      context,
      `${vessel.name} · ${speed_text(vessel.speed_m_s, speed_unit)}`,
      { x: at.x + length / 2 + 6, y: at.y + 14 },
      colour,
      'left',
      is_near,
    );
  }
}

/** The circles that noisy work and its watch are about. */
export function draw_zones(context: Context, camera: Camera, session: Session): void {
  const c = colours();
  const drawn = new Set<string>();
  for (const { zone } of session.vehicles.values()) {
    if (zone === null) continue;
    const key = `${zone.east_m} ${zone.north_m} ${zone.radius_m}`;
    if (drawn.has(key)) continue;
    drawn.add(key);
    const at = camera.to_pixel(zone);
    const radius = zone.radius_m * camera.pixels_per_metre;
    circle(context, at, radius, c.amber, 1.8, [2, 6]);
    label(
      context,
      `watched for animals, ${metres_text(zone.radius_m)}`,
      { x: at.x, y: at.y - radius - 8 },
      c.amber,
      'center',
    );
  }
}
