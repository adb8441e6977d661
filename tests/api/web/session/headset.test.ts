// A session of a headset from its beginning to its end, with a browser that only says so.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { Scene } from 'three';
import { Stick } from 'page/drive/stick';
import type { SceneView } from 'page/scene/scene_view';
import { Headset } from 'page/xr/headset';
import type { Lent } from 'page/xr/stay';
import { put_globals } from './xr_for_tests';

class Session extends EventTarget {
  visibilityState = 'visible';
  ended = 0;
  async end(): Promise<void> {
    this.ended += 1;
    this.dispatchEvent(new Event('end'));
  }
  see(state: string): void {
    this.visibilityState = state;
    this.dispatchEvent(new Event('visibilitychange'));
  }
}

let session: Session;
let space: EventTarget;
let asked: ((session: Session) => void) | null;
let refuses: boolean;
let notices: string[];
let pointed: unknown[];
let put_back = (): void => undefined;
beforeEach(() => {
  session = new Session();
  space = new EventTarget();
  asked = null;
  refuses = false;
  notices = [];
  pointed = [];
  const line = {
    dataset: {},
    set textContent(text: string) {
      notices.push(text);
    },
  };
  const requestSession = (): Promise<Session> =>
    refuses ? Promise.reject(new Error('no')) : new Promise((done) => (asked = done));
  put_back = put_globals({
    navigator: { xr: { requestSession } },
    document: {
      createElement: () => ({ getContext: () => null }),
      getElementById: () => line,
    },
  });
});
afterEach(() => put_back());

const view = {
  scene: new Scene(),
  visitor: null,
  renderer: {
    setAnimationLoop: () => undefined,
    xr: {
      setReferenceSpaceType: () => undefined,
      setSession: async () => undefined,
      getReferenceSpace: () => space,
    },
  },
} as unknown as SceneView;

const headset_of = (): Headset =>
  new Headset({
    station: { session: { poses: new Map() } },
    way: {},
    people: { point_at: (at: unknown) => pointed.push(at) },
    on_change: () => undefined,
  } as unknown as Lent);

async function entered(): Promise<Headset> {
  const headset = headset_of();
  const done = headset.enter('vr', view);
  asked!(session);
  await done;
  assert.ok(headset.is_worn() && headset.is_seen());
  return headset;
}

test('who leaves while the browser still asks is not in it once it has answered', async () => {
  const headset = headset_of();
  const done = headset.enter('vr', view);
  headset.leave();
  asked!(session);
  await done;
  assert.equal(session.ended, 1);
  assert.equal(headset.is_worn(), false);
  assert.deepEqual(notices, []);
});

test('a headset that is put down ends its session, the menu over it does not', async () => {
  const headset = await entered();
  session.see('visible-blurred');
  assert.deepEqual([session.ended, headset.is_worn(), headset.is_seen()], [0, true, false]);
  assert.deepEqual(pointed, [null], 'it lets go');
  session.see('visible');
  session.see('hidden');
  assert.deepEqual([session.ended, headset.is_worn()], [1, false]);
  assert.equal(headset.words_at_rest(), '');
  assert.equal(view.visitor, null);
});

test('where the headset counts from elsewhere now, its hands let go', async () => {
  await entered();
  space.dispatchEvent(new Event('reset'));
  assert.deepEqual(pointed, [null]);
});

test('a browser that refuses is told, and one may ask again', async () => {
  refuses = true;
  const headset = headset_of();
  await headset.enter('vr', view);
  assert.deepEqual(notices, ['The headset did not start: no']);
  refuses = false;
  const done = headset.enter('vr', view);
  asked!(session);
  await done;
  assert.ok(headset.is_worn());
  const stick = new Stick();
  headset.look(stick); // no frame came yet: no hand
  assert.equal(stick.driving_hand, null);
});
