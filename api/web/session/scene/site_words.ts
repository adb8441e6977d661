// The same in words: bed, wind, what is laid, thrusters at work, what is inspected and found.
import {
  done_text,
  heading_text,
  level_text,
  metres_text,
  percent_text,
  speed_text,
  type SpeedUnit,
} from '../look/units';
import { holes_in } from '../session/bed';
import { length_m } from '../session/laid';
import { vehicle_name, type Session } from '../session/state';
import { finding_text } from './site_names';
import { is_calm, wind_of } from './wind_view';

function wind_words(session: Session, speed_unit: SpeedUnit): string[] {
  const wind = wind_of(session);
  if (wind === null) return [];
  const where = wind.is_at_hub ? 'at hub height, ' : '';
  const { speed_m_s, from_deg } = wind;
  const from =
    from_deg === null ? ', its direction is not known' : ` from ${heading_of_deg(from_deg)}`;
  const what = is_calm(wind) ? 'calm' : `${speed_text(speed_m_s, speed_unit)}${from}`;
  return [`Wind ${where}${metres_text(wind.high_m)} up: ${what}.`];
}

function heading_of_deg(deg: number): string {
  return heading_text((deg * Math.PI) / 180);
}

function bed_words({ bed }: Session): string[] {
  if (bed === null) return [];
  let [deepest_m, highest_m] = [Infinity, -Infinity];
  for (const up_m of bed.up_m) {
    if (up_m === null) continue;
    deepest_m = Math.min(deepest_m, up_m);
    highest_m = Math.max(highest_m, up_m);
  }
  const [deepest, highest] = [deepest_m, highest_m].map(level_text);
  const levels = deepest === highest ? deepest : `${deepest} to ${highest}`;
  const across = metres_text((bed.across - 1) * bed.step_m);
  const holes = holes_in(bed);
  const unknown =
    holes === 0
      ? ''
      : ` The bed is unknown at ${holes} of ${bed.up_m.length} places: holes in the picture.`;
  const about = `over ${across} by ${across}, a height each ${metres_text(bed.step_m)}`;
  return [`The bed, ${about}: ${levels}; level beyond.${unknown}`];
}

function laid_words({ cables, moorings }: Session): string[] {
  const lines = cables.map(({ id, route, burial_m }) => {
    const buried = burial_m === 0 ? 'on the bed' : `buried ${metres_text(burial_m, 1)}`;
    const how = burial_m === null ? 'whether it is buried is not known' : buried;
    return `Cable ${id}: ${metres_text(length_m(route))} shown, ${how}.`;
  });
  for (const { id, fairlead, anchor } of moorings) {
    const ends = `from ${level_text(fairlead.up_m)} to its anchor ${level_text(anchor.up_m)}`;
    const long = metres_text(length_m([fairlead, anchor]));
    lines.push(`Mooring ${id}: ${ends}, ${long} in a straight line. How it hangs is not known.`);
  }
  return lines;
}

function push_text(share: number): string {
  return share < 0 ? `${percent_text(-share)} backwards` : percent_text(share);
}

function thrust_words(session: Session): string[] {
  const lines: string[] = [];
  for (const [vehicle, shares] of session.thrusts) {
    const names = session.vehicles.get(vehicle)?.thruster_names ?? [];
    const at_work = shares
      .map((share, nth) => ({ share, name: names[nth] ?? String(nth + 1) }))
      .filter(({ share }) => Math.abs(share) >= 0.02)
      .map(({ share, name }) => `${name} at ${push_text(share)}`);
    const what = at_work.length === 0 ? 'all at rest' : at_work.join(', ');
    if (shares.length > 0) lines.push(`Thrusters of ${vehicle_name(session, vehicle)}: ${what}.`);
  }
  return lines;
}

function inspected_words(session: Session): string[] {
  const lines: string[] = [];
  for (const { vehicle, name, kind, seen, asked } of session.surfaces.values()) {
    const of = kind === '' ? name : `${name} (${kind.replaceAll('_', ' ')})`;
    const wanted = asked === null ? '' : ` of ${percent_text(asked)} asked`;
    const who = vehicle_name(session, vehicle);
    lines.push(`${who} inspects ${of}: ${done_text(seen)} covered${wanted}.`);
  }
  for (const finding of [...session.findings.values()].flat()) {
    const by = finding.by === '' ? '' : `, by ${finding.by}`;
    const who = vehicle_name(session, finding.vehicle);
    const where = level_text(finding.at.up_m);
    lines.push(`${who} found: ${finding_text(finding)}, ${where}${by}.`);
  }
  return lines;
}

function picture_words(session: Session): string[] {
  return [...session.pictures.values()].map(({ vehicle, sensor, time_s }) => {
    const of = `${sensor.replaceAll('_', ' ')} of ${vehicle_name(session, vehicle)}`;
    return `The last picture of ${of} was taken at ${time_s.toFixed(1)} s of the run.`;
  });
}

export function site_in_words(session: Session, speed_unit: SpeedUnit): string[] {
  return [
    ...wind_words(session, speed_unit),
    ...bed_words(session),
    ...laid_words(session),
    ...thrust_words(session),
    ...inspected_words(session),
    ...picture_words(session),
  ];
}
