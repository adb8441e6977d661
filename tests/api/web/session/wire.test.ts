// The link: where the token goes, what a cut does, and that nothing is kept for later.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  backoff_ms,
  Wire,
  type Check,
  type LinkState,
  type Means,
  type Socket,
} from 'page/session/wire';

class FakeSocket implements Socket {
  readyState = 0;
  bufferedAmount = 0;
  binaryType = '';
  sent: Record<string, unknown>[] = [];
  onopen: Socket['onopen'] = null;
  onmessage: Socket['onmessage'] = null;
  onclose: Socket['onclose'] = null;
  constructor(
    readonly session_id: string,
    readonly protocols: string[],
  ) {}
  send(text: string): void {
    assert.equal(this.readyState, 1);
    this.sent.push(JSON.parse(text) as Record<string, unknown>);
  }
  close(): void {
    this.readyState = 3;
  }
  opens(): void {
    this.readyState = 1;
    this.onopen?.();
  }
  says(message: unknown): void {
    this.onmessage?.({ data: typeof message === 'string' ? message : JSON.stringify(message) });
  }
  closes(code: number): void {
    this.readyState = 3;
    this.onclose?.({ code, reason: '' });
  }
}

class World {
  now = 0;
  answer: Check = { is: 'allowed' };
  sockets: FakeSocket[] = [];
  checked: string[] = [];
  pictures: string[] = [];
  surfaces: string[] = [];
  states: LinkState[] = [];
  resume: { token: string } | null = null;
  private timers: { at: number; run: () => void; id: number }[] = [];
  private next = 1;
  readonly wire: Wire;

  constructor() {
    const means: Means = {
      open: (session_id, protocols) => {
        const socket = new FakeSocket(session_id, protocols);
        this.sockets.push(socket);
        return socket;
      },
      check: (_session, token) => {
        this.checked.push(token);
        return Promise.resolve(this.answer);
      },
      picture: (session_id, token, vehicle, sensor) => {
        this.pictures.push([session_id, token, vehicle, sensor].join(' '));
        return Promise.resolve(null);
      },
      surface: (session_id, token, vehicle, surface) => {
        this.surfaces.push([session_id, token, vehicle, surface].join(' '));
        return Promise.resolve(null);
      },
      now_ms: () => this.now,
      after: (wait, run) => {
        this.timers.push({ at: this.now + wait, run, id: this.next });
        return this.next++;
      },
      cancel: (id) => (this.timers = this.timers.filter((it) => it.id !== id)),
      chance: () => 0,
    };
    this.wire = new Wire(means, {
      on_state: (state) => this.states.push(state),
      on_message: () => undefined,
      on_bytes: () => undefined,
      on_resume: (resume) => (this.resume = resume),
    });
  }

  /** Lets `ms` go by, in steps fine enough for all timers. */
  async pass(ms: number): Promise<void> {
    const end = this.now + ms;
    for (;;) {
      for (let i = 0; i < 4; i += 1) await Promise.resolve();
      const due = this.timers.filter((it) => it.at <= end).sort((a, b) => a.at - b.at)[0];
      if (due === undefined) break;
      this.timers = this.timers.filter((it) => it !== due);
      this.now = Math.max(this.now, due.at);
      due.run();
    }
    this.now = end;
  }
  /** A tab that is frozen: time goes by, then all timers that were due run before aught else. */
  async sleep(ms: number): Promise<void> {
    this.now += ms;
    await this.pass(0);
  }
  get socket(): FakeSocket {
    return this.sockets[this.sockets.length - 1]!;
  }
  get state(): LinkState {
    return this.states[this.states.length - 1]!;
  }
  async sit(resume = 'resume-1'): Promise<void> {
    await this.pass(0);
    this.socket.opens();
    this.socket.says({ is: 'welcome', seat: 1, name: 'Ann', resume });
    await this.pass(0);
  }
}
const of = (socket: FakeSocket, what: string): Record<string, unknown>[] =>
  socket.sent.filter((it) => it.do === what);

test('TheTokenGoesIntoTheSubProtocolAndHelloComesFirst', async () => {
  const world = new World();
  world.wire.join('live', 'secret-token', 'Ann');
  await world.pass(0);
  assert.deepEqual(world.socket.protocols, ['slackwater.session.v1', 'bearer.secret-token']);
  assert.equal(world.socket.session_id.includes('secret'), false);
  world.socket.opens();
  assert.equal(world.socket.sent[0]?.do, 'hello');
  assert.equal(world.wire.send({ do: 'stick' }), null); // not before the welcome
});

