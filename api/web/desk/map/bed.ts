// Depth contours of the store's bathymetry, beneath all else on the map.
import type { GeoProjection } from 'd3-geo';
import { drawn } from '../../look/element';
import { Refused, type Server } from '../server/server';
import type { Size } from './projection';

/** /sites/ID/bed, GeoJSON. */
export interface Bed {
  product: string;
  datum: string;
  attribution: string;
  features: {
    properties: { depth_m: number };
    geometry: { coordinates: [number, number][][] };
  }[];
}

/** The contours of a site, or why there are none. */
export async function fetch_bed(server: Server, site: string): Promise<Bed | string> {
  try {
    const bed = await server.get<Bed>(`/sites/${encodeURIComponent(site)}/bed`);
    return Array.isArray(bed.features) ? bed : 'The answer of the server has none.';
  } catch (problem) {
    if (!(problem instanceof Refused)) throw problem;
    return problem.detail;
  }
}

type Point = [number, number];
const LEAST_PX = 1; // nearer points are one
const LABEL_FROM_PX = 90; // shorter lines have none
const LABELS_APART_PX = 70;

export function draw_bed(at: SVGGElement, bed: Bed, to: GeoProjection, size: Size): void {
  const labels: { at: Point; text: string }[] = [];
  const shapes = bed.features.map(({ properties: { depth_m }, geometry }) => {
    const lines = geometry.coordinates.map((line) => on_screen(line, to));
    for (const line of lines) {
      const middle = middle_of(line.flatMap((end, i) => seen(line[i - 1], end, size)));
      if (middle === null) continue;
      const apart = labels.map(({ at: [x, y] }) => Math.hypot(x - middle[0], y - middle[1]));
      if (Math.min(Infinity, ...apart) < LABELS_APART_PX) continue;
      labels.push({ at: middle, text: `${depth_m} m` });
    }
    const shape = drawn('path', { class: 'contour', d: lines.map(path_of).join('') });
    shape.append(drawn('title', {}, `${depth_m} m below ${bed.datum}`));
    return shape;
  });
  at.replaceChildren(
    ...shapes,
    ...labels.map(({ at: [x, y], text }) => drawn('text', { class: 'depth', x, y: y + 4 }, text)),
  );
}

function on_screen(line: readonly Point[], to: GeoProjection): Point[] {
  const points: Point[] = [];
  line.forEach((point, i) => {
    const here = to(point);
    const last = points[points.length - 1];
    if (here === null) return;
    const is_end = i === line.length - 1;
    if (last !== undefined && !is_end) {
      if (Math.hypot(here[0] - last[0], here[1] - last[1]) < LEAST_PX) return;
    }
    points.push(here);
  });
  return points;
}

const path_of = (line: readonly Point[]): string =>
  line.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${x.toFixed(1)},${y.toFixed(1)}`).join('');

type Stretch = [Point, Point];

/** What of a stretch lies in the picture: none or one. */
function seen(from: Point | undefined, to: Point, { width, height }: Size): Stretch[] {
  if (from === undefined) return [];
  const [right, down] = [to[0] - from[0], to[1] - from[1]];
  let [first, last] = [0, 1];
  for (const [step, room] of [
    [-right, from[0]],
    [right, width - from[0]],
    [-down, from[1]],
    [down, height - from[1]],
  ] as const) {
    if (step === 0 && room < 0) return [];
    if (step < 0) first = Math.max(first, room / step);
    if (step > 0) last = Math.min(last, room / step);
  }
  if (first >= last) return [];
  const at = (share: number): Point => [from[0] + share * right, from[1] + share * down];
  return [[at(first), at(last)]];
}

/** Half the way along; null where that is too short for a label. */
function middle_of(stretches: readonly Stretch[]): Point | null {
  const length_px = ([[x, y], [right, down]]: Stretch): number => Math.hypot(right - x, down - y);
  const all_px = stretches.reduce((sum, it) => sum + length_px(it), 0);
  if (all_px < LABEL_FROM_PX) return null;
  let left_px = all_px / 2;
  for (const it of stretches) {
    const mine_px = length_px(it);
    if (left_px <= mine_px) {
      const share = left_px / mine_px;
      const [[x, y], [right, down]] = it;
      return [x + share * (right - x), y + share * (down - y)];
    }
    left_px -= mine_px;
  }
  return null;
}
