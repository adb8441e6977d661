// Words beside signs, so that none lies over another: each takes the first free side, the most
// important first; one that finds none is left out.
import type { Point } from './scene';

export interface Label {
  at: Point;
  half: number; // of the sign that it stands beside
  words: string;
}
export interface Placed {
  at: Point;
  anchor: 'start' | 'end' | 'middle';
  words: string;
}
export interface Taken {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Of 13 px letters, on the safe side: ships are named in capitals. */
const WIDE_PX = 13;
const CAPITAL_PX = 9.3;
const SMALL_PX = 7.8;
const ABOVE_PX = 11;
const BELOW_PX = 4;
/** Right, left, above, below: which way, how much further down, and how the words stand. */
const SIDES: readonly (readonly [number, number, number, Placed['anchor']])[] = [
  [1, 0, 5, 'start'],
  [-1, 0, 5, 'end'],
  [0, -1, -4, 'middle'],
  [0, 1, 12, 'middle'],
];
const APART_PX = 4;

function width_of(letter: string): number {
  if ('WM@%'.includes(letter)) return WIDE_PX;
  return letter >= 'A' && letter <= 'Z' ? CAPITAL_PX : SMALL_PX;
}

export function box_of_words([x, y]: Point, anchor: Placed['anchor'], words: string): Taken {
  const wide = [...words].reduce((sum, letter) => sum + width_of(letter), 0);
  const left = anchor === 'start' ? x : anchor === 'end' ? x - wide : x - wide / 2;
  return { left, right: left + wide, top: y - ABOVE_PX, bottom: y + BELOW_PX };
}

export const box_around = ([x, y]: Point, half: number): Taken => ({
  ...{ left: x - half, right: x + half, top: y - half, bottom: y + half },
});

const FAR_PX = 1e5;
/** What lies left and right of a picture. */
export const beside = ({ width }: { width: number }): Taken[] => [
  { left: -FAR_PX, right: 0, top: -FAR_PX, bottom: FAR_PX },
  { left: width, right: FAR_PX, top: -FAR_PX, bottom: FAR_PX },
];

export const overlaps = (a: Taken, b: Taken): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** @param labels  the most important first; @param taken  what may not be covered */
export function place_labels(labels: readonly Label[], taken: readonly Taken[]): Placed[] {
  const full = [...taken];
  return labels.flatMap(({ at: [x, y], half, words }) => {
    for (const [right, below, down, anchor] of SIDES) {
      const away = half + APART_PX;
      const at: Point = [x + right * away, y + below * away + down];
      const box = box_of_words(at, anchor, words);
      if (full.some((other) => overlaps(box, other))) continue;
      full.push(box);
      return [{ at, anchor, words }];
    }
    return [];
  });
}

/** What the words of a drawing cover, with how far it is moved. */
export function boxes_of_texts(group: SVGGElement): Taken[] {
  return [...group.querySelectorAll('text')].map((text) => {
    const at: Point = [Number(text.getAttribute('x')), Number(text.getAttribute('y'))];
    const { classList } = text;
    const anchor = classList.contains('middle')
      ? 'middle'
      : classList.contains('end')
        ? 'end'
        : 'start';
    return box_of_words(at, anchor, text.textContent ?? '');
  });
}
