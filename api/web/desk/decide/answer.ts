// One answer of the server, and the elements that show a value of it. Each names where its value
// stands and has it unrounded, so that what is shown can be held against the answer itself.
import { element } from '../../look/element';

export interface Answer<T> {
  readonly from: string; // what was asked: "/sites/bay/report"
  readonly body: T;
}

/** The value at "tasks.0.best.probability"; undefined where there is none. */
export function value_at(body: unknown, key: string): unknown {
  let at: unknown = body;
  for (const name of key.split('.')) {
    if (typeof at !== 'object' || at === null) return undefined;
    at = (at as Record<string, unknown>)[name];
  }
  return at;
}

export function told_by(answer: Answer<unknown>, key: string): Record<string, string> {
  const value = value_at(answer.body, key);
  const text = typeof value === 'string' ? value : JSON.stringify(value ?? null);
  return { 'data-from': answer.from, 'data-key': key, 'data-value': text };
}

/** A value as `text_of` reads it. */
export function told<V>(
  answer: Answer<unknown>,
  key: string,
  text_of: (value: V) => string,
): HTMLElement {
  const said = told_by(answer, key);
  return element('span', said, text_of(value_at(answer.body, key) as V));
}

export const ms_of = (time: string | null | undefined): number | null =>
  time === null || time === undefined ? null : Date.parse(time);
