// What is all about the eye: sky, sea, bed, and their light.
import {
  AmbientLight,
  Color,
  DirectionalLight,
  FogExp2,
  Vector2,
  type Scene,
  type Vector3,
} from 'three';
import { colours } from '../look/palette';
import { elevation_m } from '../session/sea';
import type { Session } from '../session/state';
import { fading_per_m, light_seen, lit, set_fog } from './air_and_water';
import { BedView } from './bed_view';
import { daylight_of } from './daylight';
import { Sky } from './sky';
import { Water } from './water';

const NOON = { elevation_deg: 50, azimuth_deg: 180 }; // where nobody says
const FADED_AWAY = 9; // exp(-9) is less than one of 8000 parts
const UNKNOWN_BY_DAY = 1.2; // of all sides, where the sun's own light is 2

export class Surround {
  /** Under water as far as one likes, which is farther than anybody sees there. */
  is_clear = false;
  readonly bed = new BedView();
  private readonly fog = new FogExp2('#000000', 0);
  private readonly sky = new Sky();
  private readonly water = new Water();
  private readonly sun = new DirectionalLight('#ffffff', 2);
  private readonly all_sides = new AmbientLight('#ffffff', UNKNOWN_BY_DAY);

  constructor(private readonly scene: Scene) {
    scene.fog = this.fog;
    scene.add(this.all_sides, this.sun, this.sky.mesh, this.water.mesh, this.bed.group);
  }

  /**
   * After the bed has taken what is told of it. `in_headset`: there is a picture for each eye.
   * `is_table`: it is seen from far above as things on a table, with nothing all about.
   */
  show(session: Session, eye: Vector3, in_headset = false, is_table = false): void {
    this.water.draw_for_two_eyes(in_headset);
    const about = new Vector2(eye.x, -eye.z);
    const factor = session.weather?.waves_factor ?? 1;
    const time_s = session.frame?.time_s ?? 0;
    this.water.show(session.sea, factor, time_s, about);
    const surface_m = elevation_m(session.sea, factor, about.x, about.y, time_s);
    const is_under_water = eye.y < surface_m;
    const { sky, deep, bed } = colours();
    const daylight = daylight_of(session.weather?.sun ?? NOON, sky);
    const per_m = fading_per_m(session.weather, is_under_water);
    // By day water shows the colours that it leaves of the light from above.
    const left = is_under_water ? light_seen(per_m, surface_m - eye.y) : ([1, 1, 1] as const);
    const water = new Color(deep).multiplyScalar(daylight.light);
    const seen = is_under_water ? lit(water, left) : daylight.horizon;
    // So deep that nothing of the surface is left to be seen, it is not drawn.
    const faded = is_under_water && !this.is_clear ? per_m * (surface_m - eye.y) : 0;
    this.water.mesh.visible = !is_table && faded < FADED_AWAY;
    set_fog(this.fog, is_under_water && this.is_clear ? 0 : per_m, is_under_water, seen);
    this.scene.background = seen.clone();
    this.sky.mesh.visible = !is_under_water;
    this.sky.show(daylight, eye);
    this.sun.position.copy(daylight.to_sun);
    this.sun.color.copy(lit(daylight.sun, left));
    this.sun.intensity = 2.2 * daylight.beam * daylight.light;
    this.all_sides.color.copy(lit(new Color('#ffffff'), left));
    this.all_sides.intensity = UNKNOWN_BY_DAY * daylight.light;
    this.water.paint(water, daylight.zenith.clone().lerp(daylight.horizon, 0.5));
    this.bed.group.visible = true;
    this.bed.show(eye, lit(new Color(bed), left).multiplyScalar(daylight.light));
    if (is_table) this.show_on_table();
  }

  /** Of the bed that is drawn there; nothing: none is. */
  bed_under(eye: Vector3): number | null {
    return this.bed.up_at(eye.x, 0 - eye.z);
  }

  /** In plain light, whatever the hour is. */
  private show_on_table(): void {
    this.fog.density = 0;
    this.scene.background = null;
    this.sky.mesh.visible = this.bed.group.visible = false;
    this.sun.position.set(0.4, 1, 0.5);
    for (const light of [this.sun, this.all_sides]) light.color.set('#ffffff');
    this.sun.intensity = 1.6;
    this.all_sides.intensity = 1.4;
  }
}
