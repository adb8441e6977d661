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
    for (const name of names) {
      let label = this.labels.get(name.key);
      if (label === undefined) {
        label = element('span', {});
        this.labels.set(name.key, label);
        this.box.append(label);
      }
      at.copy(at_place(name.at)).project(camera);
      set_hidden(label, !(at.z < 1 && Math.abs(at.x) < 1 && Math.abs(at.y) < 1));
      set_text(label, name.text);
      label.className = `scene-label ${name.tone}`.trim();
      const right = Math.round(((at.x + 1) / 2) * wide);
      const down = Math.round(((1 - at.y) / 2) * high);
      label.style.transform = `translate(${right}px, ${down}px)`;
    }
  }
}
