// The plan: from above, north up. It draws what the server told, where the server said it is.
import { ready_canvas } from '../look/canvas';
import { colours } from '../look/palette';
import { level_text, metres_text, speed_text, type SpeedUnit } from '../look/units';
import type { Waypoint } from '../session/message';
import type { Session } from '../session/state';
import { Camera, round_below, type Pixel, type Plane } from './camera';
import { arrow, circle, label, line, type Context } from './draw';
import type { Tracks } from './tracks';
import { draw_traffic, draw_zones } from './traffic_view';
import { draw_camera, draw_vehicle } from './vehicle_shape';

const CURRENT_PIXELS_PER_M_S = 50;

export interface PlanDrawing {
  session: Session;
  tracks: Tracks;
  chosen: number | null;
  speed_unit: SpeedUnit;
  /** The list under edit, its place in hand, and whether the server would refuse it. */
  draft: {
    places: readonly Waypoint[];
    picked: number | null;
    is_refused: boolean;
    is_loop: boolean;
  } | null;
}

/** What takes a press before the plan pans. */
export interface PlanHand {
  press(at: Plane, pixel: Pixel): boolean;
  move(at: Plane): void;
  let_go(): void;
  click(at: Plane, pixel: Pixel): boolean;
}

export class PlanView {
  readonly camera = new Camera();
  follows = true;
  on_change: () => void = () => undefined;
  private was_fit = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly hand: PlanHand,
    private readonly on_choose: (pixel: Pixel) => void,
  ) {
    this.listen();
  }

  draw(what: PlanDrawing): void {
    const ready = ready_canvas(this.canvas);
    if (ready === null) return;
    const { context, width, height } = ready;
    const { session, chosen } = what;
    const camera = this.camera;
    camera.width = width;
    camera.height = height;
    if (!this.was_fit && session.poses.size > 0) {
      this.was_fit = true;
      this.fit_near(session, chosen);
    }
    const chosen_pose = chosen === null ? undefined : session.poses.get(chosen);
    if (this.follows && chosen_pose !== undefined) camera.look_at(chosen_pose);

    const c = colours();
    this.draw_grid(context, width, height);
    for (const structure of session.structures) {
      const at = camera.to_pixel(structure);
      const radius = Math.max(3, structure.radius_m * camera.pixels_per_metre);
      context.fillStyle = c.rule;
      context.beginPath();
      context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
      context.fill();
      circle(context, at, radius, c.ink, 1.5);
      if (radius > 7) label(context, structure.name, { x: at.x + radius + 5, y: at.y }, c.quiet);
    }

    for (const vehicle of session.vehicles.values()) {
      const is_chosen = vehicle.vehicle === chosen;
      const pose = session.poses.get(vehicle.vehicle);
      const track = what.tracks.of(vehicle.vehicle).map((it) => camera.to_pixel(it));
      if (pose !== undefined) track.push(camera.to_pixel(pose));
      line(context, track, is_chosen ? c.accent : c.quiet, is_chosen ? 1.8 : 1.2);

      if (vehicle.home !== null && is_chosen) {
        const home = camera.to_pixel(vehicle.home);
        line(
          context,
          [
            { x: home.x - 6, y: home.y },
            { x: home.x, y: home.y - 7 },
            { x: home.x + 6, y: home.y },
          ],
          c.ink,
          2,
        );
        line(
          context,
          [
            { x: home.x - 4, y: home.y },
            { x: home.x - 4, y: home.y + 6 },
            { x: home.x + 4, y: home.y + 6 },
            { x: home.x + 4, y: home.y },
          ],
          c.ink,
          2,
        );
        if (camera.pixels_per_metre > 1)
          label(context, 'home', { x: home.x + 9, y: home.y + 2 }, c.quiet);
        if (vehicle.fence_m !== null) {
          const radius = vehicle.fence_m * camera.pixels_per_metre;
          circle(context, home, radius, c.amber, 1.8, [9, 5]);
          label(
            context,
            `fence ${metres_text(vehicle.fence_m)}`,
            { x: home.x - radius * 0.707, y: home.y + radius * 0.707 },
            c.amber,
            'center',
          );
        }
      }
      if (vehicle.tether !== null) {
        const end = camera.to_pixel(vehicle.tether);
        if (pose !== undefined) line(context, [end, camera.to_pixel(pose)], c.ink, 1.2, [3, 3]);
        context.fillStyle = c.ink;
        context.fillRect(end.x - 3, end.y - 3, 6, 6);
        if (is_chosen)
          circle(
            context,
            end,
            vehicle.tether.length_m * camera.pixels_per_metre,
            c.quiet,
            1,
            [2, 5],
          );
      }
      const way = session.statuses.get(vehicle.vehicle)?.waypoints ?? [];
      if (!(is_chosen && what.draft !== null))
        this.draw_way(context, way, is_chosen ? c.accent : c.quiet, false);
    }
    draw_zones(context, camera, session);
    draw_traffic(context, camera, session, what.speed_unit);
    if (what.draft !== null) this.draw_draft(context, what.draft);

    for (const vehicle of session.vehicles.values()) {
      const pose = session.poses.get(vehicle.vehicle);
      if (pose === undefined) continue;
      const is_chosen = vehicle.vehicle === chosen;
      const at = camera.to_pixel(pose);
      draw_vehicle(
        context,
        at,
        vehicle.kind,
        pose.heading_rad,
        vehicle.length_m * camera.pixels_per_metre,
        vehicle.width_m * camera.pixels_per_metre,
        is_chosen,
        pose.halted,
      );
      const current_m_s = Math.hypot(pose.current_east_m_s, pose.current_north_m_s);
      if (Number.isFinite(current_m_s)) {
        const pixels =
          Math.min(1, 90 / (current_m_s * CURRENT_PIXELS_PER_M_S || 1)) * CURRENT_PIXELS_PER_M_S;
        const [right, down] = [pose.current_east_m_s * pixels, -pose.current_north_m_s * pixels];
        arrow(context, at, right, down, c.water, 2.5);
      }
      const camera_now = session.statuses.get(vehicle.vehicle)?.camera ?? null;
      if (is_chosen && camera_now !== null) draw_camera(context, at, pose.heading_rad, camera_now);
      // Its lean: where the top of a mast would be, seen from above.
      const [ahead, right] = [-Math.sin(pose.pitch_rad), Math.sin(pose.roll_rad)];
      const [s, k] = [Math.sin(pose.heading_rad), Math.cos(pose.heading_rad)];
      const mast = {
        x: at.x + 40 * (ahead * s + right * k),
        y: at.y - 40 * (ahead * k - right * s),
      };
      line(context, [at, mast], c.ink, 2);
      circle(context, mast, 2, c.ink, 2);

      const alarms = [...session.alarms.values()].filter((it) => it.vehicle === vehicle.vehicle);
      if (alarms.length > 0) circle(context, at, 26, c.alarm, 3);
      const words = is_chosen ? `${vehicle.name} · ${level_text(pose.up_m)}` : vehicle.name;
      label(
        context,
        words,
        { x: at.x + 20, y: at.y - 18 },
        is_chosen ? c.accent : c.ink,
        'left',
        is_chosen,
      );
      alarms.forEach((alarm, i) => {
        const pass = alarm.cpa_m === null ? '' : ` passes at ${metres_text(alarm.cpa_m)}`;
        const when = alarm.cpa_s === null ? '' : ` in ${Math.round(alarm.cpa_s)} s`;
        label(
          context,
          `${alarm.with}${pass}${when}`,
          { x: at.x + 32, y: at.y + 4 + 15 * i },
          c.alarm,
          'left',
          true,
        );
      });
    }
    this.draw_scale(context, width, height, what);
  }

  fit(session: Session): void {
    const places: Plane[] = [...session.poses.values(), ...session.structures];
    for (const vehicle of session.vehicles.values())
      if (vehicle.home !== null) places.push(vehicle.home);
    for (const status of session.statuses.values()) places.push(...status.waypoints);
    const far = places.filter((it) => Math.hypot(it.east_m, it.north_m) < 50_000);
    this.camera.fit(far);
  }

  /** The chosen vehicle, with what is of it or near it: where a pilot begins. */
  private fit_near(session: Session, chosen: number | null): void {
    const vehicle = chosen === null ? undefined : session.vehicles.get(chosen);
    const pose = chosen === null ? undefined : session.poses.get(chosen);
    if (vehicle === undefined || pose === undefined) {
      this.fit(session);
      return;
    }
    const near = (at: Plane): boolean =>
      Math.hypot(at.east_m - pose.east_m, at.north_m - pose.north_m) < 150;
    const places: Plane[] = [
      pose,
      ...session.structures,
      ...(session.statuses.get(vehicle.vehicle)?.waypoints ?? []),
    ];
    if (vehicle.home !== null) places.push(vehicle.home);
    if (vehicle.tether !== null) places.push(vehicle.tether);
    const of_it = places.filter(near);
    // It stays in the middle, so each place counts on both sides.
    const mirrored = of_it.map((at) => ({
      east_m: 2 * pose.east_m - at.east_m,
      north_m: 2 * pose.north_m - at.north_m,
    }));
    this.camera.fit([...of_it, ...mirrored], Math.max(50, 12 * vehicle.length_m));
  }

  private draw_grid(context: Context, width: number, height: number): void {
    const c = colours();
    context.fillStyle = c.paper;
    context.fillRect(0, 0, width, height);
    const step_m = round_below(120 / this.camera.pixels_per_metre);
    const low = this.camera.to_plane({ x: 0, y: height });
    const high = this.camera.to_plane({ x: width, y: 0 });
    for (
      let east_m = Math.ceil(low.east_m / step_m) * step_m;
      east_m <= high.east_m;
      east_m += step_m
    ) {
      const { x } = this.camera.to_pixel({ east_m, north_m: 0 });
      line(
        context,
        [
          { x, y: 0 },
          { x, y: height },
        ],
        c.panel,
        1,
      );
    }
    for (
      let north_m = Math.ceil(low.north_m / step_m) * step_m;
      north_m <= high.north_m;
      north_m += step_m
    ) {
      const { y } = this.camera.to_pixel({ east_m: 0, north_m });
      line(
        context,
        [
          { x: 0, y },
          { x: width, y },
        ],
        c.panel,
        1,
      );
    }
  }

  private draw_way(
    context: Context,
    places: readonly Waypoint[],
    colour: string,
    is_loop: boolean,
  ): void {
    const pixels = places.map((it) => this.camera.to_pixel(it));
    const first = pixels[0];
    line(
      context,
      is_loop && first !== undefined ? [...pixels, first] : pixels,
      colour,
      1.5,
      [6, 4],
    );
    for (const pixel of pixels) circle(context, pixel, 4, colour, 1.8);
  }

  private draw_draft(context: Context, draft: NonNullable<PlanDrawing['draft']>): void {
    const c = colours();
    const colour = draft.is_refused ? c.alarm : c.accent;
    this.draw_way(context, draft.places, colour, draft.is_loop);
    draft.places.forEach((place, i) => {
      const at = this.camera.to_pixel(place);
      context.fillStyle = i === draft.picked ? colour : c.paper;
      context.beginPath();
      context.arc(at.x, at.y, 9, 0, 2 * Math.PI);
      context.fill();
      circle(context, at, 9, colour, 2.5);
      const inside = i === draft.picked ? c.paper : colour;
      context.font = '600 11px system-ui, "DejaVu Sans", sans-serif';
      context.textAlign = 'center';
      context.textBaseline = 'middle';
      context.fillStyle = inside;
      context.fillText(String(i + 1), at.x, at.y + 0.5);
      label(context, level_text(place.up_m), { x: at.x, y: at.y + 19 }, colour, 'center');
    });
  }

  private draw_scale(context: Context, width: number, height: number, what: PlanDrawing): void {
    const c = colours();
    const length_m = round_below(140 / this.camera.pixels_per_metre);
    const length_px = length_m * this.camera.pixels_per_metre;
    const y = height - 14;
    line(
      context,
      [
        { x: 12, y: y - 5 },
        { x: 12, y },
        { x: 12 + length_px, y },
        { x: 12 + length_px, y: y - 5 },
      ],
      c.ink,
      2,
    );
    const words =
      length_m >= 1000 ? `${length_m / 1000} km` : `${Number(length_m.toPrecision(1))} m`;
    label(context, words, { x: 12 + length_px + 8, y: y - 2 }, c.ink);
    const north = { x: width - 22, y: 36 };
    arrow(context, north, 0, -22, c.ink, 2);
    label(context, 'N', { x: north.x, y: north.y + 9 }, c.ink, 'center', true);
    const from = { x: Math.max(12 + length_px + 70, width - 190), y: height - 16 };
    if (width > 420) {
      arrow(context, from, CURRENT_PIXELS_PER_M_S * 0.5, 0, c.water, 2.5);
      const speed = speed_text(0.5, what.speed_unit, what.speed_unit === 'knots' ? 2 : 1);
      label(context, `flow of ${speed}, towards`, { x: from.x + 32, y: from.y }, c.quiet);
    }
  }

  private listen(): void {
    const canvas = this.canvas;
    const fingers = new Map<number, Pixel>();
    let has_hand = false;
    let moved_px = 0;
    const pixel_of = (event: MouseEvent): Pixel => {
      const rect = canvas.getBoundingClientRect();
      return { x: event.clientX - rect.left, y: event.clientY - rect.top };
    };
    canvas.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      const pixel = pixel_of(event);
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, pixel);
      if (fingers.size === 1) {
        moved_px = 0;
        has_hand = this.hand.press(this.camera.to_plane(pixel), pixel);
      } else if (has_hand) {
        has_hand = false;
        this.hand.let_go();
      }
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = fingers.get(event.pointerId);
      if (before === undefined) return;
      const pixel = pixel_of(event);
      if (fingers.size === 2) {
        const other = [...fingers.entries()].find(([id]) => id !== event.pointerId)?.[1];
        if (other !== undefined) {
          const apart = (a: Pixel): number => Math.max(1, Math.hypot(a.x - other.x, a.y - other.y));
          this.camera.zoom(apart(pixel) / apart(before), other);
        }
        moved_px = 99;
      } else {
        moved_px += Math.hypot(pixel.x - before.x, pixel.y - before.y);
        if (has_hand) this.hand.move(this.camera.to_plane(pixel));
        else if (moved_px > 4) {
          this.follows = false;
          this.camera.pan(pixel.x - before.x, pixel.y - before.y);
        }
      }
      fingers.set(event.pointerId, pixel);
      this.on_change();
    });
    const up = (event: PointerEvent): void => {
      if (!fingers.delete(event.pointerId)) return;
      if (has_hand && fingers.size === 0) {
        has_hand = false;
        this.hand.let_go();
      } else if (event.type === 'pointerup' && moved_px <= 4 && fingers.size === 0) {
        const pixel = pixel_of(event);
        if (!this.hand.click(this.camera.to_plane(pixel), pixel)) this.on_choose(pixel);
      }
      this.on_change();
    };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        this.camera.zoom(Math.exp(-event.deltaY * 0.0015), pixel_of(event));
        this.on_change();
      },
      { passive: false },
    );
    canvas.addEventListener('keydown', (event) => {
      const middle = { x: this.camera.width / 2, y: this.camera.height / 2 };
      const pan = (right: number, down: number): void => {
        this.follows = false;
        this.camera.pan(right, down);
      };
      if (event.key === 'ArrowLeft') pan(60, 0);
      else if (event.key === 'ArrowRight') pan(-60, 0);
      else if (event.key === 'ArrowUp') pan(0, 60);
      else if (event.key === 'ArrowDown') pan(0, -60);
      else if (event.key === '+' || event.key === '=') this.camera.zoom(1.25, middle);
      else if (event.key === '-') this.camera.zoom(0.8, middle);
      else return;
      event.preventDefault();
      this.on_change();
    });
  }
}
