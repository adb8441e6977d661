// What sliders ask of the weather: those that are held, and the rest as the run has it by itself.
export type SliderName =
  'wind' | 'wind_from' | 'waves' | 'current' | 'current_to' | 'visibility' | 'water_visibility';
export type Held = Map<SliderName, number>;
type Told = (name: SliderName) => number | null; // by the server; null: nobody says

const PAIRS: readonly (readonly [speed: SliderName, direction: SliderName])[] = [
  ['wind', 'wind_from'],
  ['current', 'current_to'],
];

const SETTLES_S = 5;
const SHORTEST_M = 0.5; // nobody sees nothing at all

/** A direction can be moved where there is a speed that goes with it: told, or held. */
export function may_slide(
  name: SliderName,
  held: ReadonlyMap<SliderName, number>,
  told: Told,
): boolean {
  const pair = PAIRS.find(([, direction]) => direction === name);
  return pair === undefined || held.has(pair[0]) || told(pair[0]) !== null;
}

/**
 * A speed and its direction are led together: where one is held, the other is held as it was told.
 * Nobody's speed is never taken for 0; calm water has no direction, and gets the slider's, 000°.
 */
export function hold_pairs(held: Held, told: Told): void {
  for (const [speed, direction] of PAIRS) {
    if (held.has(speed) === held.has(direction)) continue;
    const told_m_s = told(speed);
    if (held.has(speed)) held.set(direction, told(direction) ?? 0);
    else if (told_m_s !== null) held.set(speed, told_m_s);
    else held.delete(direction);
  }
}

/** An order of the weather (`weather` of the wire) without its `do`. */
export function slid_order(held: ReadonlyMap<SliderName, number>): Record<string, unknown> {
  const vector = (speed: SliderName, direction: SliderName, name: string): unknown =>
    held.has(speed) && held.has(direction)
      ? { speed_m_s: held.get(speed), [name]: held.get(direction) }
      : null;
  const far = (name: SliderName): number | null => {
    const m = held.get(name);
    return m === undefined ? null : Math.max(SHORTEST_M, m);
  };
  return {
    wind: vector('wind', 'wind_from', 'from_deg'),
    current: vector('current', 'current_to', 'to_deg'),
    waves_m: held.get('waves') ?? null,
    visibility_m: far('visibility'),
    water_visibility_m: far('water_visibility'),
    over_s: SETTLES_S,
  };
}
