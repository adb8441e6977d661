// The cells of a stored product around what the map shows, at one hour, with its own values.
import type { Column } from '../server/coverage';
import {
  fetch_product,
  level_of,
  QUANTITIES,
  type Product,
  type ProductTold,
} from '../server/products';
import type { Server } from '../server/server';
import { time_of_ms } from '../view';

export interface Box {
  west: number;
  south: number;
  east: number;
  north: number;
}
export interface Asked {
  product: Product;
  at_ms: number;
  depth_m: number;
}
/** Cells, or why there are none; `too_many`: how many there would be. */
export interface Cells {
  columns: Column[];
  level_m: number | null;
  refused: string | null;
  too_many: number | null;
}

export const MOST_CELLS = 400;
const FIRST_SIDE_DEG = 0.02; // finer than any product that we know
const MOST_SIDE_DEG = 6;

export async function fetch_cells(server: Server, asked: Asked, view: Box): Promise<Cells> {
  const { product } = asked;
  const level_m = level_of(product, asked.depth_m);
  const none = { columns: [], level_m, too_many: null };
  const within = common(product, view);
  if (within === null) {
    return { ...none, refused: 'The product does not reach what the map shows.' };
  }
  const apart = await cells_apart(server, asked, within);
  if ('refused' in apart) return { ...none, refused: apart.refused };
  // One more on each side: a box without a cell would be answered at its middle, which is none.
  const box = {
    west: within.west - apart.x_deg,
    south: Math.max(-90, within.south - apart.y_deg),
    east: within.east + apart.x_deg,
    north: Math.min(90, within.north + apart.y_deg),
  };
  const count = Math.round(
    ((box.east - box.west) / apart.x_deg) * ((box.north - box.south) / apart.y_deg),
  );
  if (count > MOST_CELLS) return { ...none, refused: null, too_many: count };
  const told = await ask(server, asked, box);
  if (told.refused !== null) return { ...none, refused: told.refused };
  const { columns } = told;
  if (columns.length > MOST_CELLS) return { ...none, refused: null, too_many: columns.length };
  if (columns.length === 0) {
    const why = told.notes.join(' ') || 'The product has no value in what the map shows.';
    return { ...none, refused: why };
  }
  return { columns, level_m, refused: null, too_many: null };
}

/** What of the view a product covers; null for nothing. */
export function common({ boxes }: Product, view: Box): Box | null {
  for (const [west, south, east, north] of boxes) {
    // The antimeridian lies in one of them: the view as it is, and the server cuts it.
    if (west > east || view.west > view.east || east > 180) return view;
    const both = {
      west: Math.max(west, view.west),
      south: Math.max(south, view.south),
      east: Math.min(east, view.east),
      north: Math.min(north, view.north),
    };
    if (both.west <= both.east && both.south <= both.north) return both;
  }
  return null;
}

type Apart = { x_deg: number; y_deg: number } | { refused: string };
const known = new Map<string, Apart>(); // by product

/** How far its cells are apart, as the server's own cells tell: in ever wider boxes, each small. */
async function cells_apart(server: Server, asked: Asked, within: Box): Promise<Apart> {
  const found = known.get(asked.product.id);
  if (found !== undefined) return found;
  const x = (within.west + within.east) / 2;
  const y = (within.south + within.north) / 2;
  const widest = Math.max(within.east - within.west, within.north - within.south);
  let refused: string | null = null;
  for (let side = FIRST_SIDE_DEG; side < MOST_SIDE_DEG; side *= 3) {
    const box = {
      west: x - side,
      south: Math.max(-90, y - side),
      east: x + side,
      north: Math.min(90, y + side),
    };
    const told = await ask(server, asked, box);
    refused = told.refused;
    const x_deg = step_of(told.axes.x);
    const y_deg = step_of(told.axes.y);
    if (refused !== null && side > widest) break; // on land, or out of its hours: so it will be
    if (x_deg === null || y_deg === null) continue;
    const apart = { x_deg, y_deg };
    known.set(asked.product.id, apart);
    return apart;
  }
  // Of one row or one cell alone: there are not many.
  return refused === null ? { x_deg: 1, y_deg: 1 } : { refused };
}

/** The least step between different values; null where all are one. */
export function step_of(values: number[]): number | null {
  const order = [...values].sort((a, b) => a - b);
  const steps = order.slice(1).map((value, i) => value - (order[i] ?? value));
  const least = Math.min(...steps.filter((step) => step > 1e-6));
  return Number.isFinite(least) ? least : null;
}

function ask(server: Server, { product, at_ms, depth_m }: Asked, box: Box): Promise<ProductTold> {
  const { size, way } = QUANTITIES[product.kind];
  const level_m = level_of(product, depth_m);
  const sides = [box.west, box.south, box.east, box.north].map((side) => side.toFixed(4));
  const query = new URLSearchParams({
    bbox: sides.join(),
    datetime: time_of_ms(at_ms),
    'parameter-name': [size, way].filter((name) => product.parameters.includes(name)).join(),
    ...(level_m === null ? {} : { z: String(level_m) }),
    f: 'CoverageJSON',
  });
  return fetch_product(server, product, `cube?${query}`);
}
