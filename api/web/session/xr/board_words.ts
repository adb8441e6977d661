// What the board in the headset says: who drives what, how deep and how fast, who is here, and what
// one must hear of. And what can be pressed on it.
import { do_deed, DEED_TEXT, has_asked, helm_deeds } from '../drive/helm_deeds';
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
  is_strong: boolean;
  press: () => void;
}
/** What the page says elsewhere, and the board repeats. */
export interface SaidElsewhere {
  stick: string;
  stick_is_alarm: boolean;
  way: string;
  notice: string;
}

const OLD_MS = 1000;

export function board_lines(station: Station, said: SaidElsewhere): BoardLine[] {
  const { session, chosen, settings } = station;
  const lines: BoardLine[] = [];
  const say = (text: string, tone: BoardLine['tone'] = ''): void => {
    if (text !== '') lines.push({ text, tone });
  };
  say(chosen === null ? 'No vehicle is chosen' : station.chosen_name(), 'head');
  const pose = chosen === null ? undefined : session.poses.get(chosen);
  if (pose !== undefined) {
    const speed_m_s = Math.hypot(pose.east_m_s, pose.north_m_s, pose.up_m_s);
    say(`${level_text(pose.up_m)}, ${speed_text(speed_m_s, settings.speed_unit, 2)}`);
  }
  const helm = chosen === null ? undefined : session.helms.get(chosen);
  const words = helm_words(session, helm, station.clock_ms());
  say(words.state);
  say(words.countdown);
  if (session.role !== 'spectator') say(said.stick, said.stick_is_alarm ? 'alarm' : '');
  say(said.way, said.way.startsWith('Refused') ? 'alarm' : '');
  const age_ms = station.picture_age_ms();
  if (!(age_ms < OLD_MS)) say(`Picture ${age_text(age_ms)} old`, 'alarm');
  if (session.run.state !== 'running') say(run_text(session));
  for (const alarm of session.alarms.values()) {
    const in_s = alarm.cpa_s === null ? '' : ` in ${seconds_left(1000 * alarm.cpa_s, 0)} s`;
    say(`${alarm.with}: ${alarm.level}, ${metres_text(alarm.cpa_m)}${in_s}`, 'alarm');
  }
  const here = [...session.seats.values()].filter((it) => it.is_here && it.seat !== session.seat);
  say(`Here: ${here.length === 0 ? 'nobody else' : here.map((it) => it.name).join(', ')}`);
  say(said.notice);
  return lines;
}

export function may_hold(station: Station): boolean {
  return station.chosen !== null && (station.has_helm() || station.is_supervisor());
}

/** HOLD and the helm; what the headset itself has comes after them. */
export function helm_buttons(station: Station, hold: () => void): BoardButton[] {
  const buttons: BoardButton[] = [];
  if (may_hold(station)) buttons.push({ text: 'HOLD', is_strong: true, press: hold });
  for (const deed of helm_deeds(station)) {
    if (deed === 'ask' && has_asked(station)) continue;
    const press = (): void => do_deed(station, deed);
    buttons.push({ text: DEED_TEXT[deed], is_strong: false, press });
  }
  return buttons;
}
