// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { element } from 'look/element';
import { listen_to_printer } from 'page/look/paper';

test('PaperOpensWhatIsClosedAndThePageClosesItAgain', () => {
  const details = (): HTMLDetailsElement => element('details', {}, element('summary'));
  const [closed, open] = [details(), details()];
  open.open = true;
  const cell = element('div', { class: 'task-cell' }, closed, open);
  document.body.replaceChildren(cell);
  listen_to_printer(
    () => 'night',
    () => 'Thu 13 Mar 06:00 UTC',
  );
  window.dispatchEvent(new Event('beforeprint'));
  expect([closed.open, open.open]).toEqual([true, true]);
  expect(document.documentElement.dataset.palette).toBe('day');
  expect(document.getElementById('printed')?.textContent).toBe('Printed Thu 13 Mar 06:00 UTC.');
  window.dispatchEvent(new Event('afterprint'));
  expect([closed.open, open.open]).toEqual([false, true]);
  expect(document.documentElement.dataset.palette).toBe('night');
});
