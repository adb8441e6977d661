// The link to the server: takes a seat, keeps it over a cut, and says plainly how it stands.
//
// The token goes into the sub-protocol and the Authorization header, never into an address. A
// browser does not show a page why a WebSocket was refused, so each try asks GET
// /sessions/{id}/check before. Nothing is queued: what cannot be sent at once is not sent at all.
import { as_number, as_object, as_text, type Json } from './message';
import { SessionClock } from './clock';

export const SEAT_IS_KEPT_MS = 30_000;
const SERVER_IS_LATER_MS = 15_000;
const TRIED_AT_MOST_MS = 600_000;
const PROTOCOL = 'slackwater.session.v1';
const SAW_EVERY_FRAMES = 5;
const SAW_EVERY_MS = 400;
const LOST_EVERY_MS = 500;
const TRY_TAKES_AT_MOST_MS = 5000;
const TIME_EVERY_MS = 2000;
const SILENCE_IS_A_CUT_MS = 6000;
const LOOKS_EVERY_MS = 100;
const SLEPT_MS = 2000; // between two looks

/** The part of a WebSocket that is used. */
export interface Socket {
  readonly readyState: number;
  readonly bufferedAmount: number;
  binaryType: string;
  onopen: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  send(text: string): void;
  close(code?: number): void;
}
/** `allowed`, or why not; `out_of_reach`: the server did not answer at all. */
export type Check = { is: 'allowed' } | { is: 'refused'; text: string } | { is: 'out_of_reach' };

/** The world outside, so that tests can be it. */
export interface Means {
  open(session_id: string, protocols: string[]): Socket;
  check(session_id: string, token: string): Promise<Check>;
  /** The last picture of a camera; null: it cannot be had now. */
  picture(session_id: string, token: string, vehicle: number, sensor: string): Promise<Blob | null>;
  /** What a vehicle inspects, as it is drawn: JSON; null: it cannot be had now. */
  surface(session_id: string, token: string, vehicle: number, surface: string): Promise<unknown>;
  now_ms(): number;
  after(wait_ms: number, run: () => void): number;
  cancel(timer: number): void;
  chance(): number; // 0 to 1
}

export type LinkState =
  | { is: 'off'; text: string } // no seat, and none asked for
  | { is: 'joining' }
  | { is: 'seated' }
  | { is: 'cut'; kept_until_ms: number; tries: number }; // the server keeps the seat

export interface Hooks {
  on_state(state: LinkState): void;
  on_message(message: Json): void;
  on_bytes(bytes: Uint8Array): void;
  /** To be kept for a reload of this tab; null: no longer good. */
  on_resume(resume: { session_id: string; token: string; name: string } | null): void;
}

const CLOSED_FOR_GOOD: Readonly<Record<number, string>> = {
  4000: 'The run is over.',
  4001: 'This seat was taken up at another station.',
  4005: 'The token has ended. Ask for a new one.',
};

/**
 * 250, 500, 1000, 2000, then 4000 ms, less up to a quarter by chance so that stations do not come
 * all at once.
 */
export function backoff_ms(tries: number, chance: number): number {
  return Math.min(4000, 250 * 2 ** tries) * (1 - 0.25 * chance);
}

export class Wire {
  readonly clock = new SessionClock();
  private socket: Socket | null = null;
  private state: LinkState = { is: 'off', text: '' };
  private session_id = '';
  private token = ''; // the one to come with next: of the role at first, then of the seat
  private role_token = ''; // of memory only; a reload has none
  private name = '';
  private link = 0; // counts the tries, so that a late answer of an old one is known
  private next_id = 1;
  private bye = '';
  private unanswered_since_ms: number | null = null; // a question of time, with nothing heard since
  private has_asked_again = false; // after a sleep, with nothing heard since
  private close_now: (code: number) => void = () => undefined;
  private drawn_number = 0;
  private saw_number = 0;
  private saw_at_ms = 0;
  private lost_at_ms = -Infinity;
  private timers: number[] = [];

  constructor(
    private readonly means: Means,
    private readonly hooks: Hooks,
  ) {}

  get is_open(): boolean {
    return this.state.is === 'seated' && this.socket !== null && this.socket.readyState === 1;
  }
  get buffered_bytes(): number {
    return this.socket?.bufferedAmount ?? 0;
  }
  /** The session's clock now; not a number when it is not known. */
  clock_ms(): number {
    return this.clock.at(this.means.now_ms());
  }

  /** The last picture of a camera, for this seat. */
  picture(vehicle: number, sensor: string): Promise<Blob | null> {
    return this.means.picture(this.session_id, this.token, vehicle, sensor);
  }

