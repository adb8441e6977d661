// The colours of drawings, read from the style sheet: each palette is written in one place.

const NAMES = [
  'paper',
  'ink',
  'quiet',
  'rule',
  'panel',
  'accent',
  'alarm',
  'amber',
  'good',
  'water',
  'bed',
  'land',
  'wind',
  'wave',
  'band',
  'ramp-low',
  'ramp-high',
] as const;
export type Colours = Record<(typeof NAMES)[number], string>;

let now: Colours | null = null;

export function use_palette(palette: string): void {
  document.documentElement.dataset.palette = palette;
  now = null;
}

export function colours(): Colours {
  if (now === null) {
    const style = getComputedStyle(document.documentElement);
    const pairs = NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]);
    now = Object.fromEntries(pairs) as Colours;
  }
  return now;
}
