// Where the camera of the chosen vehicle looks, for whoever has its helm.
import { button, element, labelled, set_hidden, set_text } from '../../look/element';
import type { HandWindow } from '../drive/hand_window';
import type { CameraPointing } from '../session/message';
import type { Panel, Station } from '../station';

/** @param by_hand the window in which a hand turns it */
export function camera_panel(
  station: Station,
  by_hand: Pick<HandWindow, 'opener' | 'overrule'>,
): Panel {
  const slider = (low: number, high: number, step: number, value: number): HTMLInputElement =>
    element('input', { type: 'range', min: low, max: high, step, value });
  const pan = slider(-180, 180, 5, 0);
  const tilt = slider(-90, 90, 5, 0);
  const zoom = slider(1, 10, 0.5, 1);
  const now = element('p', { class: 'note' });
  const point = (): void => {
    const to: CameraPointing = {
      pan_deg: Number(pan.value),
      tilt_deg: Number(tilt.value),
      zoom: Number(zoom.value),
    };
    if (station.command('Camera', { do: 'camera', ...to })) by_hand.overrule(to);
  };
  const set = (pan_deg: number, tilt_deg: number, times: number): void => {
    pan.value = String(pan_deg);
    tilt.value = String(tilt_deg);
    zoom.value = String(times);
  };
  // Once a slider is let go, not on its way: each is a row of the record.
  for (const it of [pan, tilt, zoom]) it.addEventListener('change', point);
  const ahead = button('Straight ahead', () => {
    set(0, 0, 1);
    point();
  });
  const box = element(
    'section',
    { class: 'camera' },
    element('h2', {}, 'Camera'),
    now,
    labelled('Pan, ° to starboard', pan),
    labelled('Tilt, ° up', tilt),
    labelled('Zoom, times', zoom),
    element('div', { class: 'buttons' }, ahead, by_hand.opener),
  );
  let shown = '';

  return {
    box,
    show: () => {
      const { session, chosen } = station;
      const camera = chosen === null ? undefined : session.statuses.get(chosen)?.camera;
      set_hidden(box, camera === undefined || camera === null || !station.has_helm());
      if (camera === undefined || camera === null) return;
      set_text(now, camera_text(camera));
      // What the server has, unless a hand is on it.
      const key = `${chosen} ${camera.pan_deg} ${camera.tilt_deg} ${camera.zoom}`;
      if (key === shown || box.contains(document.activeElement)) return;
      shown = key;
      set(camera.pan_deg, camera.tilt_deg, camera.zoom);
    },
  };
}

export function camera_text(camera: { pan_deg: number; tilt_deg: number; zoom: number }): string {
  const side = camera.pan_deg < 0 ? 'to port' : 'to starboard';
  const way = camera.tilt_deg < 0 ? 'down' : 'up';
  const pan = camera.pan_deg === 0 ? 'straight ahead' : `${Math.abs(camera.pan_deg)}° ${side}`;
  const tilt = camera.tilt_deg === 0 ? 'level' : `${Math.abs(camera.tilt_deg)}° ${way}`;
  return `Looks ${pan}, ${tilt}, zoom ${camera.zoom.toFixed(1)}.`;
}
