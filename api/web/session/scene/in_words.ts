// What is in the scene, in words, for who does not see it: one line each.
import {
  heading_text,
  level_text,
  metres_text,
  span_text,
  speed_text,
  type SpeedUnit,
} from '../look/units';
import { current_at } from '../session/currents';
import type { Sun } from '../session/around';
import type { Session } from '../session/state';
import type { Approach } from './approach';
import { site_in_words } from './site_words';

const NOT_SHOWN = 'Waves, wind, current, turbines and traffic of this run are not shown';
const EVERY_M = 10; // depths of which the current is told

function sun_words({ elevation_deg, azimuth_deg }: Sun): string {
  if (elevation_deg <= 0) return `The sun is ${(-elevation_deg).toFixed(0)}° below the horizon.`;
  const where = `${elevation_deg.toFixed(0)}° high at ${azimuth_deg.toFixed(0)}°`;
  return `The sun stands ${where}; a clear sky is supposed.`;
}

/** What of it is a forecast, what made up, what set by somebody. */
function water_words({ forecast, weather }: Session): string {
  const whose = forecast == null ? 'made up for this run' : `of the forecast ${forecast}`;
  const led = weather?.led ?? [];
  const by_hand = led.length === 0 ? '' : `; set by hand: ${led.join(', ').replaceAll('_', ' ')}`;
  return `Wind, waves and current are ${whose}${by_hand}. Vehicles are as the twin has them.`;
}

export function scene_in_words(
  session: Session,
  approaches: readonly Approach[],
  speed_unit: SpeedUnit,
): string[] {
  const lines: string[] = [];
  const { weather, turbines } = session;
  if (session.forecast !== undefined) lines.push(water_words(session));
  if (session.water_missing !== '') lines.push(`${NOT_SHOWN}: ${session.water_missing}.`);
  if (weather?.sun != null) lines.push(sun_words(weather.sun));
  lines.push(...site_in_words(session, speed_unit));
  const currents = weather?.currents ?? [];
  const deepest_m = currents.at(-1)?.up_m ?? 0;
  for (let up_m = 0; up_m >= deepest_m && currents.length > 1; up_m -= EVERY_M) {
    const at = current_at(currents, up_m);
    if (at === null) continue;
    const to = heading_text(Math.atan2(at.east_m_s, at.north_m_s));
    const speed = speed_text(Math.hypot(at.east_m_s, at.north_m_s), speed_unit, 2);
    lines.push(`Current ${-up_m} m deep: ${speed} to ${to}.`);
  }
  turbines?.places.forEach((place, nth) => {
    const now = weather?.farm?.each[nth];
    const where = `${metres_text(Math.hypot(place.east_m, place.north_m))} from the origin`;
    const power = `${((now?.power_w ?? 0) / 1e6).toFixed(1)} MW`;
    const makes = now === undefined ? '' : `: ${power} in ${speed_text(now.wind_m_s, speed_unit)}`;
    lines.push(`Turbine ${nth + 1}, ${where}${makes}.`);
  });
  for (const structure of session.structures)
    lines.push(
      `${structure.name}, ${level_text(structure.bottom_m)} to ${level_text(structure.top_m)}.`,
    );
  for (const [vehicle, nodes] of session.lines) {
    const length_m = nodes.slice(1).reduce((sum, node, i) => {
      const before = nodes[i]!;
      return (
        sum +
        Math.hypot(
          node.east_m - before.east_m,
          node.north_m - before.north_m,
          node.up_m - before.up_m,
        )
      );
    }, 0);
    const name = session.vehicles.get(vehicle)?.name ?? `vehicle ${vehicle}`;
    lines.push(`The tether of ${name}, ${metres_text(length_m)} of it out.`);
  }
  for (const { vessel, distance_m, in_s } of approaches)
    lines.push(`${vessel} comes as near as ${metres_text(distance_m)} in ${span_text(in_s)}.`);
  return lines;
}
