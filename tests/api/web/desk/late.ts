// A made-up server whose answers come when a test says so, in the order it says.
import type { Desk } from 'page/look/desk';
import { Look } from 'page/look/look';
import type { Sites } from 'page/server/answers';
import { Server } from 'page/server/server';
import { first_view, View, type ViewValues } from 'page/view';

export interface Question {
  path: string; // with its query, decoded
  sent: string; // '' where nothing was
  answer(body: unknown, status?: number): Promise<void>;
}

export interface LateServer {
  desk: Desk;
  /** Asked and not answered yet, the oldest first. */
  waiting: Question[];
  /** Answers all that waits and has these words in its path, and what is asked after that. */
  answer(words: string, body: unknown, status?: number): Promise<void>;
}

const turns = async (): Promise<void> => {
  for (let i = 0; i < 30; i += 1) await Promise.resolve();
  await new Promise((over) => setTimeout(over, 0));
};

/** @param kept  answers that come at once, by the words of their path */
export function late_server(
  sites: Sites,
  kept: Record<string, unknown> = {},
  values: Partial<ViewValues> = {},
): LateServer {
  const waiting: Question[] = [];
  const ask = (path: string, init?: RequestInit): Promise<Response> =>
    new Promise((come) => {
      const said = decodeURIComponent(path).replaceAll('+', ' ');
      const at_once = Object.keys(kept).find((words) => said.includes(words));
      const send = (body: unknown, status = 200): void =>
        come(new Response(JSON.stringify(body), { status }));
      if (at_once !== undefined) return send(kept[at_once]);
      const question: Question = {
        path: said,
        sent: String(init?.body ?? ''),
        answer: async (body, status) => {
          waiting.splice(waiting.indexOf(question), 1);
          send(body, status);
          await turns();
        },
      };
      waiting.push(question);
    });
  const view = new View({ ...first_view(), ...values });
  const server = new Server(
    ask,
    (what) => view.tell(new Set([what])),
    () => view.values.site,
  );
  server.sites = sites;
  server.heard_ms = Date.parse(sites.now);
  const desk: Desk = {
    view,
    server,
    look: new Look(view),
    onChange: (listener) => view.listen(listener),
  };
  const answer = async (words: string, body: unknown, status = 200): Promise<void> => {
    await turns();
    const all = waiting.filter(({ path }) => path.includes(words));
    if (all.length === 0) throw new Error(`nobody asked for "${words}"`);
    for (const question of all) await question.answer(body, status);
  };
  return { desk, waiting, answer };
}

const PLACES = {
  a: { longitude_deg: -2.55, latitude_deg: 48.85 },
  b: { longitude_deg: 1, latitude_deg: 51 },
};
export const NOW = '2025-03-13T06:00:00Z';
export const TIMES = ['2025-03-13T06:00:00Z', '2025-03-13T07:00:00Z'];

const forecast = {
  instance: 'i1',
  day: '2025-03-12',
  issued: '2025-03-13T05:00:00Z',
  valid_from: TIMES[0] ?? '',
  valid_to: TIMES[1] ?? '',
  age_s: 3600,
  degraded: false,
  headline: '',
};

/** Two sites, a and b. */
export const two_sites = (): Sites => ({
  now: NOW,
  stale_after_s: 129_600,
  trouble: '',
  sites: (['a', 'b'] as const).map((id) => ({
    id,
    name: `Site ${id}`,
    place: PLACES[id],
    time_zone: null,
    status: 'ok',
    in_words: '',
    forecast,
    report: `/sites/${id}/report`,
    report_page: null,
  })),
});

export const site_answer = (id: 'a' | 'b'): unknown => ({
  id,
  name: `Site ${id}`,
  place: PLACES[id],
  columns: [{ ...PLACES[id], location: id, bed_m: 30 }],
  levels_m: [5],
  turbines: [{ ...PLACES[id], id: `${id.toUpperCase()}01`, hub_height_m: 90 }],
  tasks: [{ id: 'scan', name: 'Blade scan' }],
  forecast,
});

/** A coverage of all that a part of the page reads, each value the same. */
export const coverage = (id: 'a' | 'b', value: number): unknown => {
  const names = [
    'sea_water_speed',
    'sea_water_velocity_to_direction',
    'eastward_sea_water_velocity',
    'northward_sea_water_velocity',
    'wind_speed',
    'wind_from_direction',
    'sea_surface_wave_significant_height',
    'sea_surface_wave_from_direction',
  ];
  const axes = {
    t: { values: TIMES },
    x: { values: [PLACES[id].longitude_deg] },
    y: { values: [PLACES[id].latitude_deg] },
    z: { values: [5] },
  };
  const range = { shape: [2, 1], axisNames: ['t', 'z'], values: [value, value] };
  return {
    type: 'Coverage',
    domain: { axes },
    ranges: Object.fromEntries(names.map((name) => [name, range])),
  };
};
