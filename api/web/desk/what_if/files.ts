// The changed texts as files that the command line takes, and the line that takes them.
import type { Asked, ChangedTexts } from './draft';

export interface ChangedFile {
  name: string;
  text: string;
}

export function changed_files(site: string, changed: ChangedTexts): ChangedFile[] {
  return [
    ...(changed.site === undefined ? [] : [{ name: `${site}.yaml`, text: changed.site }]),
    ...Object.entries(changed.tasks ?? {}).map(([id, text]) => ({ name: `${id}.yaml`, text })),
    ...(changed.plan === undefined ? [] : [{ name: `plan_${site}.yaml`, text: changed.plan }]),
  ];
}

export function command_lines(
  site: string,
  tasks: readonly string[],
  changed: ChangedTexts,
  asked: Asked,
): string[] {
  const at = changed.site === undefined ? site : `${site}.yaml`;
  const named = tasks.map((id) => (changed.tasks?.[id] === undefined ? id : `${id}.yaml`));
  const task_options =
    changed.tasks === undefined ? '' : named.map((id) => ` --task ${id}`).join('');
  const options = Object.entries(asked)
    .filter(([, value]) => value !== '')
    .map(([key, value]) => ` --${key} ${value}`)
    .join('');
  const windows = `slackwater windows --site ${at}${task_options}${options}`;
  if (changed.plan === undefined) return [windows];
  // With changed sheets the plan's own file has to name them.
  const sheets = Object.keys(changed.tasks ?? {}).map((id) => `task: ${id}.yaml`);
  const note = sheets.length === 0 ? '' : `   # write in it: ${sheets.join(', ')}`;
  return [windows, `slackwater plan plan_${site}.yaml${note}`];
}

export function save(file: ChangedFile): void {
  const url = URL.createObjectURL(new Blob([file.text], { type: 'text/yaml' }));
  const link = document.createElement('a');
  link.href = url;
  link.download = file.name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
