// The browser as the wire's world: its WebSocket, fetch and timers. Only our own origin is spoken
// to.
import type { Check, Means, Socket } from './wire';
import { as_list, as_number, as_object, as_text } from './message';

async function check(session_id: string, token: string): Promise<Check> {
  try {
    const answer = await fetch(`/sessions/${encodeURIComponent(session_id)}/check`, {
      headers: { Authorization: `Bearer ${token}` },
      cache: 'no-store',
      credentials: 'omit',
      signal: AbortSignal.timeout(4000),
    });
    if (answer.ok) return { is: 'allowed' };
    if (answer.status >= 500) return { is: 'out_of_reach' };
    return { is: 'refused', text: await problem_text(answer) };
  } catch {
    return { is: 'out_of_reach' };
  }
}

async function problem_text(answer: Response): Promise<string> {
  const fallback = `The server refused (${answer.status}).`;
  try {
    const problem = as_object(await answer.json());
    return as_text(problem?.detail) || as_text(problem?.title) || fallback;
  } catch {
    return fallback;
  }
}

export const browser_means: Means = {
  open: (session_id, protocols) => {
    const scheme = location.protocol === 'https:' ? 'wss:' : 'ws:';
    const address = `${scheme}//${location.host}/sessions/${encodeURIComponent(session_id)}/socket`;
    return new WebSocket(address, protocols) as Socket;
  },
  check,
  now_ms: () => performance.now(),
  after: (wait_ms, run) => setTimeout(run, wait_ms) as unknown as number,
  cancel: (timer) => clearTimeout(timer),
  chance: () => Math.random(),
};

export interface ListedSession {
  id: string;
  name: string;
  state: string;
  seats: number | null;
}

/** Throws a sentence where the list cannot be had. */
export async function listed_sessions(): Promise<ListedSession[]> {
  let answer: Response;
  try {
    answer = await fetch('/sessions', {
      cache: 'no-store',
      credentials: 'omit',
      signal: AbortSignal.timeout(4000),
    });
  } catch {
    throw new Error('The server is out of reach.');
  }
  if (!answer.ok) throw new Error(await problem_text(answer));
  const listed: ListedSession[] = [];
  for (const it of as_list(as_object(await answer.json())?.sessions)) {
    const session = as_object(it);
    const id = as_text(session?.id);
    if (session === null || id === '') continue;
    const seats = Array.isArray(session.seats) ? session.seats.length : as_number(session.seats);
    listed.push({ id, name: as_text(session.name) || id, state: as_text(session.state), seats });
  }
  return listed;
}
