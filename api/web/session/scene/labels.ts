// Names beside what they are of, as text of the page, as large as it is asked for.
import { Vector3, type PerspectiveCamera } from 'three';
import { element, set_hidden, set_text } from '../../look/element';
import { level_text, metres_text, span_text } from '../look/units';
import type { Session } from '../session/state';
import type { Approach } from './approach';
import { at_place, type Place } from './axes';

const TURBINES_NAMED = 8;

export interface Name {
  key: string;
  text: string;
  at: Place;
  tone: '' | 'chosen' | 'alarm';
}

/** Vehicles with their depth or height, vessels with an alarm where one stands. */
export function names_in(
  session: Session,
  chosen: number | null,
  eye: Vector3,
  approaches: readonly Approach[],
): Name[] {
  const names: Name[] = [];
  for (const pose of session.poses.values()) {
    const vehicle = session.vehicles.get(pose.vehicle);
    if (vehicle === undefined) continue;
    names.push({
      key: `vehicle ${pose.vehicle}`,
      text: `${vehicle.name} ${level_text(pose.up_m)}`,
      at: pose,
      tone: pose.vehicle === chosen ? 'chosen' : '',
    });
  }
  for (const vessel of session.vessels) {
    const alarm = [...session.alarms.values()].find((it) => it.with === vessel.name);
    names.push({
      key: `vessel ${vessel.mmsi}`,
      text: alarm === undefined ? vessel.name : `${vessel.name}: ${alarm.level}`,
      at: { ...vessel, up_m: 0 },
      tone: alarm === undefined ? '' : 'alarm',
    });
  }
  names.push(...turbine_names(session, eye));
  for (const approach of approaches)
    names.push({
      key: `approach ${approach.vessel}`,
      text: `${metres_text(approach.distance_m)} in ${span_text(approach.in_s)}`,
      at: approach.others,
      tone: 'alarm',
    });
  return names;
}

/** The nearest, each with what it makes. */
function turbine_names(session: Session, eye: Vector3): Name[] {
  const { turbines, weather } = session;
  if (turbines === null || eye.y < 0) return [];
  return turbines.places
    .map((place, nth) => ({ nth, at: { ...place, up_m: turbines.hub_height_m } }))
    .map((it) => ({ ...it, away_m: at_place(it.at).distanceTo(eye) }))
    .sort((a, b) => a.away_m - b.away_m)
    .slice(0, TURBINES_NAMED)
    .map(({ nth, at }) => {
      const power_w = weather?.farm?.each[nth]?.power_w;
      const makes = power_w === undefined ? '' : ` ${(power_w / 1e6).toFixed(1)} MW`;
      return { key: `turbine ${nth}`, text: `T${nth + 1}${makes}`, at, tone: '' as const };
    });
}

export interface Spot {
  right: number; // px, of its upper left corner
  down: number;
  wide: number;
}

export const HIGH_PX = 24;
const LOWER_AT_MOST = 6;

/** Each below those before it that it would lie on, as far as that helps. */
export function spread(spots: readonly Spot[]): Spot[] {
  const placed: Spot[] = [];
  for (const spot of spots) {
    const free = { ...spot };
    const on = (it: Spot): boolean =>
      free.right < it.right + it.wide &&
      it.right < free.right + free.wide &&
      Math.abs(free.down - it.down) < HIGH_PX;
    for (let i = 0; i < LOWER_AT_MOST && placed.some(on); i += 1) free.down += HIGH_PX;
    placed.push(free);
  }
  return placed;
}

const LETTER_PX = 7.5;
const EDGES_PX = 16;
const RANK = { alarm: 0, chosen: 1, '': 2 };

export class Labels {
  private readonly labels = new Map<string, HTMLElement>();
  constructor(private readonly box: HTMLElement) {}

  show(names: readonly Name[], camera: PerspectiveCamera, wide: number, high: number): void {
    const keys = new Set(names.map((it) => it.key));
    for (const [key, label] of this.labels) {
      if (keys.has(key)) continue;
      label.remove();
      this.labels.delete(key);
    }
    const at = new Vector3();
    const ranked = [...names].sort((a, b) => RANK[a.tone] - RANK[b.tone]);
    const seen = ranked.flatMap((name) => {
      const label = this.label_of(name);
      at.copy(at_place(name.at)).project(camera);
      const is_seen = at.z < 1 && Math.abs(at.x) < 1 && Math.abs(at.y) < 1;
      set_hidden(label, !is_seen);
      set_text(label, name.text);
      label.className = `scene-label ${name.tone}`.trim();
      const right = Math.round(((at.x + 1) / 2) * wide);
      const down = Math.round(((1 - at.y) / 2) * high);
      const long = LETTER_PX * name.text.length + EDGES_PX;
      return is_seen ? [{ label, spot: { right, down, wide: long } }] : [];
    });
    spread(seen.map((it) => it.spot)).forEach(({ right, down }, nth) => {
      seen[nth]!.label.style.transform = `translate(${right}px, ${down}px)`;
    });
  }

  private label_of(name: Name): HTMLElement {
    let label = this.labels.get(name.key);
    if (label === undefined) {
      label = element('span', {});
      this.labels.set(name.key, label);
      this.box.append(label);
    }
    return label;
  }
}
