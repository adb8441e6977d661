// The same in words: bed, wind, what is laid, thrusters at work, what is inspected and found.
import { heading_text, level_text, metres_text, percent_text } from '../look/units';
import { holes_in } from '../session/bed';
import { length_m } from '../session/laid';
import { vehicle_name, type Session } from '../session/state';
import { finding_text } from './site_names';
import { wind_of } from './wind_view';

function wind_words(session: Session): string[] {
  const wind = wind_of(session);
  if (wind === null) return [];
  const where = wind.is_at_hub ? 'at hub height, ' : '';
  const from = heading_text((wind.from_deg * Math.PI) / 180);
  const high = metres_text(wind.high_m);
  return [`Wind ${where}${high} up: ${wind.speed_m_s.toFixed(1)} m/s from ${from}.`];
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
      : ` At ${holes} of ${bed.up_m.length} places nobody knows it; it has holes there.`;
  const about = `over ${across} by ${across}, a height each ${metres_text(bed.step_m)}`;
  return [`The bed, ${about}: ${levels}; level beyond.${unknown}`];
}

function laid_words({ cables, moorings }: Session): string[] {
  const lines = cables.map(({ id, route, burial_m }) => {
    const buried = burial_m === 0 ? 'on the bed' : `${metres_text(burial_m, 1)} deep in the bed`;
    const how = burial_m === null ? 'nobody says whether it is buried' : buried;
    return `Cable ${id}, ${metres_text(length_m(route))} of it here; ${how}.`;
  });
  for (const { id, fairlead, anchor } of moorings) {
    const ends = `${level_text(fairlead.up_m)} to its anchor ${level_text(anchor.up_m)}`;
    const long = metres_text(length_m([fairlead, anchor]));
    lines.push(`Mooring ${id}, from ${ends}: ${long} in a straight way.`);
  }
  return lines;
}

function thrust_words(session: Session): string[] {
  const lines: string[] = [];
  for (const [vehicle, shares] of session.thrusts) {
    const names = session.vehicles.get(vehicle)?.thruster_names ?? [];
    const at_work = shares
      .map((share, nth) => ({ share, name: names[nth] ?? String(nth + 1) }))
      .filter(({ share }) => Math.abs(share) >= 0.02)
      .map(({ share, name }) => `${name} at ${percent_text(share)}`);
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
    lines.push(`${who} inspects ${of}: ${percent_text(seen)} covered${wanted}.`);
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

export function site_in_words(session: Session): string[] {
  return [
    ...wind_words(session),
    ...bed_words(session),
    ...laid_words(session),
    ...thrust_words(session),
    ...inspected_words(session),
    ...picture_words(session),
  ];
}
