// The scrubber of a log that is watched again: where keys, marks and hands take its head.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Action } from 'page/session/message';
import {
  clock_text,
  key_step_s,
  key_time_s,
  next_action_s,
  previous_action_s,
  Seeker,
  share_of,
  value_text,
  way_text,
} from 'page/session/playback';
import { empty_session, tell, type Session } from 'page/session/state';
import { helm_words } from 'page/panel/helm_panel';
import { run_text } from 'page/panel/top_bar';

const HOUR = { from_s: 0, to_s: 3600, seen: 0 };

function action(number: number, time_s: number): Action {
  return {
    number,
    at: '2026-11-27T05:00:00Z',
    time_s,
    step: 0,
    seat: 1,
    who: 'Ann',
    role: 'operator',
    what: 'hold',
    vehicle: 'rov',
    before: '',
    after: '',
    taken: true,
    why: '',
  };
}

test('AnArrowKeyMovesAHundredthOfTheWayAndASecondAtLeast', () => {
  assert.equal(key_step_s(HOUR), 30);
  assert.equal(key_step_s({ from_s: 0, to_s: 12, seen: 0 }), 1);
  assert.equal(key_step_s({ from_s: 100, to_s: 100 + 86400, seen: 0 }), 600);
});

test('KeysGoOnAndBackByPagesToBothEndsAndNeverBeyond', () => {
  assert.equal(key_time_s('ArrowRight', 100, HOUR), 130);
  assert.equal(key_time_s('ArrowLeft', 100, HOUR), 70);
  assert.equal(key_time_s('ArrowLeft', 10, HOUR), 0);
  assert.equal(key_time_s('PageUp', 3500, HOUR), 3600);
  assert.equal(key_time_s('PageDown', 3500, HOUR), 3200);
  assert.equal(key_time_s('Home', 77, HOUR), 0);
  assert.equal(key_time_s('End', 77, HOUR), 3600);
  assert.equal(key_time_s('Tab', 77, HOUR), null, 'the focus goes on');
});

test('MarksLieWhereTheirTimeIsOnTheWay', () => {
  const late = { from_s: 100, to_s: 300, seen: 0 };
  assert.equal(share_of(150, late), 0.25);
  assert.equal(share_of(50, late), 0);
  assert.equal(share_of(999, late), 1);
  assert.equal(share_of(0, { from_s: 0, to_s: 0, seen: 0 }), 0, 'a log of one moment');
});

test('TheNextAndThePreviousActionAreThoseAroundTheHead', () => {
  const actions = [action(1, 10), action(2, 20), action(3, 20), action(4, 4000)];
  assert.equal(next_action_s(actions, 0, HOUR), 10);
  assert.equal(next_action_s(actions, 10, HOUR), 20);
  assert.equal(next_action_s(actions, 20, HOUR), 3600, 'one after the last row is at the end');
  assert.equal(next_action_s(actions, 3600, HOUR), null);
  assert.equal(previous_action_s(actions, 20, HOUR, 0), 10);
  assert.equal(previous_action_s(actions, 10, HOUR, 0), null);
  assert.equal(previous_action_s(actions, 20.4, HOUR, 0), 20);
  assert.equal(previous_action_s(actions, 20.4, HOUR, 1), 10, 'playing, the last second is passed');
});

test('TimesAreReadAsHoursMinutesAndSeconds', () => {
  assert.equal(clock_text(0), '0:00');
  assert.equal(clock_text(59.9999999), '1:00', 'as the floor of what rounding has left');
  assert.equal(clock_text(754.9), '12:34');
  assert.equal(clock_text(3723), '1:02:03');
  assert.equal(way_text(130, { from_s: 100, to_s: 700, seen: 0 }), '0:30 of 10:00');
  const start_ms = Date.parse('2026-11-27T05:00:00Z');
  assert.equal(value_text(61, start_ms, HOUR, { kind: 'utc' }), '05:01:01 UTC, 1:01 of 1:00:00');
  const site = { kind: 'site', offset_hours: 2 } as const;
  assert.equal(value_text(61, start_ms, HOUR, site), '07:01:01 site, 1:01 of 1:00:00');
  assert.equal(value_text(61, Number.NaN, HOUR, site), '1:01 of 1:00:00');
});

