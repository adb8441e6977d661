// What one page says to the other is read back; what is something else is not taken.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MOST, read_wish, wish_message, type CameraWish } from 'page/../look/camera_wish';

const WISH: CameraWish = { pan_deg_s: -12.5, tilt_deg_s: 3, zoom_per_s: 0.2, picture_ms: 1.7e12 };

test('AWishIsReadBackAsItWasSaid', () => {
  assert.deepEqual(read_wish(wish_message(WISH)), WISH);
});

test('WhatIsNoWishIsNotTaken', () => {
  const others: unknown[] = [
    null,
    undefined,
    'a wish',
    7,
    {},
    { ...WISH },
    { ...wish_message(WISH), is: 'something else' },
  ];
  for (const field of ['pan_deg_s', 'tilt_deg_s', 'zoom_per_s', 'picture_ms'])
    for (const value of [Number.NaN, Infinity, '3', null, undefined, [1]])
      others.push({ ...wish_message(WISH), [field]: value });
  others.push(wish_message({ ...WISH, pan_deg_s: MOST.pan_deg_s + 1 }));
  others.push(wish_message({ ...WISH, zoom_per_s: -MOST.zoom_per_s - 0.1 }));
  for (const other of others) assert.equal(read_wish(other), null, JSON.stringify(other));
});
