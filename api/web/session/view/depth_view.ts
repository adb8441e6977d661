// From the side: how deep each vehicle is, over the last minutes or over the distance from its
// home.
import { ready_canvas } from '../look/canvas';
import { colours } from '../look/palette';
import { level_text } from '../look/units';
import type { Session } from '../session/state';
import { round_below, type Pixel } from './camera';
import { label, line } from './draw';
import type { TrackPoint, Tracks } from './tracks';

export type Along = 'time' | 'distance';
const SHOWN_S = 180;

export interface DepthDrawing {
  session: Session;
  tracks: Tracks;
  chosen: number | null;
  along: Along;
}

export function draw_depth(canvas: HTMLCanvasElement, what: DepthDrawing): void {
  const ready = ready_canvas(canvas);
  if (ready === null) return;
  const { context, width, height } = ready;
  const { session, chosen, along } = what;
  const c = colours();
  context.fillStyle = c.paper;
  context.fillRect(0, 0, width, height);

  const origin = (chosen === null ? null : session.vehicles.get(chosen)?.home) ?? {
    east_m: 0,
    north_m: 0,
  };
  const now_s = session.run.time_s;
  const across = (point: TrackPoint): number =>
    along === 'time'
      ? point.time_s - now_s
      : Math.hypot(point.east_m - origin.east_m, point.north_m - origin.north_m);

  // With the place of this moment as the last point of each line.
  // Over distance only the chosen vehicle: the others have homes of their own.
  const shown = [...session.vehicles.values()].filter(
    (it) => along === 'time' || it.vehicle === chosen,
  );
  const lines = shown.map((vehicle) => {
    const pose = session.poses.get(vehicle.vehicle);
    const points = what.tracks
      .of(vehicle.vehicle)
      .filter((it) => along === 'distance' || it.time_s >= now_s - SHOWN_S);
    if (pose === undefined) return { vehicle, points };
    const bed_up_m = pose.bed_m === null ? null : pose.up_m - pose.bed_m;
    return { vehicle, points: [...points, { ...pose, time_s: now_s, bed_up_m }] };
  });
  const way = chosen === null ? [] : (session.statuses.get(chosen)?.waypoints ?? []);
  const levels = [
    0,
    ...lines.flatMap((it) => it.points.flatMap((p) => [p.up_m, p.bed_up_m ?? p.up_m])),
  ];
  if (along === 'distance') levels.push(...way.map((it) => it.up_m));
  const top_m = Math.max(2, ...levels) * 1.08 + 1;
  const bottom_m = Math.min(-5, ...levels) * 1.08 - 0.5;
  const left = 46;
  const right = width - 16;
  const way_m = way.map((it) => Math.hypot(it.east_m - origin.east_m, it.north_m - origin.north_m));
  const furthest = Math.max(20, ...way_m, ...lines.flatMap((it) => it.points.map(across)));
  const [from, to] = along === 'time' ? [-SHOWN_S, 0] : [0, furthest * 1.1];
  const upper = 10;
  const lower = height - 22;
  const pixel = (x: number, up_m: number): Pixel => ({
    x: left + ((x - from) / (to - from)) * (right - left),
    y: upper + ((top_m - up_m) / (top_m - bottom_m)) * (lower - upper),
  });

  const step_m = round_below(((top_m - bottom_m) * 45) / Math.max(46, lower - upper)) || 1;
  for (let up_m = Math.ceil(bottom_m / step_m) * step_m; up_m <= top_m; up_m += step_m) {
    const { y } = pixel(from, up_m);
    line(
      context,
      [
        { x: left, y },
        { x: right, y },
      ],
      Math.abs(up_m) < 1e-9 ? c.water : c.panel,
      1,
    );
    label(context, `${Math.abs(Math.round(up_m))}`, { x: left - 6, y }, c.quiet, 'right');
  }
  const sea = pixel(from, 0);
  line(context, [sea, { x: right, y: sea.y }], c.water, 2);
  label(context, 'sea', { x: right - 4, y: sea.y - 9 }, c.water, 'right');
  context.save();
  context.beginPath();
  context.rect(left, 0, right - left + 8, lower + 2);
  context.clip();

  if (along === 'distance') {
    for (const structure of session.structures) {
      const away_m = Math.hypot(
        structure.east_m - origin.east_m,
        structure.north_m - origin.north_m,
      );
      const high = pixel(away_m - structure.radius_m, structure.top_m);
      const low = pixel(away_m + structure.radius_m, structure.bottom_m);
      context.fillStyle = c.rule;
      context.fillRect(high.x, high.y, low.x - high.x, low.y - high.y);
      label(
        context,
        structure.name,
        { x: (high.x + low.x) / 2, y: Math.min(lower - 8, low.y - 8) },
        c.quiet,
        'center',
      );
    }
  }

  for (const { vehicle, points } of lines) {
    const is_chosen = vehicle.vehicle === chosen;
    if (is_chosen) {
      const bed = points.filter((it) => it.bed_up_m !== null);
      const ordered = along === 'distance' ? [...bed].sort((a, b) => across(a) - across(b)) : bed;
      const edge = ordered.map((it) => pixel(across(it), it.bed_up_m ?? 0));
      const [first, last] = [edge[0], edge[edge.length - 1]];
      if (first !== undefined && last !== undefined && along === 'time') {
        context.fillStyle = c.bed;
        context.beginPath();
        context.moveTo(first.x, lower + 2);
        for (const it of edge) context.lineTo(it.x, it.y);
        context.lineTo(last.x, lower + 2);
        context.fill();
      }
      line(context, edge, c.quiet, 2);
      if (last !== undefined)
        label(
          context,
          'bed',
          { x: Math.max(left + 28, last.x - 4), y: last.y - 8 },
          c.quiet,
          'right',
        );
      if (along === 'distance') {
        const planned = way.map((it, i) => pixel(way_m[i] ?? 0, it.up_m));
        line(context, planned, c.accent, 1.5, [6, 4]);
      }
    }
    line(
      context,
      points.map((it) => pixel(across(it), it.up_m)),
      is_chosen ? c.accent : c.quiet,
      is_chosen ? 2.5 : 1.2,
    );
    const last = points[points.length - 1];
    if (last !== undefined && (is_chosen || along === 'time')) {
      const at = pixel(across(last), last.up_m);
      context.fillStyle = is_chosen ? c.accent : c.quiet;
      context.beginPath();
      context.arc(at.x, at.y, is_chosen ? 5 : 3, 0, 2 * Math.PI);
      context.fill();
      if (is_chosen) {
        const is_late = at.x > width - 180;
        const is_afloat = Math.abs(last.up_m) < 0.1 * (top_m - bottom_m);
        const words = {
          x: at.x + (is_late ? -10 : 10),
          y: is_afloat ? at.y + 15 : Math.max(upper + 8, at.y - 12),
        };
        label(
          context,
          `${vehicle.name} · ${level_text(last.up_m)}`,
          words,
          c.accent,
          is_late ? 'right' : 'left',
          true,
        );
      }
    }
  }
  context.restore();
  label(context, 'm', { x: left - 6, y: height - 10 }, c.quiet, 'right');
  if (along === 'time') {
    for (const ago_s of [180, 120, 60, 0]) {
      const align = ago_s === 0 ? 'right' : ago_s === 180 ? 'left' : 'center';
      const words = ago_s === 0 ? 'now' : `${ago_s / 60} min ago`;
      label(context, words, { x: pixel(-ago_s, 0).x, y: height - 10 }, c.quiet, align);
    }
  } else {
    const step = round_below((to * 110) / Math.max(111, right - left)) || 1;
    for (let x = 0; pixel(x, 0).x < right - 100; x += step)
      label(context, `${x}`, { x: pixel(x, 0).x, y: height - 10 }, c.quiet, 'center');
    label(context, 'm from home', { x: right, y: height - 10 }, c.quiet, 'right');
  }
}
