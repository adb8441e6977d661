// What sliders ask of the weather: those that are held, and the rest as the run has it by itself.
export type SliderName =
  'wind' | 'wind_from' | 'waves' | 'current' | 'current_to' | 'visibility' | 'water_visibility';
export type Held = Map<SliderName, number>;

const SETTLES_S = 5;
const SHORTEST_M = 0.5; // nobody sees nothing at all

/** An order of the weather (`weather` of the wire) without its `do`. */
export function slid_order(held: ReadonlyMap<SliderName, number>): Record<string, unknown> {
  const vector = (speed: SliderName, direction: SliderName, name: string): unknown =>
    held.has(speed) ? { speed_m_s: held.get(speed), [name]: held.get(direction) ?? 0 } : null;
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