  /** A surface that is inspected, for this seat. */
  surface(vehicle: number, surface: string): Promise<unknown> {
    return this.means.surface(this.session_id, this.token, vehicle, surface);
  }

  /** A new seat, with a role's token. */
  join(session_id: string, token: string, name: string): void {
    this.start(session_id, token, token, name, { is: 'joining' });
  }

  /**
   * After a reload: the seat that this tab had, with the seat's own token. Tries as long as it is
   * kept.
   */
  take_up(session_id: string, token: string, name: string): void {
    const kept_until_ms = this.means.now_ms() + SEAT_IS_KEPT_MS;
    this.start(session_id, token, '', name, { is: 'cut', kept_until_ms, tries: 0 });
  }

  private start(
    session_id: string,
    token: string,
    role_token: string,
    name: string,
    state: LinkState,
  ): void {
    this.drop();
    this.session_id = session_id;
    this.token = token;
    this.role_token = role_token;
    this.name = name;
    this.become(state);
    void this.try_once();
  }

  leave(): void {
    this.send({ do: 'leave' });
    this.drop();
    this.end('You have left.');
  }

  /** The number it was sent under; null: it was not sent, and will not be. */
  send(message: Json): number | null {
    if (!this.is_open || this.socket === null) return null;
    const id = this.next_id;
    this.next_id += 1;
    this.socket.send(JSON.stringify({ ...message, id }));
    return id;
  }

  /** A frame was drawn: the server is told now and then, and keeps to our pace. */
  drawn(number: number): void {
    this.drawn_number = number;
    if (number - this.saw_number >= SAW_EVERY_FRAMES) this.tell_saw();
  }

  /** A frame could not be read: the next one shall be whole. Said until one comes. */
  lost_track(): void {
    const now_ms = this.means.now_ms();
    if (now_ms - this.lost_at_ms < LOST_EVERY_MS) return;
    if (this.send({ do: 'saw', frame: this.drawn_number, is_lost: true }) !== null)
      this.lost_at_ms = now_ms;
  }

  private tell_saw(): void {
    if (this.drawn_number === 0 || this.send({ do: 'saw', frame: this.drawn_number }) === null)
      return;
    this.saw_number = this.drawn_number;
    this.saw_at_ms = this.means.now_ms();
  }

  private async try_once(): Promise<void> {
    this.link += 1;
    const link = this.link;
    const check = await this.means.check(this.session_id, this.token);
    if (link !== this.link) return;
    if (check.is === 'refused') {
      // The seat is gone; who still has the role's token takes a new one.
      if (this.role_token !== '' && this.token !== this.role_token) {
        this.token = this.role_token;
        void this.try_once();
      } else {
        this.end(check.text);
      }
      return;
    }
    if (check.is === 'out_of_reach') {
      this.lost('The server is out of reach.');
      return;
    }
    // A recording asks for no token.
    const bearer = this.token === '' ? [] : [`bearer.${this.token}`];
    const socket = this.means.open(this.session_id, [PROTOCOL, ...bearer]);
    this.socket = socket;
    this.bye = '';
    socket.binaryType = 'arraybuffer';
    const gives_up = this.means.after(TRY_TAKES_AT_MOST_MS, () => {
      if (link === this.link && this.state.is !== 'seated') {
        socket.close();
        closed(1006);
      }
    });
    let is_over = false;
    const closed = (code: number): void => {
      if (is_over) return;
      is_over = true;
      this.means.cancel(gives_up);
      if (link !== this.link) return;
      this.socket = null;
      const text = CLOSED_FOR_GOOD[code];
      if (text !== undefined) this.end(this.bye || text);
      else this.lost(this.bye || 'The link was closed.');
    };
    socket.onopen = () => {
      this.next_id += 1;
      socket.send(
        JSON.stringify({ do: 'hello', id: this.next_id - 1, name: this.name, brief: true }),
      );
    };
    this.close_now = closed;
    socket.onclose = (event) => closed(event.code);
    socket.onmessage = (event) => {
      if (link !== this.link) return;
      this.unanswered_since_ms = null;
      this.has_asked_again = false;
      if (typeof event.data === 'string') this.take_text(event.data);
      else if (event.data instanceof ArrayBuffer) this.hooks.on_bytes(new Uint8Array(event.data));
    };
  }