test('WhoLostTrackOfTheFramesSaysSoNowAndThenUntilOneIsWhole', async () => {
  const world = new World();
  world.wire.join('live', 'token', 'Ann');
  await world.sit();
  assert.equal(world.socket.sent[0]?.brief, true, 'it asks for such frames');
  for (let i = 0; i < 30; i += 1) {
    world.wire.lost_track(); // at each frame that cannot be read
    await world.pass(50);
  }
  const lost = of(world.socket, 'saw').filter((it) => it.is_lost === true);
  assert.equal(lost.length, 3, 'in 1.5 s');
  assert.equal(lost[0]?.frame, 0, 'though nothing was drawn yet');
});

test('ARefusalIsReadBeforeAnySocketIsOpened', async () => {
  const world = new World();
  world.answer = { is: 'refused', text: 'The token has ended.' };
  world.wire.join('live', 'old', 'Ann');
  await world.pass(0);
  assert.equal(world.sockets.length, 0);
  assert.deepEqual(world.state, { is: 'off', text: 'The token has ended.' });
});

test('ACutComesBackWithTheResumeTokenAndEachIsGoodOnce', async () => {
  const world = new World();
  world.wire.join('live', 'role-token', 'Ann');
  await world.sit('resume-1');
  assert.equal(world.resume?.token, 'resume-1');
  world.socket.closes(1006);
  assert.equal(world.state.is, 'cut');
  await world.pass(300);
  assert.equal(world.socket.protocols[1], 'bearer.resume-1');
  await world.sit('resume-2');
  assert.equal(world.state.is, 'seated');
  world.socket.closes(1006);
  await world.pass(300);
  assert.equal(world.socket.protocols[1], 'bearer.resume-2');
});

test('APictureIsAskedForWithTheTokenOfTheSeat', async () => {
  const world = new World();
  world.wire.join('live', 'role-token', 'Ann');
  await world.sit('resume-1');
  await world.wire.picture(1, 'rov_camera');
  assert.deepEqual(world.pictures, ['live resume-1 1 rov_camera']);
});

test('ASurfaceIsAskedForWithTheTokenOfTheSeat', async () => {
  const world = new World();
  world.wire.join('live', 'role-token', 'Ann');
  await world.sit('resume-1');
  await world.wire.surface(1, '0');
  assert.deepEqual(world.surfaces, ['live resume-1 1 0']);
});

test('NothingIsSentOverACutNorKeptForAfter', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  world.socket.closes(1006);
  for (let i = 0; i < 20; i += 1)
    assert.equal(world.wire.send({ do: 'stick', velocity: [1, 0, 0, 0] }), null);
  await world.pass(300);
  await world.sit('resume-2');
  await world.pass(1000);
  assert.equal(of(world.socket, 'stick').length, 0);
});

test('AReloadedPageGivesUpWhenItsSeatIsNoLongerKept', async () => {
  const world = new World();
  world.answer = { is: 'out_of_reach' };
  world.wire.take_up('live', 'resume-0', 'Ann');
  await world.pass(29_000);
  assert.equal(world.state.is, 'cut');
  await world.pass(2_000);
  assert.equal(world.state.is, 'off');
  assert.equal(world.resume, null);
  const tries = world.checked.length;
  await world.pass(60_000);
  assert.equal(world.checked.length, tries); // and there is an end to it
});

test('ASeatThatIsGoneIsTakenAnewWithTheRolesToken', async () => {
  const world = new World();
  world.wire.join('live', 'role-token', 'Ann');
  await world.sit('resume-1');
  world.answer = { is: 'out_of_reach' };
  world.socket.closes(1006);
  await world.pass(40_000);
  assert.equal(world.state.is, 'cut');
  // As long as it may be good.
  assert.ok(world.checked.slice(1).every((token) => token === 'resume-1'));
  world.answer = { is: 'refused', text: 'The seat is gone.' };
  world.checked = [];
  const means_check = world.checked;
  await world.pass(4_000);
  assert.deepEqual(means_check, ['resume-1', 'role-token']);
  // The role's token was refused too.
  assert.deepEqual(world.state, { is: 'off', text: 'The seat is gone.' });
});

test('NobodyTriesForEver', async () => {
  const world = new World();
  world.wire.join('live', 'role-token', 'Ann');
  await world.sit();
  world.answer = { is: 'out_of_reach' };
  world.socket.closes(1006);
  await world.pass(700_000);
  assert.equal(world.state.is, 'off');
});

for (const code of [4000, 4001, 4005]) {
  test(`Code${code}IsForGood`, async () => {
    const world = new World();
    world.wire.join('live', 't', 'Ann');
    await world.sit();
    world.socket.says({ is: 'bye', code, text: 'Why.' });
    world.socket.closes(code);
    await world.pass(10_000);
    assert.deepEqual(world.state, { is: 'off', text: 'Why.' });
    assert.equal(world.sockets.length, 1);
    assert.equal(world.resume, null);
  });
}

