// A vehicle from above. Kinds are told apart by their shape, not by a colour.
import { colours } from '../look/palette';
import { line, type Context } from './draw';
import type { CameraPointing } from '../session/message';
import type { Pixel } from './camera';

const LEAST_LENGTH_PX = 20;
const CAMERA_REACH_PX = 60;
/** Of a camera that is not zoomed: as wide as those of small ROVs see under water. */
export const CAMERA_FIELD_RAD = 1.117;

/** Where its camera looks: a wedge as wide as its picture, shorter as it looks up or down. */
export function draw_camera(
  context: Context,
  at: Pixel,
  heading_rad: number,
  camera: CameraPointing,
): void {
  const { accent } = colours();
  const middle_rad = heading_rad + (camera.pan_deg * Math.PI) / 180;
  const half_rad = Math.atan(Math.tan(CAMERA_FIELD_RAD / 2) / camera.zoom);
  const reach = CAMERA_REACH_PX * Math.max(0.25, Math.cos((camera.tilt_deg * Math.PI) / 180));
  const edge = (angle_rad: number): Pixel => ({
    x: at.x + reach * Math.sin(angle_rad),
    y: at.y - reach * Math.cos(angle_rad),
  });
  line(
    context,
    [at, edge(middle_rad - half_rad), edge(middle_rad + half_rad), at],
    accent,
    1.2,
    [4, 3],
  );
}

export function draw_vehicle(
  context: Context,
  at: Pixel,
  kind: string,
  heading_rad: number,
  length_px: number,
  width_px: number,
  is_chosen: boolean,
  is_halted: boolean,
): void {
  const { ink, paper, accent, alarm } = colours();
  const grown = Math.max(1, LEAST_LENGTH_PX / Math.max(0.1, length_px));
  const half_length = (length_px * grown) / 2;
  const half_width = Math.max(6, (width_px * grown) / 2);
  context.save();
  context.translate(at.x, at.y);
  context.rotate(heading_rad);
  context.beginPath();
  if (kind.includes('uav')) {
    for (const angle of [45, 135, 225, 315]) {
      const [x, y] = [Math.sin((angle * Math.PI) / 180), -Math.cos((angle * Math.PI) / 180)];
      context.moveTo(0, 0);
      context.lineTo(x * half_length, y * half_length);
      context.moveTo(x * half_length + 4, y * half_length);
      context.arc(x * half_length, y * half_length, 4, 0, 2 * Math.PI);
    }
    context.moveTo(-4, 2);
    context.lineTo(0, -half_length);
    context.lineTo(4, 2);
  } else if (kind.includes('rov')) {
    context.rect(-half_width, -half_length, 2 * half_width, 2 * half_length);
    context.moveTo(-half_width, -half_length * 0.3);
    context.lineTo(0, -half_length);
    context.lineTo(half_width, -half_length * 0.3);
  } else if (kind.includes('auv')) {
    context.ellipse(0, 0, Math.max(5, half_width * 0.7), half_length, 0, 0, 2 * Math.PI);
    context.moveTo(-half_width, half_length * 0.9);
    context.lineTo(half_width, half_length * 0.9);
  } else {
    context.moveTo(0, -half_length);
    context.quadraticCurveTo(half_width * 1.2, -half_length * 0.4, half_width, half_length);
    context.lineTo(-half_width, half_length);
    context.quadraticCurveTo(-half_width * 1.2, -half_length * 0.4, 0, -half_length);
  }
  context.fillStyle = paper;
  context.fill();
  context.lineWidth = is_chosen ? 3 : 1.8;
  context.strokeStyle = is_halted ? alarm : is_chosen ? accent : ink;
  context.stroke();
  context.restore();
  // Where the bow looks, as far again as the vehicle is long.
  const bow = {
    x: at.x + Math.sin(heading_rad) * half_length,
    y: at.y - Math.cos(heading_rad) * half_length,
  };
  const ahead = {
    x: at.x + Math.sin(heading_rad) * (half_length + 12),
    y: at.y - Math.cos(heading_rad) * (half_length + 12),
  };
  line(context, [bow, ahead], is_chosen ? accent : ink, 2);
  if (is_halted) {
    line(
      context,
      [
        { x: at.x - 6, y: at.y - 6 },
        { x: at.x + 6, y: at.y + 6 },
      ],
      alarm,
      3,
    );
    line(
      context,
      [
        { x: at.x - 6, y: at.y + 6 },
        { x: at.x + 6, y: at.y - 6 },
      ],
      alarm,
      3,
    );
  }
}
