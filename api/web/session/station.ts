// This station: what it was told, what it looks at, and how it asks. Panels read it and ask through
// it.
import { CommandNumbers, ORDER_IS_VALID_MS } from './drive/numbers';
import { notice } from './look/notice';
import type { Settings } from './look/settings';
import type { Answer, Json } from './session/message';
import { empty_session, has_helm, vehicle_name, type Session } from './session/state';
import type { Wire } from './session/wire';

const ANSWER_IS_AWAITED_MS = 10_000;

export interface Panel {
  readonly box: HTMLElement;
  /** Ten times a second at most, and whenever something was told. */
  show(): void;
}

interface Awaited {
  what: string;
  asked_ms: number;
  on_answer: ((answer: Answer) => void) | null;
}

export class Station {
  session: Session = empty_session();
  chosen: number | null = null;
  frame_came_ms = Number.NaN;
  links = 0; // counts them: what was told over one is not known over the next
  readonly numbers = new CommandNumbers();
  private awaited = new Map<number, Awaited>();

  constructor(
    readonly wire: Wire,
    readonly settings: Settings,
  ) {}

  clock_ms(): number {
    return this.wire.clock_ms();
  }

  /** How old what is shown is: since the server sent it, or since it came, whichever is longer. */
  picture_age_ms(): number {
    const frame = this.session.frame;
    if (frame === null) return Number.NaN;
    const since_it_came_ms = performance.now() - this.frame_came_ms;
    const since_it_was_sent_ms = this.clock_ms() - frame.clock_ms;
    return Math.max(
      since_it_came_ms,
      Number.isFinite(since_it_was_sent_ms) ? since_it_was_sent_ms : 0,
    );
  }

  chosen_name(): string {
    return vehicle_name(this.session, this.chosen);
  }
  has_helm(): boolean {
    return has_helm(this.session, this.chosen);
  }
  /** Its way may be told: by who has the helm, and by supervisors where no person has it. */
  may_direct(): boolean {
    if (this.has_helm()) return true;
    const helm = this.chosen === null ? undefined : this.session.helms.get(this.chosen);
    return this.is_supervisor() && helm !== undefined && typeof helm.holder !== 'number';
  }
  /** HOLD is for who has the helm, and always for supervisors. */
  may_hold(): boolean {
    return this.chosen !== null && (this.has_helm() || this.is_supervisor());
  }
  is_supervisor(): boolean {
    return this.session.role === 'supervisor';
  }

  /** A request without number and end. False: it could not be sent, and will not be. */
  ask(what: string, message: Json, on_answer: Awaited['on_answer'] = null): boolean {
    const id = this.wire.send(message);
    if (id === null) {
      notice(`${what}: not sent, the link is down.`, 'alarm');
      return false;
    }
    this.awaited.set(id, { what, asked_ms: performance.now(), on_answer });
    return true;
  }

  /**
   * A command to the chosen vehicle, with number and end. `quiet`: the caller speaks of it itself.
   */
  command(
    what: string,
    message: Json,
    on_answer: Awaited['on_answer'] = null,
    valid_ms = ORDER_IS_VALID_MS,
  ): boolean {
    const stamp = this.numbers.stamp(this.clock_ms(), valid_ms);
    if (stamp === null) {
      notice(`${what}: not sent, the link is down.`, 'alarm');
      return false;
    }
    return this.ask(what, { ...message, vehicle: this.chosen, ...stamp }, on_answer);
  }

  take_answer(answer: Answer): void {
    const awaited = this.awaited.get(answer.id);
    this.awaited.delete(answer.id);
    if (this.awaited.size > 200) this.forget_old();
    if (awaited === undefined) return;
    if (awaited.on_answer !== null) awaited.on_answer(answer);
    else if (!answer.taken)
      notice(`${awaited.what}: refused. ${answer.text || answer.reason}`, 'alarm');
    else
      notice(
        answer.step === null
          ? `${awaited.what}: taken.`
          : `${awaited.what}: taken at step ${answer.step}.`,
      );
  }

  /** The link is new or gone: no answer is awaited over it. */
  forget_answers(): void {
    this.awaited.clear();
    this.links += 1;
  }

  private forget_old(): void {
    const now_ms = performance.now();
    for (const [id, it] of this.awaited)
      if (now_ms - it.asked_ms > ANSWER_IS_AWAITED_MS) this.awaited.delete(id);
  }
}
