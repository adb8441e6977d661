// What is laid in the water and does not move: cables, mooring lines.
import { as_list, as_number, as_object, as_text, read_nodes, type Point } from './message';

export interface Cable {
  id: string;
  route: Point[]; // on the bed
  burial_m: number | null; // how deep in it; null: nobody says
}
export interface Mooring {
  id: string;
  fairlead: Point;
  anchor: Point;
}

export function read_cables(value: unknown): Cable[] {
  const made: Cable[] = [];
  for (const one of as_list(value)) {
    const it = as_object(one);
    const route = read_nodes(it?.route);
    if (it === null || route.length < 2) continue;
    const burial_m = as_number(it.burial_m);
    made.push({ id: as_text(it.id) || `Cable ${made.length + 1}`, route, burial_m });
  }
  return made;
}

export function read_moorings(value: unknown): Mooring[] {
  const made: Mooring[] = [];
  for (const one of as_list(value)) {
    const it = as_object(one);
    const [fairlead, anchor] = read_nodes([it?.fairlead, it?.anchor]);
    if (it === null || fairlead === undefined || anchor === undefined) continue;
    made.push({ id: as_text(it.id) || `Mooring ${made.length + 1}`, fairlead, anchor });
  }
  return made;
}

/** Nobody says is not the same as lies open. */
export function is_buried(cable: Cable): boolean {
  return cable.burial_m !== null && cable.burial_m > 0;
}

export function length_m(route: readonly Point[]): number {
  return route.slice(1).reduce((sum, to, i) => {
    const from = route[i]!;
    const level_m = Math.hypot(to.east_m - from.east_m, to.north_m - from.north_m);
    return sum + Math.hypot(level_m, to.up_m - from.up_m);
  }, 0);
}