test('AnOldSocketIsNotHeard', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  const old = world.socket;
  old.closes(1006);
  await world.pass(300);
  await world.sit('resume-2');
  old.says({ is: 'welcome', seat: 9, resume: 'stolen' });
  old.closes(4001);
  assert.equal(world.state.is, 'seated');
  assert.equal(world.resume?.token, 'resume-2');
});

test('SawIsEachFifthFrameAndAtLeastEach400Milliseconds', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  for (let frame = 1; frame <= 20; frame += 1) {
    await world.pass(10);
    world.wire.drawn(frame);
  }
  assert.ok(of(world.socket, 'saw').length >= 4);
  const before = of(world.socket, 'saw').length;
  await world.pass(2000);
  const more = of(world.socket, 'saw').slice(before);
  assert.ok(more.length >= 4 && more.length <= 7, String(more.length));
  assert.ok(more.every((it) => it.frame === 20));
});

test('TheClockIsAskedSeveralTimesAndAnswered', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  await world.pass(1000);
  const asked = of(world.socket, 'time');
  assert.ok(asked.length >= 5);
  assert.equal(world.wire.clock.is_known, false);
  world.socket.says({ is: 'clock', at: world.now, clock: 77_000 });
  assert.equal(world.wire.clock_ms(), 77_000);
});

test('ALinkThatDiesWithoutAWordIsACutAfterSixSeconds', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  await world.pass(5_000);
  assert.equal(world.state.is, 'seated');
  await world.pass(2_000);
  assert.equal(world.state.is, 'cut');
  assert.equal(world.sockets[0]?.readyState, 3);
});

test('ALinkThatAnswersIsNoCut', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  for (let i = 0; i < 60; i += 1) {
    await world.pass(1_000);
    world.socket.says({ is: 'clock', at: world.now, clock: world.now });
  }
  assert.equal(world.state.is, 'seated');
  assert.equal(world.sockets.length, 1);
});

test('ATabThatSleptAMinuteKeepsItsLinkAndSendsNothingForThePast', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  for (let i = 0; i < 30; i += 1) {
    await world.pass(100);
    if (i < 29) world.socket.says({ is: 'clock', at: world.now, clock: world.now });
    world.wire.drawn(i);
  }
  await world.pass(1_900); // a question is on its way that nobody can hear the answer of
  const before = world.socket.sent.length;
  await world.sleep(60_000);
  assert.equal(world.state.is, 'seated', 'it has not listened yet');
  world.socket.says({ is: 'clock', at: world.now - 60_000, clock: world.now - 60_000 });
  world.socket.says({ is: 'clock', at: world.now, clock: world.now });
  await world.pass(1_000);
  assert.equal(world.state.is, 'seated');
  assert.equal(world.sockets.length, 1);
  const sent = world.socket.sent.slice(before).map((it) => it.do);
  assert.ok(sent.length <= 6, `not what a minute would have been: ${sent.join()}`);
  assert.ok(sent.every((it) => it === 'time' || it === 'saw'));
});

test('ALinkThatDiedWhileTheTabSleptIsACutSixSecondsAfter', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  await world.pass(3_000);
  await world.sleep(60_000);
  await world.pass(5_000);
  assert.equal(world.state.is, 'seated');
  await world.pass(1_500);
  assert.equal(world.state.is, 'cut');
});

test('AHiddenTabThatIsWokenOnceAMinuteFindsADeadLinkTheSecondTime', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  await world.sleep(60_000);
  assert.equal(world.state.is, 'seated');
  await world.sleep(60_000);
  assert.equal(world.state.is, 'cut');
});

test('NonsenseFromTheServerIsLeftOut', async () => {
  const world = new World();
  world.wire.join('live', 't', 'Ann');
  await world.sit();
  for (const text of ['{', '[]', 'null', '"x"', '{"is":"clock","at":"a"}']) world.socket.says(text);
  assert.equal(world.state.is, 'seated');
});

test('BackoffGrowsToFourSecondsAndNoFurther', () => {
  assert.deepEqual(
    [0, 1, 2, 3, 4, 9].map((tries) => backoff_ms(tries, 0)),
    [250, 500, 1000, 2000, 4000, 4000],
  );
  assert.equal(backoff_ms(4, 1), 3000);
});

test('ARecordingIsJoinedWithoutAToken', async () => {
  const world = new World();
  world.wire.join('log', '', '');
  await world.pass(0);
  assert.deepEqual(world.socket.protocols, ['slackwater.session.v1']);
});