class Hand {
  now = 1000;
  sent: number[] = [];
  answers: (() => void)[] = [];
  is_up = true;
  private timers: { at: number; run: () => void }[] = [];
  readonly seeker = new Seeker(
    (time_s, on_answer) => {
      if (!this.is_up) return false;
      this.sent.push(time_s);
      this.answers.push(on_answer);
      return true;
    },
    () => this.now,
    (wait_ms, run) => this.timers.push({ at: this.now + wait_ms, run }),
  );
  pass(ms: number): void {
    this.now += ms;
    for (const it of this.timers.filter((timer) => timer.at <= this.now)) it.run();
    this.timers = this.timers.filter((timer) => timer.at > this.now);
  }
}

test('AHandThatDragsAsksTenTimesASecondAtMostAndForItsLastPlaceAlways', () => {
  const hand = new Hand();
  for (let i = 1; i <= 40; i += 1) {
    hand.seeker.want(i);
    hand.pass(10);
  }
  hand.pass(200);
  assert.ok(hand.sent.length <= 6, `${hand.sent.length} in 0.4 s`);
  assert.equal(hand.sent[0], 1, 'the first one at once');
  assert.equal(hand.sent[hand.sent.length - 1], 40);
});

test('UntilTheServerHasAnsweredTheWantedPlaceIsShownAndNoFrameOnItsWay', () => {
  const hand = new Hand();
  hand.seeker.want(50);
  assert.equal(hand.seeker.shown_s(3), 50);
  hand.seeker.want(60);
  hand.answers[0]?.();
  assert.equal(hand.seeker.shown_s(50), 60, 'the answer to the first is not one to the second');
  hand.pass(150);
  hand.answers[1]?.();
  assert.equal(hand.seeker.shown_s(60.1), 60.1);
});

test('WithoutALinkNothingIsWantedForLater', () => {
  const hand = new Hand();
  hand.is_up = false;
  hand.seeker.want(50);
  assert.equal(hand.seeker.shown_s(3), 3);
  hand.is_up = true;
  hand.pass(500);
  assert.deepEqual(hand.sent, []);
});

const WELCOME = {
  is: 'welcome',
  session: 'log',
  seat: null,
  role: 'spectator',
  start: '2026-11-27T05:00:00Z',
  vehicles: [{ vehicle: 0, name: 'rov', kind: 'rov', length_m: null }],
  run: { state: 'recorded', by: null, is_playing: false, rate: 1, time_s: 0 },
  helms: [{ vehicle: 0, state: 'held', holder: 'Ann', asker: 'Bob' }],
  actions: Array.from({ length: 600 }, (_, i) => ({ ...action(i + 1, i) })),
  playback: { from_s: 0, to_s: 600 },
  seen: 1,
};

function recorded(): Session {
  const session = empty_session();
  tell(session, WELCOME);
  return session;
}

test('ARecordingHasAllItsActionsFromTheBeginning', () => {
  const session = recorded();
  assert.equal(session.actions.length, 600);
  assert.deepEqual(session.playback, { from_s: 0, to_s: 600, seen: 1 });
  tell(session, { is: 'action', ...action(2, 1) });
  assert.equal(session.actions.length, 600, 'one that is told again is no second one');
  assert.equal(session.playback?.seen, 2);
  tell(session, { is: 'seen', number: 77, time_s: 76 });
  assert.equal(session.playback?.seen, 77);
  tell(session, { is: 'seen', number: 0, time_s: 0 });
  assert.equal(session.playback?.seen, 0);
});

test('ALiveRunHasNoPlayback', () => {
  const session = recorded();
  tell(session, { ...WELCOME, playback: undefined, run: { state: 'running', by: null } });
  assert.equal(session.playback, null);
  tell(session, { is: 'seen', number: 3 });
  assert.equal(session.playback, null);
});

test('TheRunAndTheHelmOfARecordingAreToldInWords', () => {
  const session = recorded();
  assert.equal(run_text(session), 'Recording, paused');
  tell(session, { is: 'run', state: 'recorded', is_playing: true, rate: 10, time_s: 3 });
  assert.equal(run_text(session), 'Recording, plays 10×');
  const words = helm_words(session, session.helms.get(0), Number.NaN);
  assert.equal(words.state, 'Ann drives.');
  assert.equal(helm_words(session, undefined, Number.NaN).state, 'Nobody drives.');
});
