// What a person has changed: the texts as they would be, and the hours and turbine asked about.
import { ring_around, rounded, type Trial } from '../trial';
import type { Place } from '../view';
import { value_in, with_added, with_exchanged, with_value, type Path } from './yaml_text';

export interface Texts {
  site: string;
  tasks: Record<string, string>;
  plan: string | null;
}
export interface ChangedTexts {
  site?: string;
  tasks?: Record<string, string>;
  plan?: string;
}
/** Of the question alone; '' is what the server takes by itself. */
export interface Asked {
  turbine: string;
  from: string;
  to: string;
}
export interface Crew {
  id: string;
  shift: string;
}
export interface PlanTask {
  index: number; // in the plan's list
  task: string;
  turbines: string[];
  priority: number;
}

export class Draft {
  asked: Asked = { turbine: '', from: '', to: '' };
  private site: string;
  private tasks: Record<string, string>;
  private plan: string | null;

  constructor(private readonly texts: Texts) {
    this.site = texts.site;
    this.tasks = { ...texts.tasks };
    this.plan = texts.plan;
  }

  task(id: string): string {
    return this.tasks[id] ?? '';
  }
  set_limit(task: string, path: Path, value: number): void {
    this.tasks[task] = with_value(this.task(task), path, value);
  }

  /** '' where the site has none: any hour. */
  get shift(): string {
    return String(value_in(this.site, ['shift']) ?? '');
  }
  set shift(hours: string) {
    this.site = with_value(this.site, ['shift'], hours);
  }
  get crews(): Crew[] {
    const list = this.plan === null ? [] : value_in(this.plan, ['crews']);
    if (!Array.isArray(list)) return [];
    return list.map((it: Partial<Crew>) => ({ id: it.id ?? '', shift: it.shift ?? '' }));
  }
  set_crew_shift(index: number, shift: string): void {
    if (this.plan !== null) this.plan = with_value(this.plan, ['crews', index, 'shift'], shift);
  }

  /** In the order of their priorities, of equal ones that of the file. */
  get plan_tasks(): PlanTask[] {
    const list = this.plan === null ? [] : value_in(this.plan, ['tasks']);
    if (!Array.isArray(list)) return [];
    const all = list.map((it: Partial<PlanTask>, index) => ({
      index,
      task: it.task ?? '',
      turbines: it.turbines ?? [],
      priority: it.priority ?? 1,
    }));
    return all.sort((a, b) => b.priority - a.priority || a.index - b.index);
  }
  /** Ahead of the one above it: their priorities are exchanged, or raised where they are equal. */
  move_up(place: number): void {
    const above = this.plan_tasks[place - 1];
    const moved = this.plan_tasks[place];
    if (above === undefined || moved === undefined) return;
    if (above.priority === moved.priority) {
      this.set_priority(moved.index, moved.priority + 1);
      return;
    }
    this.set_priority(moved.index, above.priority);
    this.set_priority(above.index, moved.priority);
  }
  private set_priority(index: number, priority: number): void {
    if (this.plan === null) return;
    this.plan = with_value(this.plan, ['tasks', index, 'priority'], priority);
  }

  /** Where there is no plan: the order of the site's own list. */
  get site_tasks(): string[] {
    const list = value_in(this.site, ['tasks']);
    return Array.isArray(list) ? list.map(String) : Object.keys(this.tasks);
  }
  move_site_task_up(place: number): void {
    if (place > 0) this.site = with_exchanged(this.site, ['tasks'], place - 1, place);
  }

