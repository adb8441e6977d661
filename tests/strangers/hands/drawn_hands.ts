// What the test of the page of hands asks of its drawing page: pictures of hands with their true
// landmarks, and what the page's own code makes of landmarks.
import { pinch_point, size_of, spread_of } from 'page/gesture/hand';
import { shape_of } from 'page/gesture/shape';
import { DrawnHand, type Pose } from './drawn_hand';

const hand = new DrawnHand(320, 240);

function bytes_of(base64: string): ArrayBuffer {
  return Uint8Array.from(atob(base64), (it) => it.charCodeAt(0)).buffer;
}

Object.assign(window, {
  load: (glb: string) => hand.load(bytes_of(glb)),
  /**
   * As a picture, and its pixels (RGBA, base64). Mirrored, the right hand is a left one. Doubled,
   * what is in the right half is in the left half, too, as in a mirror.
   */
  draw: (pose: Pose | null, is_mirrored = false, is_doubled = false) => {
    const wide = hand.width / hand.height;
    const truth = hand.draw(pose).map(({ x, y }) => ({ x: is_mirrored ? wide - x : x, y }));
    const copy = document.createElement('canvas');
    copy.width = hand.width;
    copy.height = hand.height;
    const pen = copy.getContext('2d')!;
    if (is_mirrored) pen.setTransform(-1, 0, 0, 1, copy.width, 0);
    pen.drawImage(hand.canvas, 0, 0);
    if (is_doubled) {
      pen.setTransform(-1, 0, 0, 1, copy.width, 0);
      const half = copy.width / 2;
      pen.drawImage(hand.canvas, half, 0, half, copy.height, half, 0, half, copy.height);
    }
    const { data } = pen.getImageData(0, 0, copy.width, copy.height);
    let text = '';
    for (const value of data) text += String.fromCharCode(value);
    return { truth, picture: copy.toDataURL('image/png'), rgba: btoa(text) };
  },
  shape_of,
  size_of,
  pinch_point,
  spread_of,
});
