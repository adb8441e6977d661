// 64 waves of a Pierson-Moskowitz sea, spread about north-east; their phases evenly scattered.
import { read_sea } from 'page/session/sea';

const waves = Array.from({ length: 64 }, (_, i) => {
  const omega = 0.5 + 0.025 * i;
  const density = 0.0081 * 9.81 ** 2 * omega ** -5 * Math.exp(-1.25 * (0.75 / omega) ** 4);
  const towards = Math.PI / 4 + 0.8 * (((0.618034 * i) % 1) - 0.5);
  const k = omega ** 2 / 9.81;
  const amplitude = Math.sqrt(0.05 * density);
  const phase = 6.283 * ((0.754878 * i) % 1);
  return [amplitude, k * Math.cos(towards), k * Math.sin(towards), omega, phase];
});
export const made_up_sea = read_sea({ depth_m: 60, waves });
