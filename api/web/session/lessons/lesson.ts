// Guided lessons: what is explained, a question, something to do with the weather, and what
// happens. Each is a file of data (en/*.json); another language is another folder of them.
import battery from './en/battery.json';
import forecast from './en/forecast.json';
import missed_crack from './en/missed_crack.json';
import slack_water from './en/slack_water.json';
import yesterday from './en/yesterday.json';

export const WATCHED = [
  'wind',
  'waves',
  'current',
  'water_visibility',
  'farm',
  'speed',
  'level',
  'charge',
  'reserve',
] as const;
export type Watched = (typeof WATCHED)[number];

export interface Lesson {
  title: string;
  says: string;
  question: { asks: string; choices: string[]; right: number; because: string };
  /** `weather` as the message of that name has it (api/docs/session_wire.md). */
  task: { says: string; weather: Record<string, unknown>; watch: Watched[] };
  happens: string;
}

/** What is wrong with a file of a lesson; empty: nothing. */
export function fault_of(lesson: Lesson): string {
  const { question, task } = lesson;
  const texts = [lesson.title, lesson.says, question.asks, question.because, task.says];
  if ([...texts, lesson.happens, ...question.choices].some((it) => it.trim() === ''))
    return 'a text is empty';
  if (question.choices.length < 2) return 'expected two choices at least';
  if (question.choices[question.right] === undefined) return 'the right choice is none of them';
  const strange = task.watch.find((it) => !WATCHED.includes(it));
  if (strange !== undefined) return `nobody knows what ${strange} is, to be watched`;
  return Object.keys(task.weather).length === 0 ? 'there is nothing to do' : '';
}

export const lessons = [slack_water, yesterday, battery, forecast, missed_crack] as Lesson[];
