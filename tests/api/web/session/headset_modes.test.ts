// The ways into the scene with a headset.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FEATURES_OF, modes_there } from 'page/xr/modes';

test('a way in is offered where the browser says so, and nothing where it fails', async () => {
  const xr = (say: (mode: string) => Promise<boolean>): XRSystem =>
    ({ isSessionSupported: say }) as unknown as XRSystem;
  assert.deepEqual([...(await modes_there(undefined))], []);
  assert.deepEqual([...(await modes_there(xr(async (it) => it === 'immersive-ar')))], ['ar']);
  assert.deepEqual([...(await modes_there(xr(() => Promise.reject(new Error('no')))))], []);
  const asked = JSON.stringify(FEATURES_OF);
  assert.ok(!asked.includes('dom-overlay'));
});
