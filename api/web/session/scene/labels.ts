// Names beside what they are of, as text of the page, as large as it is asked for.
import { Vector3, type PerspectiveCamera } from 'three';
import { element, set_hidden, set_text } from '../../look/element';
import { level_text } from '../look/units';
import type { Session } from '../session/state';
import { at_place, type Place } from './axes';

export interface Name {
  key: string;
  text: string;
  at: Place;
  tone: '' | 'chosen' | 'alarm';
}

/** Vehicles with their depth or height, vessels with an alarm where one stands. */
export function names_in(session: Session, chosen: number | null): Name[] {
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
  return names;
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
