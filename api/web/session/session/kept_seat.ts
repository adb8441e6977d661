// The seat of this tab, for a reload: its resume token, in the tab's own storage and nowhere else.
//
// A tab that is duplicated brings a copy of that storage with it. So before a seat is taken up, the
// other tabs are asked whether one of them sits on it: a second tab is not a rival of the first.

const KEY = 'slackwater.session.seat';
const CHANNEL = 'slackwater.session.seats';
const ANSWER_TAKES_MS = 150;

export interface KeptSeat {
  session_id: string;
  token: string;
  name: string;
}

export function keep_seat(seat: KeptSeat | null): void {
  try {
    if (seat === null) sessionStorage.removeItem(KEY);
    else sessionStorage.setItem(KEY, JSON.stringify(seat));
  } catch {
    // a reload then asks for the token again
  }
}

function kept_seat(): KeptSeat | null {
  try {
    const it = JSON.parse(sessionStorage.getItem(KEY) ?? 'null') as Partial<KeptSeat> | null;
    if (typeof it?.session_id !== 'string' || typeof it.token !== 'string') return null;
    return {
      session_id: it.session_id,
      token: it.token,
      name: typeof it.name === 'string' ? it.name : '',
    };
  } catch {
    return null;
  }
}

/**
 * The tokens are told to no other tab: only a mark of them, enough to see that two are the same.
 */
function mark_of(token: string): string {
  let hash = 0;
  for (const letter of token) hash = (Math.imul(hash, 31) + letter.charCodeAt(0)) | 0;
  return String(hash);
}

/** Answers other tabs that ask for the seat we sit on. */
export function guard_seat(seat_now: () => string | null): void {
  if (typeof BroadcastChannel === 'undefined') return;
  const channel = new BroadcastChannel(CHANNEL);
  channel.onmessage = (event: MessageEvent<{ asks?: string }>) => {
    const token = seat_now();
    const asks = event.data.asks;
    if (token === null || asks === undefined) return;
    if (mark_of(token) === asks) channel.postMessage({ sits: asks });
  };
}

/** The seat to take up after a reload; nothing where there is none or another tab sits on it. */
export async function seat_to_take_up(): Promise<KeptSeat | null> {
  const seat = kept_seat();
  if (seat === null || typeof BroadcastChannel === 'undefined') return seat;
  const mark = mark_of(seat.token);
  const channel = new BroadcastChannel(CHANNEL);
  const is_taken = await new Promise<boolean>((resolve) => {
    channel.onmessage = (event: MessageEvent<{ sits?: string }>) => {
      if (event.data.sits === mark) resolve(true);
    };
    channel.postMessage({ asks: mark });
    setTimeout(() => resolve(false), ANSWER_TAKES_MS);
  });
  channel.close();
  if (is_taken) keep_seat(null);
  return is_taken ? null : seat;
}
