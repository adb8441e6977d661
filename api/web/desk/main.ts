// The page of the desk, put together. Every number on it was told by the server.
import { decidePart } from './decide/decide';
import { use_palette } from './look/colours';
import type { Desk } from './look/desk';
import { by_id, set_hidden, set_text } from '../look/element';
import { keep_looks, kept_looks } from './look/kept';
import { Look } from './look/look';
import { listen_to_printer } from './look/paper';
import { Tabs } from './look/tabs';
import { link_words, topPart } from './look/top';
import { mapPart } from './map/map';
import { placePart } from './place/place';
import { Server } from './server/server';
import { timePart } from './time/time';
import { KEPT, first_view, hash_of, read_hash, View } from './view';
import { whatIfPart } from './what_if/what_if';

by_id('built-without').remove();
const otherwise = first_view(kept_looks());
const view = new View(read_hash(location.hash, otherwise));
const server = new Server(
  fetch.bind(window),
  (what) => view.tell(new Set([what])),
  () => view.values.site,
);
const desk: Desk = {
  view,
  server,
  look: new Look(view),
  onChange: (listener) => view.listen(listener),
};
use_palette(view.values.palette);

// First of all listeners: what the parts read must be in order before they draw.
desk.onChange((changed) => {
  if (changed.has('palette')) use_palette(view.values.palette);
  if (changed.has('sites')) choose_site();
  if (changed.has('sites') || changed.has('site')) {
    const site = server.sites?.sites.find(({ id }) => id === view.values.site);
    desk.look.site_zone = site?.time_zone ?? null;
  }
  if (changed.has('sites') || changed.has('site')) name_page();
  if (changed.has('server') || changed.has('clock')) say_link();
});

by_id('top').append(topPart(desk));
by_id('map').append(mapPart(desk));
by_id('time').append(timePart(desk));
new Tabs(desk, by_id('tabs'), by_id('panel'), [
  ['decide', 'Decide', decidePart],
  ['place', 'Water at the place', placePart],
  ['what_if', 'What if', whatIfPart],
]);
for (const id of ['tabs', 'map', 'time', 'panel']) by_id(id).hidden = false;
by_id('skip').addEventListener('click', (event) => {
  event.preventDefault(); // the address is the view's
  by_id('panel').focus();
});

let writing = 0;
desk.onChange((changed) => {
  if (KEPT.some((key) => changed.has(key))) keep_looks(view.values);
  clearTimeout(writing);
  writing = window.setTimeout(() => {
    const hash = hash_of(view.values);
    if (hash !== location.hash) history.replaceState(null, '', hash);
  }, 250);
});
window.addEventListener('hashchange', () => {
  const site = view.values.site; // where a link names none
  view.set(read_hash(location.hash, { ...first_view(kept_looks()), site }));
});

function choose_site(): void {
  const known = server.sites?.sites ?? [];
  if (view.values.site === '' && known[0] !== undefined) view.set({ site: known[0].id });
}

function name_page(): void {
  const site = server.sites?.sites.find(({ id }) => id === view.values.site);
  document.title = [...(site === undefined ? [] : [site.name]), 'The desk', 'Slackwater'].join(
    ' · ',
  );
}

function say_link(): void {
  const notice = by_id('notice');
  set_text(notice, link_words(server, desk.look));
  set_hidden(notice, server.link.is === 'there');
}

listen_to_printer(
  () => view.values.palette,
  () => `${desk.look.time(server.now_ms())} ${desk.look.zone_name}`,
);
void server.watch();
