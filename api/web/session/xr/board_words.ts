// What the board in the headset says: alarms, who drives what, how deep and how fast, what one must
// hear of, who is here. And what can be asked of the helm on it.
import { do_deed, DEED_TEXT, has_asked, helm_deeds } from '../drive/helm_deeds';
import { OLDEST_PICTURE_MS } from '../drive/stick';
import type { Said } from '../look/said';
import { age_text, level_text, metres_text, seconds_left, speed_text } from '../look/units';
import { helm_words } from '../panel/helm_panel';
import { run_text } from '../panel/top_bar';
import type { Station } from '../station';

export interface BoardLine {
  text: string;
  tone: '' | 'head' | 'alarm';
}
export interface BoardButton {
  text: string;
  press: () => void;
}
/** What the page says elsewhere, and the board repeats. */
export interface SaidElsewhere {
  stick: Said;
  way: Said;
  notice: Said;
}

/** What must be seen comes first: where the board is full the last lines are left out. */
export function board_lines(station: Station, said: SaidElsewhere): BoardLine[] {
  const { session, chosen, settings } = station;
  const lines: BoardLine[] = [];
  const say = (text: string, tone: BoardLine['tone'] = ''): void => {
    if (text !== '') lines.push({ text, tone });
  };
  const repeat = ({ text, is_alarm }: Said): void => say(text, is_alarm ? 'alarm' : '');
  say(chosen === null ? 'No vehicle is chosen' : station.chosen_name(), 'head');
  const age_ms = station.picture_age_ms();
  if (!(age_ms <= OLDEST_PICTURE_MS)) say(`Picture ${age_text(age_ms)} old`, 'alarm');
  for (const alarm of session.alarms.values()) {
    const in_s = alarm.cpa_s === null ? '' : ` in ${seconds_left(1000 * alarm.cpa_s, 0)} s`;
    say(`${alarm.with}: ${alarm.level}, ${metres_text(alarm.cpa_m)}${in_s}`, 'alarm');
  }
  const pose = chosen === null ? undefined : session.poses.get(chosen);
  if (pose !== undefined) {
    const speed_m_s = Math.hypot(pose.east_m_s, pose.north_m_s, pose.up_m_s);
    say(`${level_text(pose.up_m)}, ${speed_text(speed_m_s, settings.speed_unit, 2)}`);
  }
  const helm = chosen === null ? undefined : session.helms.get(chosen);
  const words = helm_words(session, helm, station.clock_ms());
  say(words.state);
  say(words.countdown);
  if (session.role !== 'spectator') repeat(said.stick);
  repeat(said.way);
  if (session.run.state !== 'running') say(run_text(session));
  repeat(said.notice);
  const here = [...session.seats.values()].filter((it) => it.is_here && it.seat !== session.seat);
  say(`Here: ${here.length === 0 ? 'nobody else' : here.map((it) => it.name).join(', ')}`);
  return lines;
}

/** What may be asked of the helm; what the headset itself has comes after it. */
export function helm_buttons(station: Station): BoardButton[] {
  return [...helm_deeds(station)]
    .filter((deed) => deed !== 'ask' || !has_asked(station))
    .map((deed) => ({ text: DEED_TEXT[deed], press: () => do_deed(station, deed) }));
}
