// Small drawings that both views use.
import { colours } from '../look/palette';
import type { Pixel } from './camera';

export type Context = CanvasRenderingContext2D;
export const FONT = '12px system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';

/** Words on paper of their own colour, so that no line runs through them. */
export function label(
  context: Context,
  text: string,
  at: Pixel,
  colour: string,
  align: CanvasTextAlign = 'left',
  bold = false,
): void {
  context.font = bold ? `600 ${FONT}` : FONT;
  context.textAlign = align;
  context.textBaseline = 'middle';
  context.lineWidth = 4;
  context.lineJoin = 'round';
  context.strokeStyle = colours().paper;
  context.strokeText(text, at.x, at.y);
  context.fillStyle = colour;
  context.fillText(text, at.x, at.y);
}

export function line(
  context: Context,
  points: readonly Pixel[],
  colour: string,
  width = 1.5,
  dash: number[] = [],
): void {
  const [first, ...others] = points;
  if (first === undefined) return;
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  context.moveTo(first.x, first.y);
  for (const point of others) context.lineTo(point.x, point.y);
  context.stroke();
  context.setLineDash([]);
}

export function circle(
  context: Context,
  at: Pixel,
  radius: number,
  colour: string,
  width = 1.5,
  dash: number[] = [],
): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  context.arc(at.x, at.y, Math.max(0, radius), 0, 2 * Math.PI);
  context.stroke();
  context.setLineDash([]);
}

/** From `from` over (right, down) pixels, with a head. */
export function arrow(
  context: Context,
  from: Pixel,
  right: number,
  down: number,
  colour: string,
  width = 2,
): void {
  const size = Math.hypot(right, down);
  if (size < 3) return;
  const to = { x: from.x + right, y: from.y + down };
  const [ux, uy] = [right / size, down / size];
  const head = Math.min(8, size * 0.5);
  line(context, [from, to], colour, width);
  line(
    context,
    [
      { x: to.x - head * ux - head * 0.5 * uy, y: to.y - head * uy + head * 0.5 * ux },
      to,
      { x: to.x - head * ux + head * 0.5 * uy, y: to.y - head * uy - head * 0.5 * ux },
    ],
    colour,
    width,
  );
}
