// Steps from pale to dark of one hue: they keep their order in grey and to every eye.
import { colours } from '../look/colours';
import { nice_most } from '../look/nice';

/** Edges of at most six steps from nothing to `most`. */
export function steps_of(most: number): number[] {
  const top = nice_most(most);
  const step = nice_most(top / 6);
  const count = Math.max(1, Math.ceil(top / step - 1e-9));
  return Array.from({ length: count + 1 }, (_, i) => Number((i * step).toPrecision(4)));
}

/** The fill of each step, and what can be read on it. */
export function ramp(count: number): { fill: string; on: string }[] {
  const { 'ramp-low': low, 'ramp-high': high, paper, ink } = colours();
  return Array.from({ length: count }, (_, i) => {
    const share = count === 1 ? 0 : i / (count - 1);
    const fill = mixed(low, high, share);
    const apart = (text: string): number => Math.abs(lightness(text) - lightness(fill));
    return { fill, on: apart(ink) >= apart(paper) ? ink : paper };
  });
}

function parts(colour: string): number[] {
  return [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
}

function mixed(low: string, high: string, share: number): string {
  const [a, b] = [parts(low), parts(high)];
  const mix = a.map((value, i) => Math.round(value + ((b[i] ?? value) - value) * share));
  return `#${mix.map((value) => value.toString(16).padStart(2, '0')).join('')}`;
}

function lightness(colour: string): number {
  const [red = 0, green = 0, blue = 0] = parts(colour);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
