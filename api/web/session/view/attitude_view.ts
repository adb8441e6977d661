// A small horizon: how the chosen vehicle rolls and pitches.
import { ready_canvas } from '../look/canvas';
import { colours } from '../look/palette';
import { line } from './draw';

export function draw_attitude(
  canvas: HTMLCanvasElement,
  roll_rad: number,
  pitch_rad: number,
): void {
  const ready = ready_canvas(canvas);
  if (ready === null) return;
  const { context, width, height } = ready;
  const c = colours();
  const middle = { x: width / 2, y: height / 2 };
  const radius = Math.min(width, height) / 2 - 2;
  context.save();
  context.beginPath();
  context.arc(middle.x, middle.y, radius, 0, 2 * Math.PI);
  context.clip();
  context.fillStyle = c.paper;
  context.fillRect(0, 0, width, height);
  context.translate(middle.x, middle.y);
  context.rotate(-roll_rad);
  const horizon = Math.max(-1, Math.min(1, pitch_rad / 0.8)) * radius;
  context.fillStyle = c.bed;
  context.fillRect(-width, horizon, 2 * width, 2 * height);
  line(
    context,
    [
      { x: -width, y: horizon },
      { x: width, y: horizon },
    ],
    c.ink,
    1.5,
  );
  context.restore();
  line(
    context,
    [
      { x: middle.x - radius * 0.6, y: middle.y },
      { x: middle.x - 5, y: middle.y },
    ],
    c.accent,
    3,
  );
  line(
    context,
    [
      { x: middle.x + 5, y: middle.y },
      { x: middle.x + radius * 0.6, y: middle.y },
    ],
    c.accent,
    3,
  );
  context.strokeStyle = c.quiet;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(middle.x, middle.y, radius, 0, 2 * Math.PI);
  context.stroke();
}
