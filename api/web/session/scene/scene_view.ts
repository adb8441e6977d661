// The scene: the sea, the vehicles in it, and what stands and passes by, at the moment of the last
// frame. What was not told is not there; what is told without a shape has a plain one.
import {
  AmbientLight,
  ArrowHelper,
  BufferGeometry,
  Color,
  DirectionalLight,
  FogExp2,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
  type Object3D,
} from 'three';
import { colours } from '../look/palette';
import type { Pose } from '../session/frame';
import type { Vehicle } from '../session/message';
import type { Session } from '../session/state';
import { elevation_m } from '../session/sea';
import type { Tracks } from '../view/tracks';
import { fading_per_m, set_fog } from './air_and_water';
import { at_place, turned } from './axes';
import { Eye } from './eye';
import { Labels, names_in } from './labels';
import { camera_edges, home_mark, ring } from './marks';
import { structure_shape, vehicle_shape, vessel_shape } from './shapes';
import { Water } from './water';

export interface Shown {
  session: Session;
  tracks: Tracks;
  chosen: number | null;
}

type PlainLine = Line<BufferGeometry, LineBasicMaterial>;

const CURRENT_ARROW_M_PER_M_S = 4;

/** Things by a key: made when they come, taken away when they are gone. */
class Kept<T extends Object3D> {
  private readonly things = new Map<string, T>();
  private seen = new Set<string>();
  constructor(private readonly scene: Scene) {}

  of(key: string, make: () => T): T {
    this.seen.add(key);
    let thing = this.things.get(key);
    if (thing === undefined) {
      thing = make();
      this.things.set(key, thing);
      this.scene.add(thing);
    }
    return thing;
  }
  drop_the_rest(): void {
    for (const [key, thing] of this.things) {
      if (this.seen.has(key)) continue;
      thing.traverse((part) => {
        if (part instanceof Mesh || part instanceof Line) part.geometry.dispose();
      });
      this.scene.remove(thing);
      this.things.delete(key);
    }
    this.seen = new Set();
  }
}

export class SceneView {
  readonly eye = new Eye();
  /** Under water as far as one likes, which is farther than anybody sees there. */
  is_clear = false;
  private readonly scene = new Scene();
  private readonly fog = new FogExp2('#000000', 0);
  private readonly water = new Water();
  private readonly kept = new Kept<Object3D>(this.scene);
  private readonly bed: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly labels: Labels;
  private readonly renderer: WebGLRenderer;

