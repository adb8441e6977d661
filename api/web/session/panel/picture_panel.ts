// What the cameras of the chosen vehicle see, at their rate: fetched whenever the server says that
// there is a new picture, and drawn as it came.
import { choice, element, set_hidden, set_text } from '../../look/element';
import type { LastPicture } from '../scene/picture_view';
import type { Picture } from '../session/message';
import type { Session } from '../session/state';
import type { Panel, Station } from '../station';

const IS_OLD_MS = 5000;

export interface PicturePanel extends Panel {
  /** What is drawn in it; null: nothing yet of this session and vehicle. */
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
  // Each welcome brings others: it may be another session, or a server that began again.
  let told: Session['pictures'] | null = null;

  const forget = (): void => {
    listed = '';
    drawn = null;
  };
  const is_drawn = (it: Picture): boolean =>
    drawn !== null &&
    drawn.number === it.number &&
    drawn.at === it.at &&
    drawn.vehicle === it.vehicle;
  const age_ms = (it: Picture): number => station.clock_ms() - it.at;

  const fetch_it = async (wanted: Picture): Promise<void> => {
    is_asking = true;
    const { pictures } = station.session;
    try {
      const blob = await station.wire.picture(wanted.vehicle, wanted.sensor);
      const bitmap = blob === null ? null : await createImageBitmap(blob);
      const is_wanted =
        station.session.pictures === pictures &&
        station.chosen === wanted.vehicle &&
        sensor === wanted.sensor;
      if (bitmap === null || !is_wanted) return;
      canvas.width = bitmap.width;
      canvas.height = bitmap.height;
      canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
      bitmap.close();
      drawn = wanted;
      late_ms = age_ms(wanted);
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
    if (session.pictures !== told) forget();
    told = session.pictures;
    const of_vehicle = [...session.pictures.values()].filter((it) => it.vehicle === chosen);
    set_hidden(box, of_vehicle.length === 0);
    if (of_vehicle.length === 0) {
      forget();
      return;
    }
    list_cameras(of_vehicle);
    const last = of_vehicle.find((it) => it.sensor === sensor);
    if (last === undefined) return;
    canvas.style.aspectRatio = `${last.wide} / ${last.high}`;
    canvas.setAttribute(
      'aria-label',
      `What ${words_of(sensor)} of ${station.chosen_name()} sees`,
    );
    if (!is_drawn(last) && !is_asking) void fetch_it(last);
    const shown_age_ms = age_ms(drawn ?? last);
    note.classList.toggle('alarm', shown_age_ms > IS_OLD_MS);
    set_text(note, picture_text(drawn, late_ms, shown_age_ms));
  };
  const last = (): LastPicture | null => {
    const { pictures } = station.session;
    if (drawn === null || pictures !== told || drawn.vehicle !== station.chosen) return null;
    return { of: drawn, canvas, is_old: age_ms(drawn) > IS_OLD_MS };
  };
  return { box, show, last };
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
