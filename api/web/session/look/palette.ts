// The colours of the canvases, read from the style sheet, so that each palette is written in one
// place.
import type { Palette } from './settings';

export interface Colours {
  paper: string;
  ink: string;
  quiet: string;
  rule: string;
  panel: string;
  accent: string;
  alarm: string;
  amber: string;
  water: string;
  bed: string;
  sky: string;
  deep: string;
  covered: string;
  not_covered: string;
}

let now: Colours | null = null;

export function use_palette(palette: Palette): void {
  document.documentElement.dataset.palette = palette;
  now = null;
}

export function colours(): Colours {
  if (now === null) {
    const style = getComputedStyle(document.documentElement);
    const named = (name: string): string => style.getPropertyValue(`--${name}`).trim();
    now = {
      paper: named('paper'),
      ink: named('ink'),
      quiet: named('quiet'),
      rule: named('rule'),
      panel: named('panel'),
      accent: named('accent'),
      alarm: named('alarm'),
      amber: named('amber'),
      water: named('water'),
      bed: named('bed'),
      sky: named('sky'),
      deep: named('deep'),
      covered: named('covered'),
      not_covered: named('not-covered'),
    };
  }
  return now;
}
