// The map in words: each column with its water at the slider's hour.
import type { Desk } from '../look/desk';
import { element, scroll_region } from '../../look/element';
import type { SiteMap } from '../server/answers';
import type { Place } from '../view';
import type { Weather } from './field';

export function column_table(
  { look }: Desk,
  site: () => SiteMap | null,
  weather_at: (place: Place) => Weather,
): { node: HTMLElement; show: () => void } {
  const rows = element('tbody');
  const heads = ['Column', 'Bed', 'Current', 'to', 'Wind 10 m', 'from', 'Waves', 'Period', 'from'];
  const head = element('tr', {}, ...heads.map((text) => element('th', { scope: 'col' }, text)));
  const table = element('table', {}, element('thead', {}, head), rows);
  const node = element(
    'details',
    { class: 'columns' },
    element('summary', {}, 'Columns as a table'),
    scroll_region('Columns as a table', table),
  );
  const show = (): void => {
    if (!node.open) return;
    rows.replaceChildren(
      ...(site()?.columns ?? []).map((column) => {
        const it = weather_at(column);
        const cells = [
          look.metres(column.bed_m),
          look.speed(it.current_m_s, 2),
          look.direction(it.current_to_deg),
          look.speed(it.wind_m_s),
          look.direction(it.wind_from_deg),
          look.metres(it.wave_height_m, 1),
          it.wave_period_s === null ? '–' : `${it.wave_period_s.toFixed(1)} s`,
          look.direction(it.wave_from_deg),
        ];
        return element(
          'tr',
          {},
          element('th', { scope: 'row' }, column.location),
          ...cells.map((text) => element('td', {}, text)),
        );
      }),
    );
  };
  node.addEventListener('toggle', show);
  return { node, show };
}
