// Twenty times a second: what the hands do, whether it may go out, and what the server made of it.
import {
  BLOCK_TEXT,
  NO_LEAN,
  velocity_of,
  type Gate,
  type Lean,
  type Stick,
  type Tick,
} from './stick';
import type { Keys } from './keys';
import { leaves_keys_alone } from './keys';
import type { PadLike, PadReader } from './gamepad';
import { STICK_IS_VALID_MS } from './numbers';
import { notice } from '../look/notice';
import { speed_text } from '../look/units';
import type { Answer } from '../session/message';
import { shaped_text, stick_speed_m_s } from './shaped';
import type { DrivePanel } from '../panel/drive_panel';
import type { OrdersBar } from '../panel/orders_bar';
import type { Station } from '../station';
import type { Headset } from '../xr/headset';

export const TICK_MS = 50;

const LET_GO = 'Let the stick go, then hold it again.';
const OPEN_HAND = 'Open your hand, then squeeze again.';
const NOT_IN_SIGHT = 'The scene is not in sight. Nothing is sent.';

/**
 * What holds now of what must hold before anything is sent. `is_by_headset`: somebody wears one and
 * sees the scene, which counts as the focus; or its hand drove until now, and its zero is to go
 * out.
 */
export function gate_of(station: Station, is_by_headset = false): Gate {
  return {
    is_open: station.wire.is_open,
    buffered_bytes: station.wire.buffered_bytes,
    is_hidden: document.hidden,
    has_focus: document.hasFocus() || is_by_headset,
    clock_is_known: station.wire.clock.is_known,
    frame_age_ms: station.picture_age_ms(),
    has_helm: station.has_helm(),
  };
}

export class Driver {
  private vehicle: number | null = null;
  private told = ''; // the last refusal that was spoken, so that it is spoken once

  constructor(
    private readonly station: Station,
    private readonly stick: Stick,
    private readonly keys: Keys,
    private readonly pads: PadReader,
    private readonly panel: DrivePanel,
    private readonly bar: OrdersBar,
    private readonly headset: Pick<Headset, 'look' | 'is_seen' | 'words_at_rest'>,
  ) {}

  tick(): void {
    const { station, stick, panel } = this;
    if (station.chosen !== this.vehicle) {
      // Another vehicle: the hand comes off the stick before it drives that one.
      this.vehicle = station.chosen;
      this.bar.show_taken('', false);
      stick.tick({ ...gate_of(station), has_helm: false });
    }
    const shares = panel.shares();
    this.look_at_desk();
    // Raw thrusters are sliders at the desk: a squeeze would send them unseen.
    if (shares === null) this.headset.look(stick);
    else stick.lose('headset');

    const is_by_headset = this.headset.is_seen() || stick.driving_hand === 'headset';
    const tick = stick.tick(gate_of(station, is_by_headset));
    if (tick.lean !== null) this.send(tick, tick.lean, shares);
    if (tick.is_end || tick.block !== null || tick.must_release) panel.zero_shares();
    this.show(tick, shares);
  }

  /** Also where a headset opens the gate, the hands at the desk need the window's focus. */
  private look_at_desk(): void {
    const { stick, panel } = this;
    if (!document.hasFocus()) {
      for (const source of ['pad', 'keys', 'touch'] as const) stick.lose(source);
      return;
    }
    const pads: readonly (PadLike | null)[] = navigator.getGamepads?.() ?? [];
    panel.show_pad(this.pads.look(pads, stick));
    stick.set('keys', this.keys.is_held, this.keys.lean());
    stick.set('touch', panel.touch_is_held(), panel.touch_lean());
  }

  private send(tick: Tick, lean: Lean, shares: number[] | null): void {
    const asked_ms = performance.now();
    const on_answer = (answer: Answer): void => this.take(answer, asked_ms);
    if (shares !== null) {
      const share = tick.is_end ? shares.map(() => 0) : shares;
      this.station.command('Thrusters', { do: 'thrusters', share }, on_answer, STICK_IS_VALID_MS);
      return;
    }
    const most_m_s = stick_speed_m_s(this.station.session.vehicles.get(this.vehicle ?? -1));
    const velocity = velocity_of(lean, most_m_s, this.station.settings.stick_share);
    this.station.command('Stick', { do: 'stick', velocity }, on_answer, STICK_IS_VALID_MS);
  }

  private take(answer: Answer, asked_ms: number): void {
    if (!answer.taken) {
      const why = answer.text || answer.reason;
      this.bar.show_taken(`Refused: ${why}`, true);
      if (why !== this.told) notice(`Stick: refused. ${why}`, 'alarm');
      this.told = why;
      return;
    }
    this.told = '';
    const unit = this.station.settings.speed_unit;
    const vehicle = this.station.session.vehicles.get(this.vehicle ?? -1) ?? null;
    const shaped = shaped_text(answer.shaped, (speed_m_s) => speed_text(speed_m_s, unit), vehicle);
    const took_ms = Math.round(performance.now() - asked_ms);
    const step = answer.step === null ? 'Taken' : `Taken at step ${answer.step}`;
    this.bar.show_taken(`${step} (${took_ms} ms)${shaped === '' ? '' : `: ${shaped}`}`, false);
  }

  private show(tick: Tick, shares: number[] | null): void {
    const worn = this.headset.words_at_rest(); // empty where nobody wears it
    const lean = tick.lean !== null && tick.is_driving ? tick.lean : null;
    if (lean !== null) {
      this.bar.show_stick(
        lean,
        shares !== null ? 'Driving raw thrusters' : this.asked_text(lean),
        false,
      );
      return;
    }
    if (tick.block !== null) {
      const is_alarm = tick.block !== 'no_helm' && this.station.has_helm();
      const is_menu = worn !== '' && tick.block === 'no_focus';
      this.bar.show_stick(null, is_menu ? NOT_IN_SIGHT : BLOCK_TEXT[tick.block], is_alarm);
    } else if (tick.must_release) {
      this.bar.show_stick(null, worn === '' ? LET_GO : OPEN_HAND, true);
    } else if (worn !== '' && shares !== null) {
      this.bar.show_stick(null, 'Raw thrusters: not from a headset.', true);
    } else if (worn !== '') {
      this.bar.show_stick(NO_LEAN, worn, false);
    } else if (
      !leaves_keys_alone(document.activeElement) &&
      document.querySelector('dialog[open]') === null
    ) {
      this.bar.show_stick(NO_LEAN, 'Keys go to a field or button. Esc: back to the stick.', false);
    } else {
      const how = matchMedia('(pointer: coarse)').matches
        ? 'Touch a stick to drive.'
        : 'Hold Space to drive.';
      this.bar.show_stick(NO_LEAN, `Stick at rest. ${how}`, false);
    }
  }

  private asked_text(lean: Lean): string {
    const { settings, session } = this.station;
    const most_m_s = stick_speed_m_s(session.vehicles.get(this.vehicle ?? -1));
    const [surge, sway, heave, yaw] = velocity_of(lean, most_m_s, settings.stick_share);
    const parts: string[] = [];
    const speed = (value: number, more: string, less: string): void => {
      if (value !== 0)
        parts.push(
          `${value > 0 ? more : less} ${speed_text(Math.abs(value), settings.speed_unit, 2)}`,
        );
    };
    speed(surge, 'ahead', 'back');
    speed(sway, 'right', 'left');
    speed(heave, 'down', 'up');
    if (yaw !== 0) parts.push(`turn ${yaw > 0 ? 'right' : 'left'}`);
    return parts.length === 0 ? 'Driving: no way on' : `Driving: ${parts.join(', ')}`;
  }
}
