// The sessions of a server: those to join, and those that a supervisor may begin.
import { as_list, as_number, as_object, as_text } from './message';

export interface ListedSession {
  id: string;
  name: string;
  state: string;
  /** Why it failed, else empty. */
  why: string;
  seats: number | null;
}

export interface SessionOffer {
  id: string;
  name: string;
}

export interface SessionList {
  sessions: ListedSession[];
  may_begin: SessionOffer[];
}

/** The answer of `GET /sessions`. */
export function read_session_list(value: unknown): SessionList {
  const list: SessionList = { sessions: [], may_begin: [] };
  const answer = as_object(value);
  for (const it of as_list(answer?.sessions)) {
    const session = as_object(it);
    const id = as_text(session?.id);
    if (session === null || id === '') continue;
    const seats = Array.isArray(session.seats) ? session.seats.length : as_number(session.seats);
    const name = as_text(session.name) || id;
    const state = as_text(session.state);
    list.sessions.push({ id, name, state, why: as_text(session.why), seats });
  }
  for (const it of as_list(answer?.may_begin)) {
    const offer = as_object(it);
    const id = as_text(offer?.id);
    if (id !== '') list.may_begin.push({ id, name: as_text(offer?.name) || id });
  }
  return list;
}

/** Those that can be joined now or in a moment. */
export function to_join(sessions: ListedSession[]): ListedSession[] {
  return sessions.filter((it) => !['ending', 'over', 'failed'].includes(it.state));
}

/** Whether it is something else in a moment. */
export function is_passing(session: ListedSession): boolean {
  return ['starting', 'ending'].includes(session.state);
}

/** How a session is told from the others: by its id too where two have one name. */
export function session_label(session: ListedSession, all: ListedSession[]): string {
  const is_alone = all.filter((it) => it.name === session.name).length === 1;
  const name = is_alone ? session.name : `${session.name}, ${session.id}`;
  const seats =
    session.seats === null ? '' : session.seats === 1 ? ', 1 person' : `, ${session.seats} people`;
  return `${name} (${session.state || 'state not told'}${seats})`;
}

/** The session that the page's address asks for, `?session=ID`; empty: none. */
export function session_of_address(search: string): string {
  return new URLSearchParams(search).get('session') ?? '';
}
