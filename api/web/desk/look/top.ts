// The line on top: the site, what is in force there in words, and how the page shows things.
import type { Desk } from './desk';
import { choice, element, set_hidden, set_text } from '../../look/element';
import type { Look } from './look';
import type { Server } from '../server/server';

export function topPart(desk: Desk): HTMLElement {
  const { view, server } = desk;
  const site = element('select', { 'aria-label': 'Site' });
  site.addEventListener('change', () =>
    view.set({ site: site.value, place: null, map: null, at_ms: null }),
  );
  const status = element('span', { class: 'badge status' });
  const words = element('p', { class: 'words' });
  const trouble = element('p', { class: 'problem', role: 'alert' });

  const palette = choice(
    'Palette',
    [
      ['day', 'Day'],
      ['dusk', 'Dusk'],
      ['night', 'Night'],
    ],
    (palette) => view.set({ palette }),
  );
  const speed = choice(
    'Speed in',
    [
      ['m/s', 'm/s'],
      ['knots', 'knots'],
    ],
    (speed) => view.set({ speed }),
  );
  const clock = choice(
    'Times in',
    [
      ['utc', 'UTC'],
      ['site', 'Site time'],
    ],
    (clock) => view.set({ clock }),
  );
  const directions = choice(
    'Directions in',
    [
      ['degrees', '000°'],
      ['compass', 'Compass'],
    ],
    (to) => view.set({ directions: to }),
  );
  const report = element('a', {}, 'Report');
  const data = element('a', {}, 'Data');
  const pages = element('nav', { class: 'pages', 'aria-label': 'More pages of this site' });
  pages.append(report, data);
  // Folded away where there is no room for it.
  const looks = element(
    'details',
    { class: 'looks', open: matchMedia('(min-width: 701px)').matches },
    element('summary', {}, 'Units, colours and pages'),
    palette.node,
    speed.node,
    clock.node,
    directions.node,
    pages,
  );

  const show = (): void => {
    palette.show(view.values.palette);
    speed.show(view.values.speed);
    clock.show(view.values.clock);
    directions.show(view.values.directions);
    const sites = server.sites?.sites ?? [];
    if ([...site.options].map(({ value }) => value).join() !== sites.map(({ id }) => id).join()) {
      site.replaceChildren(...sites.map(({ id, name }) => element('option', { value: id }, name)));
    }
    site.value = view.values.site;
    const it = sites.find(({ id }) => id === view.values.site);
    set_hidden(site, sites.length === 0);
    const is_gone = server.link.is === 'gone';
    status.dataset.status = is_gone ? 'gone' : (it?.status ?? '');
    const as_of = is_gone ? `, as of ${desk.look.hour(server.heard_ms)}` : '';
    set_text(status, it === undefined ? '' : `${STATUS[it.status]}${as_of}`);
    set_hidden(status, it === undefined);
    set_text(words, words_of(desk));
    report.href = it?.report_page ?? '';
    set_hidden(report, !it?.report_page);
    data.href = `/?f=html#${encodeURIComponent(view.values.site)}`;
    set_text(trouble, server.sites?.trouble ?? '');
    set_hidden(trouble, (server.sites?.trouble ?? '') === '');
  };
  desk.onChange(show);
  show();
  return element(
    'div',
    { class: 'top' },
    element('h1', {}, 'The desk'),
    site,
    status,
    words,
    looks,
    trouble,
  );
}

const STATUS = {
  ok: 'Forecast in force',
  degraded: 'Degraded',
  stale: 'Old forecast',
  hindcast: 'Of a past day',
  unreadable: 'Cannot be read',
  no_forecast: 'No forecast',
} as const;

/** Empty while the server is there. */
export function link_words({ link, heard_ms }: Server, look: Look): string {
  if (link.is === 'there') return '';
  const what =
    link.why === null ? 'The server does not answer' : `The server is in trouble: ${link.why}`;
  const heard =
    heard_ms === null
      ? 'it was not heard yet'
      : `what it shows was last heard ${look.time(heard_ms)} ${look.zone_name}`;
  return `${what.replace(/\.$/, '')}. The page tries again by itself; ${heard}.`;
}

/** What stands in place of a forecast, and what to do. */
export function words_of({ server, view }: Desk): string {
  if (server.sites === null || server.heard_ms === null) return 'Asking the server …';
  const sites = server.sites.sites;
  if (sites.length === 0) {
    return 'No site has a forecast yet. Make one: slackwater forecast --site SITE';
  }
  const it = sites.find(({ id }) => id === view.values.site);
  if (it === undefined) {
    return `The server has no site "${view.values.site}". Choose one of the list.`;
  }
  return it.in_words;
}
