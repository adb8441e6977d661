// What vehicles inspect: surfaces made of patches, which of these are covered as well as the plan
// asks, and what the inspection would report as of now.
import { as_list, as_number, as_object, as_text, read_nodes, type Point } from './message';

const MOST_PATCHES = 1_000_000;

export interface Surface {
  vehicle: number;
  surface: string;
  name: string;
  kind: string;
  patches: number;
  seen: number; // share of it that is covered
  asked: number | null; // share that is asked for
  /** Of each patch 1 where it is covered. */
  covered: Uint8Array;
  /** Counts what was told of it, so that who draws it knows of news. */
  told: number;
}
export interface Finding {
  vehicle: number;
  kind: string;
  at: Point;
  size_m: number | null;
  by: string; // the instrument
}

export function surface_key(it: { vehicle: number; surface: string }): string {
  return `${it.vehicle} ${it.surface}`;
}

export function read_surfaces(value: unknown): Map<string, Surface> {
  const made = new Map<string, Surface>();
  for (const one of as_list(value)) {
    const it = as_object(one);
    const [vehicle, patches] = [as_number(it?.vehicle), as_number(it?.patches)];
    const surface = as_text(it?.surface);
    if (it === null || vehicle === null || surface === '' || patches === null) continue;
    if (!Number.isInteger(patches) || patches < 0 || patches > MOST_PATCHES) continue;
    made.set(surface_key({ vehicle, surface }), {
      vehicle,
      surface,
      name: as_text(it.name) || `Surface ${surface}`,
      kind: as_text(it.kind),
      patches,
      seen: as_number(it.seen) ?? 0,
      asked: as_number(it.asked),
      covered: new Uint8Array(patches),
      told: 0,
    });
  }
  return made;
}

/** Marks what is newly covered. Runs beyond the surface are cut. */
export function take_covered(surfaces: ReadonlyMap<string, Surface>, value: unknown): void {
  const it = as_object(value);
  const vehicle = as_number(it?.vehicle);
  if (it === null || vehicle === null) return;
  const of = surfaces.get(surface_key({ vehicle, surface: as_text(it.surface) }));
  if (of === undefined) return;
  for (const run of as_list(it.runs)) {
    const [first, count] = as_list(run).map(as_number);
    if (first == null || count == null || first < 0 || count <= 0) continue;
    of.covered.fill(1, Math.floor(first), Math.floor(first) + Math.floor(count));
  }
  of.seen = as_number(it.seen) ?? of.seen;
  of.told += 1;
}

/** All of one vehicle; nothing: not told of any vehicle. */
export function read_findings(value: unknown): { vehicle: number; found: Finding[] } | null {
  const it = as_object(value);
  const vehicle = as_number(it?.vehicle);
  if (it === null || vehicle === null) return null;
  const found: Finding[] = [];
  for (const one of as_list(it.findings)) {
    const finding = as_object(one);
    const [at] = read_nodes([finding?.at]);
    if (finding === null || at === undefined) continue;
    const size_m = as_number(finding.size_m);
    const kind = as_text(finding.kind) || 'finding';
    found.push({ vehicle, kind, at, size_m, by: as_text(finding.by) });
  }
  return { vehicle, found };
}
