// The scene: the sea, the vehicles in it, and what stands and passes by, at the moment of the last
// frame. What was not told is not there; what is told without a shape has a plain one.
import {
  ArrowHelper,
  Color,
  Euler,
  Mesh,
  MeshBasicMaterial,
  type PerspectiveCamera,
  Raycaster,
  Scene,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { colours } from '../look/palette';
import type { SpeedUnit } from '../look/units';
import type { Pose } from '../session/frame';
import type { Vehicle } from '../session/message';
import type { Session } from '../session/state';
import type { PlanDrawing } from '../view/plan_view';
import type { Tracks } from '../view/tracks';
import { seen_in_water_m } from './air_and_water';
import { approaches_in, type Approach } from './approach';
import { at_place, at_scene, turned, type Place } from './axes';
import { is_small, type Lens } from './detail';
import { Eye } from './eye';
import { FarMarks } from './far_marks';
import { FarmView } from './farm_view';
import { FARTHEST_M, type InPicture } from './handles';
import { FlowSlice, Hodograph } from './flow_view';
import { Kept } from './kept';
import { Labels, names_in, type Name } from './labels';
import { camera_edges, home_mark, ring } from './marks';
import { people_names, place_people } from './people_shown';
import { ALL_LAYERS, type Layers } from './layers';
import { met_along, name_of, that_can_be_pressed, that_hide } from './met';
import { vehicle_key, vehicle_shape, vessel_key, vessel_shape, vessel_size } from './shapes';
import { site_names } from './site_names';
import { SiteView, is_far } from './site_view';
import { Surround } from './surround';
import { draft_names, place_draft } from './way_shown';

export interface Shown {
  session: Session;
  tracks: Tracks;
  chosen: number | null;
  draft: PlanDrawing['draft']; // of a way under edit
}

/** Who is in it with a headset, or sees it as a table: drawn for them, and not for the desk. */
export interface Visitor {
  readonly camera: PerspectiveCamera;
  readonly is_table: boolean;
  /** Where the eyes are in the scene. */
  eye(): Vector3;
  before_drawn(shown: Shown, names: readonly Name[]): void;
}

const CURRENT_ARROW_M_PER_M_S = 4;
const IN_HEADSET = { field_deg: 95, high_px: 2000 }; // what is usual for each eye

export class SceneView {
  readonly eye = new Eye();
  /** The current is shown: over a slice at this height, and from surface to bed at the chosen. */
  slice_up_m: number | null = null;
  shows_wakes = false;
  visitor: Visitor | null = null;
  layers: Layers = { ...ALL_LAYERS };
  speed_unit: SpeedUnit = 'm/s'; // of its reader
  readonly scene = new Scene();
  readonly surround = new Surround(this.scene);
  readonly site = new SiteView(this.scene);
  private readonly far = new FarMarks(this.scene);
  private readonly kept = new Kept(this.scene);
  private readonly slice = new FlowSlice();
  private readonly hodograph = new Hodograph();
  private readonly labels: Labels;
  readonly renderer: WebGLRenderer;
  private approaches: Approach[] = [];
  private chosen_before: number | null = null;
  private farm: { of: Session['turbines']; view: FarmView } | null = null;

  /** @throws where the browser has no WebGL 2 */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    labels: HTMLElement,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.labels = new Labels(labels);
    this.scene.add(this.slice.mesh, this.hodograph.group);
  }

  /** What the last picture asked of the graphics card. */
  asked(): { calls: number; triangles: number } {
    return this.renderer.info.render;
  }

  see_all(session: Session): void {
    this.eye.see_all([...session.poses.values()].map(at_place));
  }

  /** What lies under a place of the picture: the nearest thing, else mean sea level or the bed. */
  place_under(at: InPicture): Place | null {
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(at.right, at.up), this.eye.camera);
    return this.place_along(caster.ray.origin, caster.ray.direction);
  }

  /** The name of what is seen there; empty: it has none, as the sea that hides the rest. */
  named_under(at: InPicture): string {
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(at.right, at.up), this.eye.camera);
    return this.named_along(caster.ray.origin, caster.ray.direction);
  }

  /** The same along a unit vector from a place. */
  named_along(from: Vector3, ahead: Vector3): string {
    const met = met_along(that_hide(this.scene), from, ahead);
    return met === null ? '' : name_of(met);
  }

  /** The same along a unit vector from a place. */
  place_along(from: Vector3, ahead: Vector3): Place | null {
    const met = met_along(that_can_be_pressed(this.scene), from, ahead);
    if (met !== null) return at_scene(met.point);
    if (from.y <= 0) {
      const bed = met_along([this.surround.bed.group], from, ahead);
      return bed === null ? null : at_scene(bed.point);
    }
    const away_m = (0 - from.y) / ahead.y;
    if (!(away_m > 0 && away_m <= FARTHEST_M)) return null;
    return at_scene(from.clone().addScaledVector(ahead, away_m));
  }

  /** Who looks, for the others to see. */
  looks_from(): { at: Vector3; along: Vector3 } {
    const { camera } = this.visitor ?? this.eye;
    const along = camera.getWorldDirection(new Vector3());
    return { at: this.visitor?.eye() ?? camera.position, along };
  }

  draw(shown: Shown): void {
    const { session, tracks, chosen, draft } = shown;
    const { visitor, renderer } = this;
    const { clientWidth: wide, clientHeight: high } = this.canvas;
    if (!renderer.xr.isPresenting) {
      if (wide < 2 || high < 2) return;
      renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
      renderer.setSize(wide, high, false);
      this.eye.camera.aspect = wide / high;
    }
    const pose = chosen === null ? undefined : session.poses.get(chosen);
    const vehicle = chosen === null ? undefined : session.vehicles.get(chosen);
    const pointing = chosen === null ? null : (session.statuses.get(chosen)?.camera ?? null);
    const is_followed_anew = chosen !== this.chosen_before && this.eye.stand === 'follow';
    if (is_followed_anew && pose !== undefined && pose.up_m < -1)
      this.eye.come_within(0.5 * seen_in_water_m(session.weather));
    this.chosen_before = chosen;
    this.eye.place(pose, pointing, vehicle?.length_m ?? 1);
    this.surround.bed.take(session); // what is laid on it comes after
    place_draft(this.kept, draft, this.surround.bed, colours());
    const { camera } = visitor ?? this.eye;
    const from = visitor?.eye() ?? camera.position;
    const lens =
      visitor === null
        ? { eye: from, field_deg: this.eye.camera.fov, high_px: high }
        : { eye: from, ...IN_HEADSET };
    this.place_things(session, tracks, chosen, lens);
    this.place_farm(session, from);
    this.site.show(session, lens, this.surround.bed, this.layers);
    const is_beside = this.eye.stand !== 'on_board';
    this.site.show_picture(is_beside ? (pose ?? null) : null, session, this.layers);
    this.place_flow(session, pose ?? null);
    this.surround.show(session, from, visitor !== null, visitor?.is_table ?? false);
    const names = names_in(session, chosen, from, this.approaches);
    names.push(...people_names(session), ...draft_names(draft));
    const { layers, speed_unit } = this;
    names.push(...site_names(session, this.site.inspected, from, layers, speed_unit));
    visitor?.before_drawn(shown, names);
    renderer.render(this.scene, camera);
    this.labels.show(visitor === null ? names : [], camera, wide, high);
  }

  private place_things(session: Session, tracks: Tracks, chosen: number | null, lens: Lens): void {
    this.far.begin();
    for (const pose of session.poses.values()) {
      const vehicle = session.vehicles.get(pose.vehicle);
      if (vehicle === undefined) continue;
      if (is_far(lens, pose, vehicle)) {
        const size = { long_m: vehicle.length_m, wide_m: vehicle.width_m };
        this.far.add('vehicle', vehicle.name, at_place(pose), turned(pose), size);
      } else {
        const shape = this.kept.of(vehicle_key(vehicle), () => vehicle_shape(vehicle));
        shape.position.copy(at_place(pose));
        shape.rotation.copy(turned(pose));
        this.place_stream(pose);
      }
      this.place_line(session, pose);
      if (pose.vehicle !== chosen) continue;
      this.place_way(session, tracks, pose.vehicle);
      this.place_marks(session, vehicle, pose);
    }
    for (const vessel of session.vessels) {
      const at = at_place({ ...vessel, up_m: 0 }); // how it heaves nobody tells
      const turn = new Euler(0, -((vessel.course_deg ?? 0) * Math.PI) / 180, 0);
      const size = vessel_size(vessel);
      if (is_small(lens, at, size.long_m)) {
        this.far.add('vessel', vessel.name, at, turn, size);
        continue;
      }
      const shape = this.kept.of(vessel_key(vessel), () => vessel_shape(vessel));
      shape.position.copy(at);
      shape.rotation.copy(turn);
    }
    this.far.end();
    this.approaches = approaches_in(session);
    for (const [nth, { own, others }] of this.approaches.entries())
      this.kept.line(`approach ${nth}`, [at_place(own), at_place(others)], colours().alarm);
    place_people(this.kept, session, colours());
    this.kept.drop_the_rest();
  }

  /** The water (or in the air the wind) that it is in. */
  private place_stream(pose: Pose): void {
    const flow = new Vector3(pose.current_east_m_s, 0, -pose.current_north_m_s);
    const arrow = this.kept.of(`flow ${pose.vehicle}`, () => {
      return new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 1);
    });
    arrow.visible = flow.length() > 0.01;
    arrow.position.copy(at_place(pose));
    arrow.setDirection(flow.clone().normalize());
    arrow.setLength(Math.max(0.3, CURRENT_ARROW_M_PER_M_S * flow.length()), 0.4, 0.2);
    arrow.setColor(new Color(colours().water));
  }

  /** Its tether; frames come oftener than its nodes, so its end is held to the vehicle. */
  private place_line(session: Session, pose: Pose): void {
    const nodes = session.lines.get(pose.vehicle);
    if (nodes === undefined) return;
    const through = [...nodes.slice(0, -1).map(at_place), at_place(pose)];
    this.kept.line(`line ${pose.vehicle}`, through, colours().amber);
  }

  /** What it has about it. On board its camera's own edges would be in the way. */
  private place_marks(session: Session, vehicle: Vehicle, pose: Pose): void {
    const { accent, amber, quiet } = colours();
    const pointing = session.statuses.get(pose.vehicle)?.camera ?? null;
    if (pointing !== null && this.eye.stand !== 'on_board')
      this.kept.line(
        'camera',
        camera_edges(pose, pointing, this.site.aspect(pose.vehicle)),
        accent,
      );
    const home = home_mark(vehicle);
    if (home !== null) this.kept.line('home', home, quiet);
    if (vehicle.zone !== null)
      this.kept.line('zone', ring(vehicle.zone, vehicle.zone.radius_m), amber);
  }

  /** Where the chosen one was and goes, each waypoint with a plumb line to the surface. */
  private place_way(session: Session, tracks: Tracks, vehicle: number): void {
    const { accent, ink } = colours();
    this.kept.line('track', tracks.of(vehicle).map(at_place), ink);
    session.statuses
      .get(vehicle)
      ?.waypoints.slice(0, 40)
      .forEach((waypoint, nth) => {
        const ball = this.kept.of(`waypoint ${nth}`, () => {
          return new Mesh(new SphereGeometry(0.4, 12, 8), new MeshBasicMaterial({ fog: false }));
        });
        ball.material.color.set(accent);
        ball.position.copy(at_place(waypoint));
        const ends = [at_place(waypoint), at_place({ ...waypoint, up_m: 0 })];
        this.kept.line(`plumb ${nth}`, ends, accent);
      });
  }

  /** In detail where the eye of who looks is near: at the desk, or in a headset. */
  private place_farm(session: Session, eye: Vector3): void {
    if (this.farm !== null && this.farm.of !== session.turbines) {
      this.scene.remove(this.farm.view.group);
      this.farm.view.dispose();
      this.farm = null;
    }
    if (session.turbines === null) return;
    if (this.farm === null) {
      this.farm = { of: session.turbines, view: new FarmView(session.turbines) };
      this.scene.add(this.farm.view.group);
    }
    const time_s = session.frame?.time_s ?? 0;
    this.farm.view.show(session.weather, time_s, this.shows_wakes, eye);
  }

  private place_flow(session: Session, chosen: Pose | null): void {
    const { water } = colours();
    const is_shown = this.slice_up_m !== null;
    const currents = is_shown ? (session.weather?.currents ?? []) : [];
    this.slice.show(currents, this.slice_up_m ?? 0, this.eye.looks_at(), water);
    this.hodograph.show(currents, chosen, water);
  }
}
