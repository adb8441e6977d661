// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { whatIfPart } from 'page/what_if/what_if';
import { start, windows, windows_task } from './decide_made';
import { late_server, site_answer, two_sites, type LateServer } from './late';

const texts = (id: string): unknown => ({
  site: `id: ${id}\nshift: 06:00-18:00\ntasks: [scan]\n`,
  tasks: { scan: 'limits: [{ wind_speed_10m_m_s: 12 }]\n' },
  plan: null,
});
const answered = (worth: number): unknown => ({
  windows: windows([windows_task({ task: 'scan', starts: [start(6, worth)] })]),
  plan: null,
  no_plan: null,
});
const KEPT = {
  '/sites/a/texts': texts('a'),
  '/windows': windows([windows_task({ task: 'scan', starts: [start(6, 0.5)] })]),
  '/plan': {},
  '/sites/a/workability': {},
};

async function opened(more: Record<string, unknown> = {}): Promise<{
  server: LateServer;
  node: HTMLElement;
  change: (value: number) => Promise<void>;
  outcome: () => string;
}> {
  const kept = { ...KEPT, ...more };
  const server = late_server(two_sites(), kept, { site: 'a' });
  const node = whatIfPart(server.desk);
  document.body.replaceChildren(node);
  await server.answer('/sites/a', site_answer('a'));
  const change = async (value: number): Promise<void> => {
    const input = node.querySelector<HTMLInputElement>('.limit-list input');
    if (input === null) throw new Error('there is no limit to change');
    input.value = String(value);
    input.dispatchEvent(new Event('input'));
    await new Promise((over) => setTimeout(over, 350));
  };
  const outcome = (): string =>
    node.querySelector('.what-if-outcome .section-body')?.outerHTML ?? '';
  return { server, node, change, outcome };
}

test('AnAnswerThatComesAfterTheChangeWasTakenBackIsNotShown', async () => {
  const { server, node, change, outcome } = await opened();
  await change(16);
  const back = [...node.querySelectorAll('button')].find((it) =>
    it.textContent?.startsWith('Back'),
  );
  back?.click();
  await server.answer('/what-if', answered(0.33));
  expect(outcome()).toContain('Nothing is changed.');
  expect(outcome()).not.toContain('33 %');
  expect(outcome()).not.toContain('aria-busy');
});

test('AChangeTypedBackIsNoChange', async () => {
  const { server, change, outcome } = await opened();
  await change(16);
  await change(12);
  await server.answer('/what-if', answered(0.33));
  expect(outcome()).toContain('Nothing is changed.');
});

test('WhatIsAskedOfOneSiteIsNotShownOfAnother', async () => {
  const { server, node, change, outcome } = await opened({ '/sites/b': site_answer('b') });
  await change(16);
  server.desk.view.set({ site: 'b' });
  await server.answer('/what-if', answered(0.33));
  expect(outcome()).toContain('Nothing is changed.');
  expect(node.textContent).not.toContain('33 %');
});

test('TextsThatComeTooLateDoNotReplaceThoseOfTheSiteShown', async () => {
  const { server, change } = await opened();
  server.desk.view.set({ site: 'b' });
  server.desk.view.set({ site: 'a' });
  await new Promise((over) => setTimeout(over, 5));
  await server.answer('/sites/b/texts', texts('b'));
  await server.answer('/sites/b', site_answer('b'));
  await change(17);
  const asked = server.waiting.find(({ path }) => path === '/sites/a/what-if');
  expect(JSON.parse(asked?.sent ?? '{}').texts).toEqual({
    tasks: { scan: 'limits: [{ wind_speed_10m_m_s: 17 }]\n' },
  });
});

test('AChangeWhileOneIsWorkedOutWaitsItsTurnAndSaysSo', async () => {
  const { server, change, outcome } = await opened();
  await change(16);
  await change(17);
  expect(server.waiting.filter(({ path }) => path.includes('what-if')).length).toBe(1);
  expect(outcome()).toContain('Asking the server');
  await server.waiting[0]?.answer(answered(0.33));
  expect(outcome()).toContain('Asking the server');
  await server.answer('/what-if', answered(0.44));
  expect(outcome()).toContain('44 %');
  expect(outcome()).not.toContain('Asking the server');
});
