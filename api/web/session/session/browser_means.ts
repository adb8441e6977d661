// The browser as the wire's world: its WebSocket, fetch and timers. Only our own origin is spoken
// to.
import type { Check, Means, Socket } from './wire';
import { as_object, as_text } from './message';
import { read_session_list, type SessionList } from './session_list';

async function check(session_id: string, token: string): Promise<Check> {
  try {
    const answer = await fetch(`/sessions/${encodeURIComponent(session_id)}/check`, {
      headers: token === '' ? {} : { Authorization: `Bearer ${token}` },
      cache: 'no-store',
      signal: AbortSignal.timeout(4000),
    });
    if (answer.ok) return { is: 'allowed' };
    if (answer.status >= 500) return { is: 'out_of_reach' };
    return { is: 'refused', text: await problem_text(answer) };
  } catch {
    return { is: 'out_of_reach' };
  }
}

/** Something of a session, for who has a seat in it; null: it cannot be had now. */
async function had(
  session_id: string,
  token: string,
  path: readonly (string | number)[],
  within_ms: number,
): Promise<Response | null> {
  const parts = ['', 'sessions', session_id, ...path].map((it) => encodeURIComponent(it));
  try {
    const answer = await fetch(parts.join('/'), {
      headers: { Authorization: `Bearer ${token}` },
      cache: 'no-store',
      signal: AbortSignal.timeout(within_ms),
    });
    return answer.ok ? answer : null;
  } catch {
    return null;
  }
}

async function picture(
  session_id: string,
  token: string,
  vehicle: number,
  sensor: string,
): Promise<Blob | null> {
  const answer = await had(session_id, token, ['pictures', vehicle, sensor], 4000);
  return answer === null ? null : answer.blob().catch(() => null);
}

async function surface(
  session_id: string,
  token: string,
  vehicle: number,
  surface: string,
): Promise<unknown> {
  // Megabytes, once.
  const answer = await had(session_id, token, ['surfaces', vehicle, surface], 60_000);
  return answer === null ? null : answer.json().catch(() => null);
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
  picture,
  surface,
  now_ms: () => performance.now(),
  after: (wait_ms, run) => setTimeout(run, wait_ms) as unknown as number,
  cancel: (timer) => clearTimeout(timer),
  chance: () => Math.random(),
};

/** Throws a sentence where the list cannot be had. */
export async function listed_sessions(): Promise<SessionList> {
  const answer = await asked('/sessions', {});
  if (!answer.ok) throw new Error(await problem_text(answer));
  return read_session_list(await answer.json());
}

/**
 * Begins a session with the token of a supervisor; its id. Throws a sentence where that is refused.
 */
export async function begin_session(offer: string, token: string): Promise<string> {
  const answer = await asked('/sessions', {
    method: 'POST',
    headers: { Authorization: `Bearer ${token}`, 'Content-Type': 'application/json' },
    body: JSON.stringify({ begin: offer }),
  });
  if (!answer.ok) throw new Error(await problem_text(answer));
  return as_text(as_object(await answer.json())?.id);
}

async function asked(path: string, how: RequestInit): Promise<Response> {
  try {
    return await fetch(path, {
      cache: 'no-store',
      signal: AbortSignal.timeout(4000),
      ...how,
    });
  } catch {
    throw new Error('The server is out of reach.');
  }
}
