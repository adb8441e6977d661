// The webcam is off where it was stopped, however late the browser answers.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { Webcam } from 'page/webcam/webcam';

/** A stream of one track, that is live until it is stopped. */
class Stream {
  is_live = true;
  getTracks(): unknown[] {
    return [{ stop: () => (this.is_live = false), addEventListener: () => undefined }];
  }
}
let asked: { grant: (it: Stream) => void; refuse: (why: Error) => void }[] = [];
beforeEach(() => {
  asked = [];
  const getUserMedia = (): Promise<Stream> =>
    new Promise((grant, refuse) => asked.push({ grant, refuse }));
  const put = (name: string, value: unknown): unknown =>
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  put('navigator', { mediaDevices: { getUserMedia } });
  put('document', { createElement: () => ({ srcObject: null, play: async () => undefined }) });
});
const webcam_of = (): Webcam => new Webcam(() => undefined);

test('ItIsOnBetweenStartAndStop', async () => {
  const [webcam, stream] = [webcam_of(), new Stream()];
  const started = webcam.start();
  asked[0]!.grant(stream);
  assert.equal(await started, true);
  assert.ok(stream.is_live && webcam.video.srcObject === (stream as unknown));
  webcam.stop();
  assert.ok(!stream.is_live && webcam.video.srcObject === null);
});

test('WhatIsGrantedAfterItWasStoppedIsStopped', async () => {
  const [webcam, late] = [webcam_of(), new Stream()];
  const started = webcam.start();
  webcam.stop();
  asked[0]!.grant(late);
  assert.equal(await started, false);
  assert.equal(late.is_live, false);
  assert.equal(webcam.video.srcObject, null);
});

test('StartedTwiceOneStreamGoesOn', async () => {
  for (const order of [
    [0, 1],
    [1, 0],
  ]) {
    asked = [];
    const webcam = webcam_of();
    const started = [webcam.start(), webcam.start()];
    const streams = [new Stream(), new Stream()];
    for (const nth of order) {
      asked[nth]!.grant(streams[nth]!);
      await started[nth];
    }
    assert.deepEqual(await Promise.all(started), [false, true]);
    assert.deepEqual(
      streams.map((it) => it.is_live),
      [false, true],
    );
    webcam.stop();
    assert.equal(streams[1]!.is_live, false);
  }
});

test('WhereItIsRefusedItIsSaidInWords', async () => {
  const started = webcam_of().start();
  asked[0]!.refuse(new DOMException('', 'NotAllowedError'));
  await assert.rejects(started, /^Error: The camera is not allowed for this page\.$/);
});
