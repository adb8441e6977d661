// Names beside what they are of, as text of the page: read by whoever reads it, as large as asked.
import { Vector3, type PerspectiveCamera } from 'three';
import { element, set_hidden, set_text } from '../../look/element';
import { level_text } from '../look/units';
import type { Session } from '../session/state';
import { at_place } from './axes';

export class Labels {
  private readonly labels = new Map<number, HTMLElement>();
  constructor(private readonly box: HTMLElement) {}

  show(
    session: Session,
    chosen: number | null,
    camera: PerspectiveCamera,
    wide: number,
    high: number,
  ): void {
    for (const [vehicle, label] of this.labels) {
      if (session.poses.has(vehicle)) continue;
      label.remove();
      this.labels.delete(vehicle);
    }
    const at = new Vector3();
    for (const pose of session.poses.values()) {
      const vehicle = session.vehicles.get(pose.vehicle);
      if (vehicle === undefined) continue;
      let label = this.labels.get(pose.vehicle);
      if (label === undefined) {
        label = element('span', { class: 'scene-label' });
        this.labels.set(pose.vehicle, label);
        this.box.append(label);
      }
      at.copy(at_place(pose)).project(camera);
      const is_seen = at.z < 1 && Math.abs(at.x) < 1 && Math.abs(at.y) < 1;
      set_hidden(label, !is_seen);
      set_text(label, `${vehicle.name} ${level_text(pose.up_m)}`);
      label.classList.toggle('chosen', pose.vehicle === chosen);
      label.style.transform = `translate(${Math.round(((at.x + 1) / 2) * wide)}px, ${Math.round(
        ((1 - at.y) / 2) * high,
      )}px)`;
    }
  }
}
