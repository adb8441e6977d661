// What the person sees: the camera's picture as in a mirror, with the landmarks that were found.
import { FINGERS, THUMB_TIP, type Hand } from '../gesture/hand';

export function draw_mirror(
  canvas: HTMLCanvasElement,
  video: HTMLVideoElement,
  hand: Hand | null,
  is_mirrored: boolean,
): void {
  const { videoWidth: width, videoHeight: height } = video;
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  const pen = canvas.getContext('2d');
  if (pen === null) return;
  pen.setTransform(is_mirrored ? 1 : -1, 0, 0, 1, is_mirrored ? 0 : width, 0);
  pen.drawImage(video, 0, 0);
  const tips = new Set<number>([THUMB_TIP, ...FINGERS.map((it) => it.tip)]);
  // White rimmed with black is seen on any skin.
  pen.fillStyle = '#ffffff';
  pen.strokeStyle = '#000000';
  pen.lineWidth = height / 240;
  hand?.landmarks.forEach(({ x, y }, i) => {
    pen.beginPath();
    pen.arc(x * height, y * height, (height / 120) * (tips.has(i) ? 1.6 : 1), 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  });
}