  private take_text(text: string): void {
    let message: Json | null = null;
    try {
      message = as_object(JSON.parse(text));
    } catch {
      return; // not of our protocol
    }
    if (message === null) return;
    if (message.is === 'clock') {
      const asked_ms = as_number(message.at);
      const clock_ms = as_number(message.clock);
      if (asked_ms !== null && clock_ms !== null)
        this.clock.heard(asked_ms, clock_ms, this.means.now_ms());
    } else if (message.is === 'bye') {
      this.bye = as_text(message.text);
    } else if (message.is === 'welcome') {
      this.seated(message);
    } else if (message.is === 'answer' && message.taken !== true && this.state.is !== 'seated') {
      this.bye = as_text(message.text) || as_text(message.reason); // the hello was refused
    }
    this.hooks.on_message(message);
  }

  private seated(message: Json): void {
    const resume = as_text(message.resume);
    if (resume !== '') this.token = resume;
    this.name = as_text(message.name) || this.name;
    this.drawn_number = 0;
    this.saw_number = 0;
    this.lost_at_ms = -Infinity;
    this.clock.forget();
    this.unanswered_since_ms = null;
    this.hooks.on_resume(
      resume === '' ? null : { session_id: this.session_id, token: resume, name: this.name },
    );
    this.become({ is: 'seated' });
    const link = this.link;
    const ask_time = (): void => {
      if (link !== this.link) return;
      const asked_ms = this.means.now_ms();
      if (this.send({ do: 'time', at: asked_ms }) !== null) this.unanswered_since_ms ??= asked_ms;
    };
    // Several rounds at once, then one now and then; it also tells the server that we are here.
    for (let round = 0; round < 6; round += 1)
      this.timers.push(this.means.after(round * 120, ask_time));
    const later = (): void => {
      if (link !== this.link || this.state.is !== 'seated') return;
      ask_time();
      this.timers.push(this.means.after(TIME_EVERY_MS, later));
    };
    this.timers.push(this.means.after(TIME_EVERY_MS, later));
    let looked_at_ms = this.means.now_ms();
    const look = (): void => {
      if (link !== this.link || this.state.is !== 'seated') return;
      const has_slept = this.means.now_ms() - looked_at_ms > SLEPT_MS;
      looked_at_ms = this.means.now_ms();
      // A link can be dead without anyone saying so. In a tab whose timers sleep an answer still
      // comes in by itself, so only a question that got none is a sign.
      // And who slept has had no chance to hear one: it is asked again, once.
      if (has_slept && !this.has_asked_again) {
        this.has_asked_again = true;
        this.unanswered_since_ms = null;
        ask_time();
      }
      const silent_ms =
        this.unanswered_since_ms === null ? 0 : this.means.now_ms() - this.unanswered_since_ms;
      if (silent_ms > SILENCE_IS_A_CUT_MS || this.socket?.readyState !== 1) {
        this.socket?.close();
        this.close_now(1006);
        return;
      }
      if (this.means.now_ms() - this.saw_at_ms >= SAW_EVERY_MS - 50) this.tell_saw();
      this.timers.push(this.means.after(LOOKS_EVERY_MS, look));
      if (this.timers.length > 64) this.timers = this.timers.slice(-32);
    };
    look();
  }

  private lost(why: string): void {
    this.stop_timers();
    this.socket = null;
    const now_ms = this.means.now_ms();
    if (this.state.is === 'joining') {
      this.end(why);
      return;
    }
    const kept_until_ms =
      this.state.is === 'cut' ? this.state.kept_until_ms : now_ms + SEAT_IS_KEPT_MS;
    const tries = this.state.is === 'cut' ? this.state.tries + 1 : 0;
    const tried_until_ms = kept_until_ms + (this.role_token === '' ? 0 : TRIED_AT_MOST_MS);
    if (now_ms >= tried_until_ms) {
      this.end('The link was down too long and the seat was given up. Join again.');
      return;
    }
    // The server may have seen the cut later than we; after that the seat is surely gone.
    if (this.role_token !== '' && now_ms >= kept_until_ms + SERVER_IS_LATER_MS)
      this.token = this.role_token;
    this.become({ is: 'cut', kept_until_ms, tries });
    const link = this.link;
    const wait_ms = Math.min(backoff_ms(tries, this.means.chance()), tried_until_ms - now_ms);
    this.timers.push(
      this.means.after(wait_ms, () => {
        if (link === this.link) void this.try_once();
      }),
    );
  }

  private end(text: string): void {
    this.stop_timers();
    this.socket = null;
    this.link += 1;
    this.token = '';
    this.role_token = '';
    this.hooks.on_resume(null);
    this.become({ is: 'off', text });
  }

  private drop(): void {
    this.stop_timers();
    this.link += 1;
    const socket = this.socket;
    this.socket = null;
    socket?.close(1000);
  }

  private stop_timers(): void {
    for (const timer of this.timers) this.means.cancel(timer);
    this.timers = [];
  }

  private become(state: LinkState): void {
    this.state = state;
    this.hooks.on_state(state);
  }
}
