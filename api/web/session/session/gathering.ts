// What people of a session show each other beside the run: where they look, and notes at places.
import { as_list, as_number, as_object, as_text, read_point, type Point } from './message';

export interface Look {
  seat: number;
  from: Point;
  heading_deg: number; // clockwise from north
  tilt_deg: number; // up
  point: Point | null; // what is pointed at
}
export interface Note {
  note: number;
  seat: number;
  who: string;
  text: string;
  at: Point;
}

export function read_looks(value: unknown): Look[] {
  const made: Look[] = [];
  for (const one of as_list(value)) {
    const it = as_object(one);
    const seat = as_number(it?.seat);
    const from = read_point(it?.from);
    if (it === null || seat === null || from === null) continue;
    const [heading_deg, tilt_deg] = [as_number(it.heading_deg) ?? 0, as_number(it.tilt_deg) ?? 0];
    made.push({ seat, from, heading_deg, tilt_deg, point: read_point(it.point) });
  }
  return made;
}

export function read_notes(value: unknown): Note[] {
  const made: Note[] = [];
  for (const one of as_list(value)) {
    const it = as_object(one);
    const [note, seat] = [as_number(it?.note), as_number(it?.seat)];
    const at = read_point(it?.at);
    if (it === null || note === null || seat === null || at === null) continue;
    made.push({ note, seat, who: as_text(it.who), text: as_text(it.text), at });
  }
  return made;
}
