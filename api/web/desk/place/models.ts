// Our forecast at the place, the stored products that reach it and what was measured near it,
// quantity by quantity.
import type { ForecastInForce } from '../server/answers';
import { value_at, type Column } from '../server/coverage';
import {
  fetch_product,
  level_of,
  QUANTITIES,
  reaches,
  type Kind,
  type Product,
  type ProductTold,
} from '../server/products';
import type { Server } from '../server/server';
import type { Place } from '../view';
import { BESIDE } from './models_beside';
import { told, type Told } from './water';

const PERIOD = 'forecast_period';

export interface Model {
  letter: string; // at the end of its line
  name: string;
  is_measured: boolean;
  level_m: number | null; // asked for
  told: Told;
  runs: string[];
  notes: string[];
}
export interface Compared {
  kind: Kind;
  level_m: number | null; // of ours in the chart
  /** By level; of waves one, at 0. */
  ours: Map<number, Told>;
  models: Model[];
}

/** Null where no product of this kind reaches the place. */
export async function fetch_compared(
  server: Server,
  kind: Kind,
  products: Product[],
  forecast: ForecastInForce,
  place: Place,
  depth_m: number,
): Promise<Compared | null> {
  const there = products.filter(
    (one) => one.kind === kind && reaches(one, place) && measures_then(one, forecast),
  );
  if (there.length === 0) return null;
  const { size, way } = QUANTITIES[kind];
  const query = (level_m: number | null, names: string[]): string => {
    const asked = new URLSearchParams({
      coords: `POINT(${place.longitude_deg} ${place.latitude_deg})`,
      datetime: `${forecast.valid_from}/${forecast.valid_to}`,
      'parameter-name': names.join(),
      ...(level_m === null ? {} : { z: String(level_m) }),
      f: 'CoverageJSON',
    });
    return `position?${asked}`;
  };
  const levels = [...new Set(there.map((one) => level_of(one, depth_m)))];
  const of_ours = Promise.all(
    levels.map(async (level_m): Promise<[number, Told]> => [
      level_m ?? 0,
      await told(server, `${kind}/${query(level_m, [size, way])}`),
    ]),
  );
  const of_products = there.map(async (product, i): Promise<Model> => {
    const level_m = level_of(product, depth_m);
    const names = [size, way, ...BESIDE[kind], PERIOD].filter((name) =>
      product.parameters.includes(name),
    );
    const came = await fetch_product(server, product, query(level_m, names));
    return {
      letter: letter_of(i),
      name: product.is_measured ? measured_name(product, came, level_m) : product.name,
      is_measured: product.is_measured,
      level_m,
      told: said(came.columns[0], size, came.refused, came.notes),
      runs: came.runs,
      notes: came.notes,
    };
  });
  const [ours, models] = await Promise.all([of_ours, Promise.all(of_products)]);
  return { kind, level_m: levels[0] ?? null, ours: new Map(ours), models };
}

/** A mooring of another year has nothing to say, and is not listed as silent. */
function measures_then({ is_measured, from_ms, to_ms }: Product, of: ForecastInForce): boolean {
  return !is_measured || (from_ms <= Date.parse(of.valid_to) && to_ms >= Date.parse(of.valid_from));
}

/** "measured by FINO1, 0.8 km away, at 9.5 m": where the instrument hangs, if that is elsewhere. */
function measured_name(product: Product, came: ProductTold, level_m: number | null): string {
  const far = came.distance_m === null ? '' : `, ${(came.distance_m / 1000).toFixed(1)} km away`;
  const own_m = came.columns[0]?.levels_m[0];
  const is_there = level_m === null || own_m === undefined || own_m === level_m;
  return `${product.name}${far}${is_there ? '' : `, at ${own_m} m`}`;
}

/** Values that are all missing are told as the server explains them. */
function said(
  column: Column | undefined,
  size: string,
  refused: string | null,
  notes: string[],
): Told {
  if (refused !== null) return { column: null, refused };
  const is_there = (of: Column): boolean =>
    of.times_ms.some((_, time) => value_at(of, size, time, 0) !== null);
  if (column !== undefined && is_there(column)) return { column, refused: null };
  return { column: null, refused: notes.join(' ') || 'It has no value here in these hours.' };
}

/** A, B, … Z, A2, … */
export function letter_of(index: number): string {
  const letter = String.fromCharCode(65 + (index % 26));
  return index < 26 ? letter : `${letter}${Math.floor(index / 26) + 1}`;
}

/** What a product's value is, by its `forecast_period`: hours from the provider's run. */
export function what_it_is(column: Column, time: number, is_measured: boolean): string {
  if (is_measured) return 'measured';
  const hours = value_at(column, PERIOD, time, 0);
  if (hours === null) return 'the files do not say of which run';
  return hours === 0 ? 'analysis' : `forecast, ${hours} h from its run`;
}
