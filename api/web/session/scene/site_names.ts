// Names of what is laid, inspected and found, and of the wind: the nearest ones.
import type { Vector3 } from 'three';
import { done_text, metres_text, speed_text, type SpeedUnit } from '../look/units';
import type { Finding } from '../session/inspected';
import type { Session } from '../session/state';
import { at_place, type Place } from './axes';
import type { InspectedView } from './inspected_view';
import type { Name } from './labels';
import type { Layers } from './layers';
import { wind_of, wind_tips } from './wind_view';

const LAID = { within_m: 200, most: 4 };
const FINDINGS = { within_m: 60, most: 10 };

interface Near {
  name: Name;
  away_m: number;
}

function nearest(of: Near[], { within_m, most }: { within_m: number; most: number }): Name[] {
  return of
    .filter((it) => it.away_m <= within_m)
    .sort((a, b) => a.away_m - b.away_m)
    .slice(0, most)
    .map((it) => it.name);
}

function plain(key: string, text: string, at: Place, eye: Vector3): Near {
  return { name: { key, text, at, tone: '' }, away_m: at_place(at).distanceTo(eye) };
}

export function size_text(size_m: number | null): string {
  if (size_m === null) return '';
  return size_m < 1 ? `${(100 * size_m).toFixed(size_m < 0.1 ? 1 : 0)} cm` : metres_text(size_m, 1);
}

export function finding_text({ kind, size_m }: Finding): string {
  const size = size_text(size_m);
  return kind.replaceAll('_', ' ') + (size === '' ? '' : ` ${size}`);
}

function laid_names(session: Session, eye: Vector3): Name[] {
  const laid = session.cables.map(({ id, route }, nth) => {
    const places = route.map((at) => plain(`cable ${nth}`, id, at, eye));
    return places.reduce((a, b) => (b.away_m < a.away_m ? b : a));
  });
  session.moorings.forEach(({ id, fairlead, anchor }, nth) => {
    const ends = [fairlead, anchor].map((at) => plain(`mooring ${nth}`, id, at, eye));
    laid.push(ends.reduce((a, b) => (b.away_m < a.away_m ? b : a)));
  });
  return nearest(laid, LAID);
}

export function site_names(
  session: Session,
  inspected: InspectedView,
  eye: Vector3,
  layers: Layers,
  speed_unit: SpeedUnit,
): Name[] {
  const names: Name[] = [];
  if (layers.laid) names.push(...laid_names(session, eye));
  if (layers.inspected) {
    for (const [key, surface] of session.surfaces) {
      const at = inspected.middle_of(surface);
      const text = `${surface.name} ${done_text(surface.seen)}`;
      if (at !== null) names.push({ key: `surface ${key}`, text, at, tone: '' });
    }
    const found = [...session.findings.values()].flat();
    const near = found.map((it, nth) => plain(`finding ${nth}`, finding_text(it), it.at, eye));
    names.push(...nearest(near, FINDINGS));
  }
  const wind = layers.wind && eye.y > 0 ? wind_of(session) : null;
  const [tip] = wind === null ? [] : wind_tips(session, wind, eye);
  if (wind !== null && tip !== undefined)
    names.push({ key: 'wind', text: speed_text(wind.speed_m_s, speed_unit), at: tip, tone: '' });
  return names;
}
