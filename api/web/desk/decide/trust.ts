// One line of trust: how far the last forecasts were off, beside the best simple method.
import { element } from '../../look/element';
import type { Look } from '../look/look';
import { NOT_KNOWN, is_known } from '../look/units';
import { told, type Answer } from './answer';
import type { Report, Trust } from './answers';

const OUTCOME: Record<Trust['outcome'], string> = {
  ahead: 'The forecast is better.',
  tie: 'A tie: the difference is within noise.',
  beaten: 'WORSE than the simple method.',
  alone: '',
};

/** An error in its own unit, speeds as the page shows speeds. */
export function error_text(value: number | null | undefined, unit: string, look: Look): string {
  if (!is_known(value)) return NOT_KNOWN;
  if (unit === 'm/s' || unit === 'm s-1') return look.speed(value, 2);
  return `${value.toFixed(2)} ${unit}`;
}

const days_text = (days: number): string => (days === 1 ? 'day' : `${days} days`);

export function trust_line(answer: Answer<Report>, look: Look): HTMLElement {
  const { trust, verified } = answer.body;
  const node = element('div', { class: 'trust' });
  trust.forEach((of, i) => {
    const shown = (value: number): string => error_text(value, of.unit, look);
    const line = element(
      'p',
      { 'data-outcome': of.outcome },
      `The ${of.variable} forecast of the last ${days_text(of.forecasts)} erred by `,
      element('strong', {}, told(answer, `trust.${i}.rmse`, shown)),
    );
    if (of.best_rival === null) line.append('; there is no simple method to compare with.');
    else {
      line.append(
        `; the best rival (${of.best_rival}) `,
        told(answer, `trust.${i}.rival_rmse`, shown),
        `. ${OUTCOME[of.outcome]}`,
      );
    }
    node.append(line);
  });
  if (trust.length === 0) node.append(element('p', {}, verified));
  return node;
}