  get turbines(): { id: string; place: Place }[] {
    return turbines_of(this.site);
  }
  move_turbine(id: string, place: Place): void {
    const index = this.turbines.findIndex((it) => it.id === id);
    if (index < 0) return;
    for (const key of ['latitude_deg', 'longitude_deg'] as const)
      this.site = with_value(this.site, ['turbines', index, key], rounded(place[key]));
  }
  /** Its id. */
  add_turbine(place: Place): string {
    const id = free_id('NEW', new Set(this.turbines.map((it) => it.id)));
    const [latitude_deg, longitude_deg] = [place.latitude_deg, place.longitude_deg].map(rounded);
    this.site = with_added(this.site, ['turbines'], { id, latitude_deg, longitude_deg });
    return id;
  }
  /** To keep out of, at any height and hour. */
  add_zone(place: Place, radius_m: number): void {
    const id = free_id('trial', new Set(zones_of(this.site).map((it) => it.id)));
    const polygon = ring_around(place, radius_m).map(([longitude_deg, latitude_deg]) => ({
      latitude_deg,
      longitude_deg,
    }));
    const zone = { id, kind: 'exclusion', reason: `on trial, ${radius_m} m around`, polygon };
    this.site = with_added(this.site, ['areas'], zone);
  }
  /** What of turbines and zones is not as the site has it. */
  get trial(): Trial {
    const before = new Map(turbines_of(this.texts.site).map(({ id, place }) => [id, place]));
    const is_other = (a: Place, b: Place | undefined): boolean =>
      b === undefined || a.longitude_deg !== b.longitude_deg || a.latitude_deg !== b.latitude_deg;
    const known = new Set(zones_of(this.texts.site).map(({ id }) => id));
    return {
      turbines: this.turbines
        .filter(({ id, place }) => is_other(place, before.get(id)))
        .map(({ id, place }) => ({ id, place, is_new: !before.has(id) })),
      zones: zones_of(this.site).filter(({ id }) => !known.has(id)),
    };
  }

  get changed(): ChangedTexts {
    const tasks = Object.entries(this.tasks).filter(([id, text]) => text !== this.texts.tasks[id]);
    return {
      ...(this.site === this.texts.site ? {} : { site: this.site }),
      ...(tasks.length === 0 ? {} : { tasks: Object.fromEntries(tasks) }),
      ...(this.plan === null || this.plan === this.texts.plan ? {} : { plan: this.plan }),
    };
  }
  get is_changed(): boolean {
    return Object.keys(this.changed).length > 0 || this.asked.turbine !== '';
  }
  /** The only tasks whose answer can differ; null: any. Fewer tasks are answered sooner. */
  get touched(): string[] | null {
    const { site, tasks } = this.changed;
    const is_alone = site === undefined && this.asked.turbine === '';
    return is_alone && tasks !== undefined ? Object.keys(tasks) : null;
  }
  /** What is asked of the server beside the texts. */
  query(): string {
    const query = new URLSearchParams(this.hours);
    if (this.asked.turbine !== '') query.set('turbine', this.asked.turbine);
    for (const id of this.touched ?? []) query.append('task', id);
    return query.toString();
  }
  /** The hours alone: what the true answer is asked for too. */
  get hours(): string {
    const { from, to } = this.asked;
    return new URLSearchParams({ ...(from && { from }), ...(to && { to }) }).toString();
  }
}

function entries(site: string, list: string): Record<string, unknown>[] {
  const found = value_in(site, [list]);
  return Array.isArray(found) ? (found as Record<string, unknown>[]) : [];
}

function turbines_of(site: string): { id: string; place: Place }[] {
  return entries(site, 'turbines').map(({ id, longitude_deg, latitude_deg }) => ({
    id: String(id),
    place: { longitude_deg: Number(longitude_deg), latitude_deg: Number(latitude_deg) },
  }));
}

function zones_of(site: string): Trial['zones'] {
  return entries(site, 'areas').map(({ id, polygon }) => ({
    id: String(id),
    ring: (Array.isArray(polygon) ? (polygon as Partial<Place>[]) : []).map((it) => [
      Number(it.longitude_deg),
      Number(it.latitude_deg),
    ]),
  }));
}

/** "NEW1", "NEW2": the first that nobody has. */
function free_id(stem: string, taken: ReadonlySet<string>): string {
  for (let n = 1; ; n += 1) if (!taken.has(`${stem}${n}`)) return `${stem}${n}`;
}
