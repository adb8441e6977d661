// Which forecast this is, when it was issued, and what went into it.
import { element } from '../../look/element';
import type { Look } from '../look/look';
import type { ForecastInForce } from '../server/answers';
import { told, type Answer } from './answer';
import type { Report, Sources } from './answers';

export function provenance(
  answer: Answer<Report>,
  in_force: ForecastInForce | null,
  sources: Answer<Sources> | string,
  look: Look,
): HTMLElement {
  const time = (text: string): string => `${look.time(Date.parse(text))} ${look.zone_name}`;
  const same = (text: string): string => text;
  const list = element('dl', {});
  const line = (name: string, ...text: (Node | string)[]): void =>
    list.append(element('dt', {}, name), element('dd', {}, ...text));
  line('Forecast', told(answer, 'forecast.name', same));
  if (in_force !== null) line('Instance', in_force.instance);
  line('Issued', told(answer, 'forecast.issued', time));
  line(
    'Its checksum',
    told(answer, 'forecast.sha256', (sha: string) => sha.slice(0, 12)),
    ' (first 12 digits)',
  );
  line('Says of itself', told(answer, 'forecast.headline', same));
  line('Futures', told(answer, 'futures', String));
  const node = element('div', { class: 'provenance' }, list, element('h3', {}, 'Inputs'));
  if (typeof sources === 'string') {
    node.append(element('p', { class: 'note' }, sources));
    return node;
  }
  const lines = sources.body.sources.map((_, i) =>
    element(
      'li',
      {},
      told(sources, `sources.${i}.text`, (text: string) => readable(text, time)),
    ),
  );
  if (lines.length === 0) node.append(element('p', {}, 'No inputs are named.'));
  else node.append(element('ul', {}, ...lines));
  return node;
}

function readable(text: string, time: (text: string) => string): string {
  return text.replace(/\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ/g, (found) => time(found));
}
