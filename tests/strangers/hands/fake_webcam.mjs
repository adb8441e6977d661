// The file that Chromium plays as a webcam (--use-file-for-fake-video-capture), over and over: what is written over its pictures
// is what the camera sees from then on.
import { closeSync, openSync, writeFileSync, writeSync } from "node:fs";

const MARK = Buffer.from("FRAME\n");
const PICTURES = 2;

/** RGBA to the planes of YUV 4:2:0, BT.601. */
export function planes_of(rgba, width, height) {
  const planes = Buffer.alloc((width * height * 3) / 2);
  const at = (x, y) => [0, 1, 2].map((k) => rgba[4 * (y * width + x) + k]);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const [r, g, b] = at(x, y);
      planes[y * width + x] = 16 + (65.738 * r + 129.057 * g + 25.064 * b) / 256;
    }
  for (let y = 0; y < height; y += 2)
    for (let x = 0; x < width; x += 2) {
      const [r, g, b] = at(x, y);
      const chroma = width * height + (y / 2) * (width / 2) + x / 2;
      planes[chroma] = 128 + (-37.945 * r - 74.494 * g + 112.439 * b) / 256;
      planes[chroma + (width * height) / 4] = 128 + (112.439 * r - 94.154 * g - 18.285 * b) / 256;
    }
  return planes;
}

export class FakeWebcam {
  constructor(file, width, height) {
    this.file = file;
    this.head = Buffer.from(`YUV4MPEG2 W${width} H${height} F10:1 Ip A1:1 C420jpeg\n`);
    const empty = Buffer.concat([MARK, Buffer.alloc((width * height * 3) / 2, 128)]);
    writeFileSync(file, Buffer.concat([this.head, ...Array(PICTURES).fill(empty)]));
  }
  show(planes) {
    const file = openSync(this.file, "r+");
    for (let i = 0; i < PICTURES; ++i) {
      const at = this.head.length + i * (MARK.length + planes.length) + MARK.length;
      writeSync(file, planes, 0, planes.length, at);
    }
    closeSync(file);
  }
}
