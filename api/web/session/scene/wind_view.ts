// The wind: an arrow at hub height before each of the nearest turbines; where there are none, the
// one of 10 m over the origin.
import {
  ConeGeometry,
  CylinderGeometry,
  MeshBasicMaterial,
  type BufferGeometry,
  type Scene,
  type Vector3,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Session } from '../session/state';
import { at_place, type Place } from './axes';
import { Instances } from './instances';

const TURBINES = 3;
const BEFORE_DIAMETERS = 0.4;
const CALM_M_S = 0.1;

export interface Wind {
  speed_m_s: number;
  from_deg: number | null; // null: a calm has none
  high_m: number;
  is_at_hub: boolean;
}

/** Nothing: nobody tells it. */
export function wind_of({ weather, turbines }: Session): Wind | null {
  const told = (
    speed_m_s: number | null,
    from_deg: number | null,
    high_m: number,
    is_at_hub: boolean,
  ): Wind | null => (speed_m_s === null ? null : { speed_m_s, from_deg, high_m, is_at_hub });
  if (weather === null) return null;
  if (turbines === null || turbines.places.length === 0)
    return told(weather.wind_m_s, weather.wind_from_deg, 10, false);
  return told(weather.hub_wind_m_s, weather.hub_wind_from_deg, turbines.hub_height_m, true);
}

export function is_calm(wind: Wind): boolean {
  return wind.speed_m_s <= CALM_M_S;
}

/** Where the tips of its arrows are, the nearest first; none in a calm. */
export function wind_tips(session: Session, wind: Wind, eye: Vector3): Place[] {
  const { turbines } = session;
  if (wind.from_deg === null || is_calm(wind)) return [];
  const from_rad = (wind.from_deg * Math.PI) / 180;
  const before_m = BEFORE_DIAMETERS * (turbines?.rotor_diameter_m ?? 0);
  const places = wind.is_at_hub ? (turbines?.places ?? []) : [{ east_m: 0, north_m: 0 }];
  return places
    .map(({ east_m, north_m }) => ({
      east_m: east_m + before_m * Math.sin(from_rad),
      north_m: north_m + before_m * Math.cos(from_rad),
      up_m: wind.high_m,
    }))
    .map((at) => ({ at, away_m: at_place(at).distanceTo(eye) }))
    .sort((a, b) => a.away_m - b.away_m)
    .slice(0, TURBINES)
    .map((it) => it.at);
}

/** Its tip at the origin, its tail along z, as long as 1. */
function arrow(): BufferGeometry {
  const head = new ConeGeometry(0.08, 0.3, 12);
  head.translate(0, -0.15, 0);
  const shaft = new CylinderGeometry(0.025, 0.025, 0.7, 8);
  shaft.translate(0, -0.65, 0);
  const made = mergeGeometries([head, shaft]);
  made.rotateX(-Math.PI / 2);
  return made;
}

export class WindView {
  private readonly paint = new MeshBasicMaterial({ fog: false });
  private readonly arrows: Instances;

  constructor(scene: Scene) {
    this.arrows = new Instances(scene, arrow(), this.paint);
  }

  show(session: Session, eye: Vector3, colour: string): void {
    const wind = wind_of(session);
    this.paint.color.set(colour);
    this.arrows.begin();
    if (wind !== null && eye.y > 0)
      for (const tip of wind_tips(session, wind, eye)) {
        const { part } = this.arrows;
        part.position.copy(at_place(tip));
        part.rotation.set(0, Math.PI - ((wind.from_deg ?? 0) * Math.PI) / 180, 0);
        part.scale.setScalar((wind.is_at_hub ? 6 : 1.5) * wind.speed_m_s);
        this.arrows.add();
      }
    this.arrows.end();
  }

  hide(): void {
    this.arrows.clear();
  }
}
