// The limits of a task's sheet that are one number, by where they stand in it.
import { isMap, isScalar, isSeq, parseDocument, type YAMLMap } from 'yaml';
import type { Path } from './yaml_text';

export interface Limit {
  path: Path;
  role: string; // of the agent that has it; '' where it is of the task
  variable: string; // as the sheet names it: "significant_wave_height_m"
  value: number;
  phases: string[]; // none: all
  at_depth_m: number | null; // where the sheet names it
}

/** In the order of the sheet. */
export function limits_of(sheet: string): Limit[] {
  const doc = parseDocument(sheet);
  const found: Limit[] = [];
  const read = (path: (string | number)[], role: string): void => {
    const list = doc.getIn(path);
    if (!isSeq(list)) return;
    list.items.forEach((item, i) => {
      const limit = isMap(item) ? limit_in(item as YAMLMap, [...path, i], role) : null;
      if (limit !== null) found.push(limit);
    });
  };
  read(['limits'], '');
  const agents = doc.getIn(['agents']);
  if (isSeq(agents)) {
    agents.items.forEach((_, a) => {
      const role = String(doc.getIn(['agents', a, 'role']) ?? '');
      read(['agents', a, 'limits'], role);
      read(['agents', a, 'conduct', 'limits'], role);
    });
  }
  return found;
}

/** The bound is the first key of a limit that has a number. */
function limit_in(item: YAMLMap, path: Path, role: string): Limit | null {
  for (const { key, value } of item.items) {
    if (!isScalar(key) || !isScalar(value) || typeof value.value !== 'number') continue;
    const variable = String(key.value);
    if (/^(at|heading)_/.test(variable)) continue; // where, or how she lies
    const phases = item.get('phases');
    const depth = item.get('at_depth_m');
    const named = isSeq(phases)
      ? phases.items.map((it) => String(isScalar(it) ? it.value : it))
      : [];
    return {
      path: [...path, variable],
      role,
      variable,
      value: value.value,
      phases: named,
      at_depth_m: typeof depth === 'number' ? depth : null,
    };
  }
  return null;
}

const UNITS: readonly (readonly [RegExp, string])[] = [
  [/_m_s$/, 'm/s'],
  [/_mm_h$/, 'mm/h'],
  [/_deg$/, 'degrees'],
  [/_n$/, 'N'],
  [/_c$/, 'degrees C'],
  [/_s$/, 's'],
  [/_m$/, 'm'],
];

/** "significant wave height at most", "m" */
export function limit_words(variable: string): { name: string; unit: string } {
  const unit = UNITS.find(([ending]) => ending.test(variable));
  const is_least = variable.startsWith('least_');
  const bare = variable.replace(/^least_/, '').replace(unit?.[0] ?? /$/, '');
  const words = bare.replace(/_10m$/, ' at 10 m').replaceAll('_', ' ');
  return { name: `${words} ${is_least ? 'at least' : 'at most'}`, unit: unit?.[1] ?? '' };
}
