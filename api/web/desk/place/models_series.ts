// Ours and the products' as lines. Ours is wide and whole; each other has its dash, its sign and
// its letter, so that grey paper and any eye tell them apart.
import type { Colours } from '../look/colours';
import type { Look } from '../look/look';
import type { Value } from '../server/coverage';
import { QUANTITIES, type Kind } from '../server/products';
import type { Compared } from './models';
import { values_of } from './over_time';
import type { Line, Series } from './series_chart';

const DASHES: readonly number[][] = [
  [9, 4],
  [2, 3],
  [12, 3, 2, 3],
  [5, 2],
  [12, 3, 2, 3, 2, 3],
];
const SIGNS = ['circle', 'rect', 'triangle', 'diamond'] as const;
const OTHERS: readonly (keyof Colours)[] = ['ink', 'amber', 'quiet', 'accent'];
const OURS: Record<Kind, keyof Colours> = { currents: 'water', wind: 'wind', waves: 'wave' };

/** Null where nobody has a value. */
export function models_series(look: Look, compared: Compared): Series | null {
  const { kind, ours, models } = compared;
  const { size } = QUANTITIES[kind];
  const shown = (values: Value[]): Value[] =>
    kind === 'waves'
      ? values
      : values.map((value) => (value === null ? null : look.speed_number(value)));
  const lines: Line[] = [];
  const our_column = ours.get(compared.level_m ?? 0)?.column ?? null;
  if (our_column !== null) {
    lines.push({
      name: 'our forecast',
      end: 'ours',
      values: shown(values_of(our_column, size)),
      times_ms: our_column.times_ms,
      band: null,
      dash: 'solid',
      colour: OURS[kind],
      wide: true,
    });
  }
  models.forEach(({ letter, name, is_measured, level_m, told: { column } }, i) => {
    if (column === null) return;
    lines.push({
      name: level_m === compared.level_m || is_measured ? name : `${name}, at ${level_m} m`,
      end: letter,
      values: shown(values_of(column, size)),
      times_ms: column.times_ms,
      band: null,
      // What was measured is no model: a thin whole line with crosses.
      dash: is_measured ? 'solid' : (DASHES[i % DASHES.length] ?? [9, 4]),
      sign: is_measured ? 'cross' : (SIGNS[i % SIGNS.length] ?? 'circle'),
      colour: is_measured ? 'ink' : (OTHERS[i % OTHERS.length] ?? 'ink'),
    });
  });
  if (lines.length === 0) return null;
  const times_ms = lines.flatMap((line) => line.times_ms ?? []);
  return {
    times_ms: [Math.min(...times_ms), Math.max(...times_ms)],
    unit: kind === 'waves' ? 'height, m' : look.speed_unit,
    from_zero: true,
    lines,
  };
}