  /** @throws where the browser has no WebGL 2 */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    labels: HTMLElement,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.labels = new Labels(labels);
    this.scene.fog = this.fog;
    const sun = new DirectionalLight('#ffffff', 2);
    sun.position.set(0.4, 1, 0.3);
    this.bed = new Mesh(new PlaneGeometry(6000, 6000), new MeshBasicMaterial());
    this.bed.rotation.x = -Math.PI / 2;
    this.scene.add(new AmbientLight('#ffffff', 1.2), sun, this.water.mesh, this.bed);
  }

  /** What the last picture asked of the graphics card. */
  asked(): { calls: number; triangles: number } {
    return this.renderer.info.render;
  }

  see_all(session: Session): void {
    this.eye.see_all([...session.poses.values()].map(at_place));
  }

  draw({ session, tracks, chosen }: Shown): void {
    const { clientWidth: wide, clientHeight: high } = this.canvas;
    if (wide < 2 || high < 2) return;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
    this.renderer.setSize(wide, high, false);
    this.eye.camera.aspect = wide / high;
    const pose = chosen === null ? undefined : session.poses.get(chosen);
    const vehicle = chosen === null ? undefined : session.vehicles.get(chosen);
    const pointing = chosen === null ? null : (session.statuses.get(chosen)?.camera ?? null);
    this.eye.place(pose, pointing, vehicle?.length_m ?? 1);
    this.place_things(session, tracks, chosen);
    this.place_water(session);
    this.renderer.render(this.scene, this.eye.camera);
    this.labels.show(names_in(session, chosen), this.eye.camera, wide, high);
  }

  private place_things(session: Session, tracks: Tracks, chosen: number | null): void {
    for (const [nth, structure] of session.structures.entries())
      this.kept.of(`structure ${nth} ${session.id}`, () => structure_shape(structure));
    for (const pose of session.poses.values()) {
      const vehicle = session.vehicles.get(pose.vehicle);
      if (vehicle === undefined) continue;
      const shape = this.kept.of(`vehicle ${pose.vehicle} ${vehicle.model}`, () =>
        vehicle_shape(vehicle),
      );
      shape.position.copy(at_place(pose));
      shape.rotation.copy(turned(pose));
      // The water (or in the air the wind) that it is in.
      const flow = new Vector3(pose.current_east_m_s, 0, -pose.current_north_m_s);
      const arrow = this.kept.of(
        `flow ${pose.vehicle}`,
        () => new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 1),
      ) as ArrowHelper;
      arrow.visible = flow.length() > 0.01;
      arrow.position.copy(shape.position);
      arrow.setDirection(flow.clone().normalize());
      arrow.setLength(Math.max(0.3, CURRENT_ARROW_M_PER_M_S * flow.length()), 0.4, 0.2);
      arrow.setColor(new Color(colours().water));
      if (pose.vehicle !== chosen) continue;
      this.place_way(session, tracks, pose.vehicle);
      this.place_marks(session, vehicle, pose);
    }
    for (const vessel of session.vessels) {
      const shape = this.kept.of(`vessel ${vessel.mmsi}`, () => vessel_shape(vessel));
      shape.position.copy(at_place({ ...vessel, up_m: 0 })); // how it heaves nobody tells
      shape.rotation.y = -((vessel.course_deg ?? 0) * Math.PI) / 180;
    }
    this.kept.drop_the_rest();
  }

  private line(key: string, through: Vector3[], colour: string): void {
    const line = this.kept.of(
      key,
      () => new Line(new BufferGeometry(), new LineBasicMaterial()),
    ) as PlainLine;
    set_line(line, through, colour);
  }

  /** What it has about it. On board its camera's own edges would be in the way. */
  private place_marks(session: Session, vehicle: Vehicle, pose: Pose): void {
    const { accent, amber, quiet } = colours();
    const pointing = session.statuses.get(pose.vehicle)?.camera ?? null;
    if (pointing !== null && this.eye.stand !== 'on_board')
      this.line('camera', camera_edges(pose, pointing), accent);
    const home = home_mark(vehicle);
    if (home !== null) this.line('home', home, quiet);
    if (vehicle.zone !== null) this.line('zone', ring(vehicle.zone, vehicle.zone.radius_m), amber);
  }

  /** Where the chosen one was and goes, each waypoint with a plumb line to the surface. */
  private place_way(session: Session, tracks: Tracks, vehicle: number): void {
    const { accent, ink } = colours();
    this.line('track', tracks.of(vehicle).map(at_place), ink);
    session.statuses.get(vehicle)?.waypoints.slice(0, 40).forEach((waypoint, nth) => {
      const ball = this.kept.of(
        `waypoint ${nth}`,
        () => new Mesh(new SphereGeometry(0.4, 12, 8), new MeshBasicMaterial()),
      ) as Mesh<SphereGeometry, MeshBasicMaterial>;
      ball.material.color.set(accent);
      ball.position.copy(at_place(waypoint));
      const ends = [at_place(waypoint), at_place({ ...waypoint, up_m: 0 })];
      this.line(`plumb ${nth}`, ends, accent);
    });
  }

  private place_water(session: Session): void {
    const at = this.eye.camera.position;
    const about = new Vector2(at.x, -at.z);
    const factor = session.weather?.waves_factor ?? 1;
    const time_s = session.frame?.time_s ?? 0;
    this.water.show(session.sea, factor, time_s, about);
    const surface_m = elevation_m(session.sea, factor, about.x, about.y, time_s);
    const is_under_water = at.y < surface_m;
    const { sky, deep, bed } = colours();
    const seen = is_under_water ? deep : sky;
    const per_m = fading_per_m(session.weather, is_under_water);
    set_fog(this.fog, is_under_water && this.is_clear ? 0 : per_m, seen);
    this.scene.background = new Color(seen);
    this.water.paint(deep, sky);
    const bed_m = bed_of(session);
    this.bed.visible = bed_m !== null;
    this.bed.position.set(at.x, bed_m ?? 0, at.z);
    this.bed.material.color.set(bed);
  }
}

/** Where the vehicles measure it, the deepest; else the depth that the waves were made for. */
function bed_of(session: Session): number | null {
  let deepest: number | null = null;
  for (const pose of session.poses.values()) {
    if (pose.bed_m === null) continue;
    const bed_m = pose.up_m - pose.bed_m;
    if (deepest === null || bed_m < deepest) deepest = bed_m;
  }
  return deepest ?? (session.sea === null ? null : -session.sea.depth_m);
}

function set_line(line: PlainLine, through: Vector3[], colour: string): void {
  line.geometry.dispose();
  line.geometry = new BufferGeometry().setFromPoints(through);
  line.material.color.set(colour);
  line.frustumCulled = false;
}
