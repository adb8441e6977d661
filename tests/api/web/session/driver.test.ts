// Whose hand may be on the stick, and how it comes off: the driver with a stick, a window that has
// the focus or not, and a headset that is seen or not.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { Driver, gate_of } from 'page/drive/driver';
import { PadReader } from 'page/drive/gamepad';
import { Keys } from 'page/drive/keys';
import { block_of, Stick } from 'page/drive/stick';
import type { Json } from 'page/session/message';
import { empty_session } from 'page/session/state';
import type { Station } from 'page/station';
import { HelmHand } from 'page/xr/helm_hand';
import { controller, put_globals, SQUEEZED, ZERO } from './xr_for_tests';

const OPENED = controller('left');
const PAD = { index: 0, connected: true, axes: [0, -1, 0, 0] };

/** A page whose window may lose the focus, while somebody wears a headset. */
class Page {
  has_focus = true;
  is_seen = true;
  is_table = false;
  raw: number[] | null = null;
  pad_is_held = false;
  said: Json[] = [];
  words = '';
  readonly put_back: () => void;
  private now_ms = 0;
  private readonly helm = new HelmHand();
  private readonly stick = new Stick();
  readonly station = {
    session: empty_session(),
    settings: { stick_share: 0.5, speed_unit: 'm/s' },
    chosen: 1,
    wire: { is_open: true, buffered_bytes: 0, clock: { is_known: true } },
    picture_age_ms: () => 50,
    has_helm: () => true,
    command: (_what: string, message: Json) => this.said.push(message),
  } as unknown as Station;
  private readonly driver: Driver;

  constructor() {
    this.station.session.vehicles.set(1, { vehicle: 1, most_speed_m_s: 1.5 } as never);
    const keys = new Keys();
    const headset = {
      look: (stick: Stick) => {
        if (!this.is_seen) this.helm.lose();
        this.helm.look(stick, this.now_ms);
      },
      is_seen: () => this.is_seen,
      words_at_rest: () => 'Stick at rest.',
    };
    const panel = {
      shares: () => this.raw,
      zero_shares: () => (this.raw = this.raw?.map(() => 0) ?? null),
      show_pad: () => undefined,
      touch_is_held: () => false,
      touch_lean: () => ZERO,
    };
    const bar = {
      show_stick: (_lean: unknown, text: string) => (this.words = text),
      show_taken: () => undefined,
    };
    const given = [this.station, this.stick, keys, new PadReader(), panel, bar, headset];
    this.driver = new Driver(...(given as unknown as ConstructorParameters<typeof Driver>));
    this.put_back = put_globals({
      document: { hidden: false, hasFocus: () => this.has_focus, querySelector: () => null },
      navigator: {
        getGamepads: () => [{ ...PAD, buttons: Array(6).fill({ pressed: this.pad_is_held }) }],
      },
      matchMedia: () => ({ matches: false }),
    });
    for (let i = 0; i < 3; i += 1) this.tick(OPENED);
  }

  /** What is said in a tick with such a hand. */
  tick(hand = SQUEEZED): Json[] {
    this.now_ms += 50;
    this.helm.take([hand], 0, () => true, this.now_ms);
    this.said = [];
    this.driver.tick();
    return this.said;
  }
  get surge_m_s(): number | undefined {
    return (this.said[0]?.velocity as number[] | undefined)?.[0];
  }
}

let page: Page;
beforeEach(() => (page = new Page()));
afterEach(() => page.put_back());

test('a headset that is seen counts as the focus, one that is not does not', () => {
  page.has_focus = false;
  assert.equal(block_of(gate_of(page.station)), 'no_focus');
  assert.equal(block_of(gate_of(page.station, true)), null);
  page.tick();
  assert.ok(page.surge_m_s! > 0);
});

test('a headset that is hidden sends its zero, once, also where the window has no focus', () => {
  page.has_focus = false;
  page.tick();
  assert.ok(page.surge_m_s! > 0);
  page.is_seen = false;
  assert.deepEqual(page.tick(), [{ do: 'stick', velocity: [0, 0, 0, 0] }]);
  for (let i = 0; i < 5; i += 1) assert.deepEqual(page.tick(), []);
  assert.equal(page.words, 'The scene is not in sight. Nothing is sent.');
  page.is_seen = true; // squeezed all the while
  for (let i = 0; i < 5; i += 1) assert.deepEqual(page.tick(), []);
});

test('a gamepad drives no window without focus because somebody wears a headset', () => {
  page.pad_is_held = true;
  page.tick(OPENED);
  assert.ok(page.surge_m_s! > 0, 'with the focus it drives');
  page.has_focus = false;
  assert.deepEqual(page.tick(OPENED), [{ do: 'stick', velocity: [0, 0, 0, 0] }]);
  for (let i = 0; i < 5; i += 1) assert.deepEqual(page.tick(OPENED), []);
  page.has_focus = true; // its button was held all the while
  assert.deepEqual(page.tick(OPENED), []);
});

test('a squeeze sends no raw thrusters, and says so', () => {
  page.raw = [0.5, -0.5];
  for (let i = 0; i < 5; i += 1) assert.deepEqual(page.tick(), []);
  assert.equal(page.words, 'Raw thrusters: not from a headset.');
  page.raw = null; // squeezed all the while
  for (let i = 0; i < 5; i += 1) assert.deepEqual(page.tick(), []);
  assert.equal(page.words, 'Open your hand, then squeeze again.');
});

test('raw thrusters that come on in the middle of a squeeze end it with zeros', () => {
  page.tick();
  page.raw = [0.5, -0.5];
  assert.deepEqual(page.tick(), [{ do: 'thrusters', share: [0, 0] }]);
  assert.deepEqual(page.tick(), []);
});
