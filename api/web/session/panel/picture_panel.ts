// What the cameras of the chosen vehicle see, at their rate: fetched whenever the server says that
// there is a new picture, and drawn as it came.
import { choice, element, set_hidden, set_text } from '../../look/element';
import type { LastPicture } from '../scene/picture_view';
import type { Picture } from '../session/message';
import type { Panel, Station } from '../station';

const IS_OLD_MS = 5000;

export interface PicturePanel extends Panel {
  /** What is drawn in it; null: nothing yet. */
  last(): LastPicture | null;
}

export function picture_panel(station: Station): PicturePanel {
  const canvas = element('canvas', { role: 'img' });
  const note = element('p', { class: 'note' });
  const cameras = element('div', { class: 'cameras' });
  const box = element(
    'section',
    { class: 'picture' },
    element('h2', {}, 'Camera picture'),
    cameras,
    canvas,
    note,
  );
  let sensor = ''; // the chosen camera
  let listed = '';
  let drawn: Picture | null = null;
  let late_ms = Number.NaN; // what is drawn came so long after its moment
  let is_asking = false;

  const fetch_it = async (wanted: Picture): Promise<void> => {
    is_asking = true;
    try {
      const blob = await station.wire.picture(wanted.vehicle, wanted.sensor);
      const bitmap = blob === null ? null : await createImageBitmap(blob);
      if (bitmap === null || station.chosen !== wanted.vehicle || sensor !== wanted.sensor) return;
      canvas.width = bitmap.width;
      canvas.height = bitmap.height;
      canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
      bitmap.close();
      drawn = wanted;
      late_ms = station.clock_ms() - wanted.at;
    } catch {
      // No picture; the next one is asked for.
    } finally {
      is_asking = false;
    }
  };

  const list_cameras = (of_vehicle: Picture[]): void => {
    const names = of_vehicle.map((it) => it.sensor);
    if (!names.includes(sensor)) sensor = names[0] ?? '';
    const key = `${station.chosen} ${names.join()} ${sensor}`;
    if (key === listed) return;
    listed = key;
    drawn = null;
    const chosen = choice(
      'Camera',
      names.map((name) => [name, words_of(name)] as const),
      (name) => {
        sensor = name;
        show();
      },
    );
    chosen.show(sensor);
    cameras.replaceChildren(...(names.length > 1 ? [chosen.node] : []));
  };

  const show = (): void => {
    const { session, chosen } = station;
    const of_vehicle = [...session.pictures.values()].filter((it) => it.vehicle === chosen);
    set_hidden(box, of_vehicle.length === 0);
    if (of_vehicle.length === 0) return;
    list_cameras(of_vehicle);
    const last = of_vehicle.find((it) => it.sensor === sensor);
    if (last === undefined) return;
    canvas.style.aspectRatio = `${last.wide} / ${last.high}`;
    canvas.setAttribute(
      'aria-label',
      `What ${words_of(sensor)} of ${station.chosen_name()} sees`,
    );
    const is_drawn =
      drawn !== null && drawn.number === last.number && drawn.vehicle === last.vehicle;
    if (!is_drawn && !is_asking) void fetch_it(last);
    const age_ms = station.clock_ms() - (drawn?.at ?? last.at);
    note.classList.toggle('alarm', age_ms > IS_OLD_MS);
    set_text(note, picture_text(drawn, late_ms, age_ms));
  };
  return { box, show, last: () => drawn && { of: drawn, canvas } };
}

export function picture_text(drawn: Picture | null, late_ms: number, age_ms: number): string {
  if (drawn === null) return 'The first picture is on its way.';
  if (age_ms > IS_OLD_MS) return `No new picture for ${Math.floor(age_ms / 1000)} s.`;
  const late = Number.isFinite(late_ms) ? `, here ${(late_ms / 1000).toFixed(2)} s later` : '';
  return `At ${drawn.time_s.toFixed(1)} s of the run${late}.`;
}

function words_of(sensor: string): string {
  return sensor.replaceAll('_', ' ');
}
