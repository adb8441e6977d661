// Stored products, and what instruments measured, as the server lists them among its collections:
// each with its own values.
import type { Place } from '../view';
import { read_coverages, type Column } from './coverage';
import { Refused, type Server } from './server';

export const KINDS = ['currents', 'wind', 'waves'] as const;
export type Kind = (typeof KINDS)[number];

/** By CF name: how much, and which way. */
export const QUANTITIES: Record<Kind, { size: string; way: string; word: 'to' | 'from' }> = {
  currents: {
    size: 'sea_water_speed',
    way: 'sea_water_velocity_to_direction',
    word: 'to',
  },
  wind: { size: 'wind_speed', way: 'wind_from_direction', word: 'from' },
  waves: {
    size: 'sea_surface_wave_significant_height',
    way: 'sea_surface_wave_from_direction',
    word: 'from',
  },
};
const WIND_M = 10;

export interface Product {
  id: string;
  kind: Kind;
  name: string;
  is_measured: boolean; // at one place, by instruments
  /** West, south, east, north; west > east across the antimeridian. */
  boxes: [number, number, number, number][];
  /** Of its levels, depth down or height up; null where it has none. */
  levels: { least_m: number; most_m: number } | null;
  parameters: string[];
  from_ms: number;
  to_ms: number;
}

/** What was asked of a product: its values, or in their place what the server said. */
export interface ProductTold {
  columns: Column[];
  /** Of all its cells, those without a value too. */
  axes: { x: number[]; y: number[] };
  refused: string | null;
  distance_m: number | null; // of what was measured, from the place that was asked about
  runs: string[]; // as the server says them: "analysis", "forecast of TIME"
  notes: string[];
}

interface Collection {
  id: string;
  title?: string;
  keywords?: string[];
  extent?: {
    spatial?: { bbox?: number[][] };
    temporal?: { interval?: string[][] };
    vertical?: { interval?: (string | number)[][] };
  };
  parameter_names?: Record<string, unknown>;
}

interface Answer {
  domain?: { axes?: { x?: { values?: number[] }; y?: { values?: number[] } } };
  'slackwater:provenance'?: { runs?: string[]; notes?: string[]; distance_m?: number };
}

export async function fetch_products(server: Server): Promise<Product[]> {
  const { collections } = await server.get<{ collections: Collection[] }>('/collections');
  return collections.flatMap((collection) => {
    const { id, keywords = [], extent, parameter_names = {} } = collection;
    const kind = KINDS.find((one) => keywords.includes(one));
    const is_measured = keywords.includes('measured');
    if (!(keywords.includes('product') || is_measured) || kind === undefined) return [];
    const [from = '', to = ''] = extent?.temporal?.interval?.[0] ?? [];
    const [least_m = NaN, most_m = NaN] = extent?.vertical?.interval?.[0]?.map(Number) ?? [];
    return [
      {
        id,
        kind,
        name: (collection.title ?? id).replace(/^\w+ (of )?/, ''),
        is_measured,
        boxes: (extent?.spatial?.bbox ?? []).flatMap((box) => corners(box)),
        levels: least_m <= most_m ? { least_m, most_m } : null,
        parameters: Object.keys(parameter_names),
        from_ms: Date.parse(from),
        to_ms: Date.parse(to),
      },
    ];
  });
}

/** Of four numbers or six, with levels between. */
function corners(box: number[]): [number, number, number, number][] {
  const [west, south, east, north] = box.length === 6 ? [0, 1, 3, 4].map((i) => box[i]) : box;
  if (west === undefined || south === undefined) return [];
  if (east === undefined || north === undefined) return [];
  return [[west, south, east, north]];
}

export function reaches({ boxes }: Product, { longitude_deg, latitude_deg }: Place): boolean {
  return boxes.some(([west, south, east, north]) => {
    const turned = ((((longitude_deg - west) % 360) + 360) % 360) + west; // east of the west side
    const east_of_west = east < west ? east + 360 : east;
    return latitude_deg >= south && latitude_deg <= north && turned <= east_of_west;
  });
}

/** Where a product is asked: at the depth that is chosen, at 10 m, or at its own height. */
export function level_of({ kind, levels }: Product, depth_m: number): number | null {
  if (kind === 'waves') return null;
  if (kind === 'currents') return depth_m;
  if (levels === null) return WIND_M;
  return Math.min(levels.most_m, Math.max(levels.least_m, WIND_M));
}

/** @param query  its name and its words: "position?coords=…" */
export async function fetch_product(
  server: Server,
  product: Product,
  query: string,
): Promise<ProductTold> {
  try {
    const answer = await server.get<Answer>(
      `/collections/${encodeURIComponent(product.id)}/${query}`,
    );
    const { runs = [], notes = [], distance_m = null } = answer['slackwater:provenance'] ?? {};
    const columns = read_coverages(answer).filter(({ times_ms }) => times_ms.length > 0);
    const { x, y } = answer.domain?.axes ?? {};
    const axes = { x: x?.values ?? [], y: y?.values ?? [] };
    return { columns, axes, refused: null, distance_m, runs, notes };
  } catch (problem) {
    if (!(problem instanceof Refused)) throw problem;
    const axes = { x: [], y: [] };
    return { columns: [], axes, refused: problem.detail, distance_m: null, runs: [], notes: [] };
  }
}
