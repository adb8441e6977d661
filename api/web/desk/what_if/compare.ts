// What changed between the true answers and those of the what-if.
import type { Plan, Start, Verdict, Windows } from '../decide/answers';
import { best_start } from '../decide/windows_row';

export interface TaskChange {
  task: string;
  name: string;
  before: TaskAnswer | null;
  after: TaskAnswer | null;
}
export interface TaskAnswer {
  index: number; // of the task in its answer
  verdict: Verdict;
  best: { index: number; start: Start } | null;
}

function answer_of(windows: Windows, name: string): TaskAnswer | null {
  const index = windows.tasks.findIndex(({ task }) => task === name);
  const task = windows.tasks[index];
  if (task === undefined) return null;
  const at = best_start(task);
  const start = task.starts[at];
  const best = start === undefined ? null : { index: at, start };
  return { index, verdict: task.verdict, best };
}

export function task_changes(before: Windows, after: Windows): TaskChange[] {
  const names = new Map([...after.tasks, ...before.tasks].map(({ task, name }) => [task, name]));
  return [...names].map(([task, name]) => ({
    task,
    name,
    before: answer_of(before, task),
    after: answer_of(after, task),
  }));
}

/** "better: +12 points, now 07:30"; "the same". */
export function change_text({ before, after }: TaskChange, hour: (time: string) => string): string {
  if (before === null) return 'only in the what-if';
  if (after === null) return 'could not be worked out';
  if (before.best === null || after.best === null) {
    return before.best === after.best ? 'the same' : 'other starts';
  }
  const points = Math.round(100 * (after.best.start.worth - before.best.start.worth));
  const is_moved = after.best.start.start !== before.best.start.start;
  const moved = is_moved ? `best start ${hour(after.best.start.start)}` : '';
  const by = points === 0 ? '' : `${points > 0 ? 'better' : 'worse'} by ${Math.abs(points)} points`;
  const parts = [by, moved].filter((part) => part !== '');
  return parts.length === 0 ? 'the same' : parts.join(', ');
}

export type JobChange = 'kept' | 'moved' | 'other team' | 'dropped' | 'added';
export interface PlanChange {
  job: string;
  change: JobChange;
  before: string | null; // start
  after: string | null;
}

export function plan_changes(before: Plan, after: Plan): PlanChange[] {
  const names = [...new Set([...before.jobs, ...after.jobs].map(({ job }) => job))];
  return names.map((job) => {
    const was = before.jobs.find((it) => it.job === job);
    const is = after.jobs.find((it) => it.job === job);
    return {
      job,
      change: job_change(was, is),
      before: was?.start ?? null,
      after: is?.start ?? null,
    };
  });
}

type Job = Plan['jobs'][number];
function job_change(was: Job | undefined, is: Job | undefined): JobChange {
  if (was === undefined) return 'added';
  if (is === undefined) return 'dropped';
  if (was.start !== is.start) return 'moved';
  return was.crew === is.crew && was.vessel === is.vessel ? 'kept' : 'other team';
}
