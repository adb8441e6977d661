// What is signed: a decision for each task that one was taken of, as the server takes it.
import type { Decision } from './answers';

export interface Wish {
  key: string; // of its field
  task: string;
  name: string;
  turbine: string | null;
  start: string;
  decided: 'go' | 'no_go';
  why: string;
  said: string; // what the program says of the start
}

/** The body of POST /sites/ID/decisions. */
export interface Signed {
  task: string;
  turbine?: string;
  start: string;
  decided: 'go' | 'no_go';
  by: string;
  note: string;
  hand_over: string;
  forecast: string; // that was looked at
  in_place_of: number | null; // the record that was seen to count
}

/** The record that counts for a start; of two writers the server then takes the first. */
export function counting(
  decisions: readonly Decision[],
  { task, turbine, start }: Pick<Wish, 'task' | 'turbine' | 'start'>,
): Decision | undefined {
  const at_ms = Date.parse(start);
  return decisions.find(
    (it) =>
      it.counts && it.task === task && it.turbine === turbine && Date.parse(it.start) === at_ms,
  );
}

/** A record has one line of each. */
export function one_line(text: string): string {
  return text
    .split(/\s*\n\s*/)
    .map((part) => part.trim())
    .filter((part) => part !== '')
    .join(' / ');
}

export function signed(
  wish: Wish,
  by: string,
  hand_over: string,
  forecast: string,
  decisions: readonly Decision[],
): Signed {
  const { task, turbine, start, decided, why } = wish;
  return {
    task,
    ...(turbine === null ? {} : { turbine }),
    start,
    decided,
    by: by.trim(),
    note: one_line(why),
    hand_over: one_line(hand_over),
    forecast,
    in_place_of: counting(decisions, wish)?.id ?? null,
  };
}
