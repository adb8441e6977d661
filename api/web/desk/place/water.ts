// All that the server forecasts at one place: asked for once, for all hours and levels.
import type { ForecastInForce, SiteMap } from '../server/answers';
import type { Column } from '../server/coverage';
import { Refused, type Server } from '../server/server';
import type { Place } from '../view';

/** A column of values, or what the server said instead. */
export type Told = { column: Column; refused: null } | { column: null; refused: string };

export interface Water {
  currents: Told;
  wind: Told;
  waves: Told;
  tide: Told;
}

export const NO_TIDE = 'No tide is served for this place.';
const NO_TIDE_HERE: Told = { column: null, refused: NO_TIDE };
const HEIGHT_M = 10;

export async function fetch_water(
  server: Server,
  site: SiteMap,
  forecast: ForecastInForce,
  place: Place,
): Promise<Water> {
  const heights = [...new Set([HEIGHT_M, ...hub_heights(site)])].sort((a, b) => a - b);
  const ask = (collection: string, more: Record<string, string> = {}): Promise<Told> => {
    const query = new URLSearchParams({
      coords: `POINT(${place.longitude_deg} ${place.latitude_deg})`,
      datetime: `${forecast.valid_from}/${forecast.valid_to}`,
      ...more,
      f: 'CoverageJSON',
    });
    return told(server, `${collection}/position?${query}`);
  };
  const [currents, wind, waves, tide] = await Promise.all([
    ask('currents'),
    ask('wind', { z: heights.join() }),
    ask('waves'),
    has_tide(server).then((is_there) => (is_there ? ask('sea-level') : NO_TIDE_HERE)),
  ]);
  return { currents, wind, waves, tide };
}

export async function told(server: Server, query: string): Promise<Told> {
  try {
    const [column] = await server.columns(query);
    if (column !== undefined && column.times_ms.length > 0) return { column, refused: null };
    return { column: null, refused: 'The server has no values here.' };
  } catch (problem) {
    if (!(problem instanceof Refused)) throw problem;
    return { column: null, refused: problem.detail };
  }
}

function hub_heights({ hub_height_m, turbines }: SiteMap): number[] {
  const all = [hub_height_m, ...turbines.map((turbine) => turbine.hub_height_m)];
  return [...new Set(all.filter((height) => height !== null))].slice(0, 3);
}

/** What current, wind and waves all say in the same words, as for a place that is out of reach. */
export function said_by_all({ currents, wind, waves }: Water): string | null {
  const { refused } = currents;
  return refused === wind.refused && refused === waves.refused ? refused : null;
}

/** Not every server has a tide; asking for one that is not there would read as a fault. */
async function has_tide(server: Server): Promise<boolean> {
  try {
    const { collections } = await server.get<{ collections: { id: string }[] }>('/collections');
    return collections.some(({ id }) => id === 'sea-level');
  } catch (problem) {
    if (!(problem instanceof Refused)) throw problem;
    return false;
  }
}
