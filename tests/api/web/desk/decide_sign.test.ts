// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import type { Decision } from 'page/decide/answers';
import { decidePart } from 'page/decide/decide';
import { counting, one_line, signed, type Wish } from 'page/decide/sign_draft';
import { report, start, windows, windows_task } from './decide_made';
import { late_server, two_sites, type LateServer } from './late';

const decision = (some: Partial<Decision> = {}): Decision => ({
  id: 7,
  task: 'scour',
  turbine: 'A01',
  start: '2025-03-14T06:00:00Z',
  decided: 'no_go',
  by: 'B. Other',
  recorded_at: '2025-03-13T05:40:00Z',
  late: false,
  counts: true,
  note: null,
  hand_over: null,
  said: { probability: 0.7, verdict: 'marginal', why_nothing: null },
  came: { outcome: 'not_known_yet', broken: null, broken_at: null, why: null, not_checked: [] },
  ...some,
});
const wish: Wish = {
  key: 'today scour A01',
  task: 'scour',
  name: 'Scour survey at A01',
  turbine: 'A01',
  start: '2025-03-14T06:00:00Z',
  decided: 'go',
  why: '',
  said: '70 %',
};

test('TheRecordThatCountsIsOfTheSameTaskTurbineAndStart', () => {
  const all = [
    decision({ id: 1, counts: false }),
    decision({ id: 2, task: 'scan' }),
    decision({ id: 3, turbine: null }),
    decision({ id: 4, start: '2025-03-14T06:30:00Z' }),
    decision({ id: 5, start: '2025-03-14T06:00Z' }),
  ];
  expect(counting(all, wish)?.id).toBe(5);
  expect(signed(wish, ' A. Name ', 'tow\n call the port', 'abc', all)).toEqual({
    task: 'scour',
    turbine: 'A01',
    start: '2025-03-14T06:00:00Z',
    decided: 'go',
    by: 'A. Name',
    note: '',
    hand_over: 'tow / call the port',
    forecast: 'abc',
    in_place_of: 5,
  });
  const alone = signed({ ...wish, turbine: null }, 'A', '', 'abc', []);
  expect(alone.in_place_of).toBe(null);
  expect('turbine' in alone).toBe(false);
});

test('ANoteIsOneLineAndTheHandOverIsNoPartOfIt', () => {
  expect(one_line('')).toBe('');
  expect(one_line(' swell ')).toBe('swell');
  expect(one_line('tow at noon\n\n call the port ')).toBe('tow at noon / call the port');
  const both = signed({ ...wish, why: 'swell' }, 'A', 'tow', 'abc', []);
  expect([both.note, both.hand_over]).toEqual(['swell', 'tow']);
});

const SCOUR = windows_task({ starts: [start(6, 0.7), start(7, 0.95), start(8, 0.6)] });
const SCAN = windows_task({
  task: 'scan',
  name: 'Blade scan',
  turbines: [],
  starts: [start(6, 0.1)],
});
const KEPT = {
  '/windows': windows([SCOUR, SCAN]),
  '/verification': [],
  '/sources': { issued: '', day: '', sources: [] },
};
const turn = (): Promise<unknown> => new Promise((over) => setTimeout(over, 20));

async function page(decisions: Decision[] = []): Promise<LateServer & { sign: HTMLElement }> {
  const made = late_server(two_sites(), KEPT, { site: 'a' });
  const node = decidePart(made.desk);
  document.body.replaceChildren(node);
  await made.answer('/sites/a/report', report({ no_plan: 'none' }));
  await made.answer('/sites/a/decisions', { decisions, record: { text: null } });
  await turn();
  return { ...made, sign: node.querySelector('.sign-section') as HTMLElement };
}
const press = async (sign: HTMLElement, text: string): Promise<void> => {
  [...sign.querySelectorAll('button')].find((it) => it.textContent?.startsWith(text))?.click();
  await turn();
};
const choose = (sign: HTMLElement, task: number, value: string): void => {
  const box = sign.querySelectorAll('fieldset')[task]?.querySelector(`input[value="${value}"]`);
  (box as HTMLInputElement).checked = true;
  box?.dispatchEvent(new Event('change'));
};
const write = (field: Element | null | undefined, text: string): void => {
  (field as HTMLInputElement).value = text;
  field?.dispatchEvent(new Event('input'));
};
const who = (sign: HTMLElement): Element | null => sign.querySelector('.sign-who input');

test('NothingIsDecidedBeforehandAndNothingIsSentUnread', async () => {
  const { sign, waiting } = await page();
  const checked = [...sign.querySelectorAll<HTMLInputElement>('input[type="radio"]')].filter((it) =>
    it.hasAttribute('checked'),
  );
  expect(checked.map(({ value }) => value)).toEqual(['', '']);
  expect((who(sign) as HTMLInputElement).value).toBe('');
  await press(sign, 'Check');
  expect(sign.textContent).toContain('Nothing is decided yet');
  choose(sign, 0, 'go');
  await press(sign, 'Check');
  expect(sign.textContent).toContain('Nobody signs yet');
  write(who(sign), 'A. Name');
  await press(sign, 'Check');
  expect(sign.querySelector('.sign-asks')?.textContent).toContain('Go for Scour survey at A01');
  await press(sign, 'Back');
  expect(sign.querySelector('.sign-asks')?.textContent).toBe('');
  expect(waiting.filter(({ sent }) => sent !== '')).toEqual([]);
});

test('WhatIsReadIsWhatIsSigned', async () => {
  const before = decision({ start: '2025-03-14T07:00:00Z' });
  const { sign, waiting, answer } = await page([before]);
  choose(sign, 0, 'go');
  choose(sign, 1, 'no_go');
  write(sign.querySelectorAll('fieldset')[1]?.querySelector('input[type="text"]'), 'too rough');
  write(who(sign), 'A. Name');
  write(sign.querySelector('textarea'), 'tow at noon');
  await press(sign, 'Check');
  const asks = sign.querySelector('.sign-asks')?.textContent ?? '';
  expect(asks).toContain('The program says: 95 %');
  expect(asks).toContain('In place of No-go by B. Other');
  expect(asks).toContain('too rough. For the next shift: tow at noon');
  await press(sign, 'Sign as A. Name');
  // The best start by the server stands first in each field.
  expect(JSON.parse(waiting[0]?.sent ?? '')).toEqual({
    task: 'scour',
    turbine: 'A01',
    start: '2025-03-14T07:00:00Z',
    decided: 'go',
    by: 'A. Name',
    note: '',
    hand_over: 'tow at noon',
    forecast: 'efe11b41e9ec739392fc',
    in_place_of: 7,
  });
  await waiting[0]?.answer(decision({ id: 8, decided: 'go' }), 201);
  expect(JSON.parse(waiting[0]?.sent ?? '')).toMatchObject({
    task: 'scan',
    decided: 'no_go',
    note: 'too rough',
    hand_over: 'tow at noon',
    in_place_of: null,
  });
  const refusal = { title: 'Conflict', detail: 'found decision 9 on this start meanwhile' };
  await waiting[0]?.answer(refusal, 409);
  await turn();
  const says = sign.querySelector('.sign-says')?.textContent ?? '';
  expect(says).toContain('Recorded as number 8: Go for Scour survey at A01');
  expect(says).toContain('Not recorded: Blade scan');
  expect(says).toContain('found decision 9 on this start meanwhile');
  expect(says).not.toContain('number 9');
  // What was refused can be signed again without being written again.
  const chosen = (task: number): string | undefined =>
    [...(sign.querySelectorAll('fieldset')[task]?.querySelectorAll('input') ?? [])].find((it) =>
      it.hasAttribute('checked'),
    )?.value;
  expect([chosen(0), chosen(1)]).toEqual(['', 'no_go']);
  // The log is asked for anew, whatever is kept.
  await answer('/sites/a/decisions', { decisions: [decision({ id: 8 })], record: { text: null } });
  expect(document.querySelector('.decisions-section')?.textContent).toContain('B. Other');
});

test('AnotherForecastUndoesWhatWasChosenOnTheOneBefore', async () => {
  const { sign, desk, answer } = await page();
  choose(sign, 0, 'go');
  write(who(sign), 'A. Name');
  await press(sign, 'Check');
  desk.server.forget();
  desk.view.tell(new Set(['forecast']));
  const newer = { ...report().forecast, sha256: 'another' };
  await answer('/sites/a/report', report({ no_plan: 'none', forecast: newer }));
  await turn();
  expect(sign.querySelector('.sign-asks')?.textContent).toBe('');
  expect(sign.textContent).toContain('A new forecast came');
  expect((who(sign) as HTMLInputElement).value).toBe('A. Name');
  await press(sign, 'Check');
  expect(sign.textContent).toContain('Nothing is decided yet');
});

test('ALostAnswerIsNoRecordAndNoRefusal', async () => {
  const { sign, waiting, desk } = await page();
  choose(sign, 0, 'go');
  choose(sign, 1, 'go');
  write(who(sign), 'A. Name');
  await press(sign, 'Check');
  const post = desk.server.post.bind(desk.server);
  Object.assign(desk.server, {
    post: async (path: string, body: unknown) => {
      await post(path, body).catch(() => undefined);
      const { Refused } = await import('page/server/server');
      throw new Refused(0, 'The server does not answer.');
    },
  });
  await press(sign, 'Sign as');
  await waiting[0]?.answer({}, 500);
  await turn();
  const says = sign.querySelector('.sign-says')?.textContent ?? '';
  expect(says).toContain('Look into the log below before you sign it again.');
  expect(says).toContain('Blade scan, start Fri 14 Mar 06:00: not sent.');
});

test('WhatWasWrittenOutlivesAReportThatDoesNotCome', async () => {
  const { sign, desk, answer } = await page();
  choose(sign, 0, 'go');
  write(who(sign), 'A. Name');
  desk.server.forget();
  desk.view.set({ clock: 'site' });
  desk.view.tell(new Set(['forecast']));
  await answer('/sites/a/report', { title: 'x', detail: 'the disk is full' }, 500);
  await turn();
  expect(sign.textContent).toContain('Without the report nothing can be signed here.');
  expect((sign.querySelector('.sign-form') as HTMLElement).hidden).toBe(true);
  desk.view.tell(new Set(['forecast']));
  await answer('/sites/a/report', report({ no_plan: 'none' }));
  await turn();
  expect((sign.querySelector('.sign-form') as HTMLElement).hidden).toBe(false);
  expect(sign.textContent).not.toContain('Without the report');
  expect(sign.querySelector('input[value="go"]')?.hasAttribute('checked')).toBe(true);
});

test('FromAfarTheTokenIsAskedForAndWhatWasReadIsSigned', async () => {
  const { sign, waiting } = await page();
  choose(sign, 0, 'go');
  choose(sign, 1, 'no_go');
  write(who(sign), 'A. Name');
  await press(sign, 'Check');
  await press(sign, 'Sign as');
  await waiting[0]?.answer(decision({ id: 8, decided: 'go' }), 201);
  const scan = waiting[0]?.sent ?? '';
  await waiting[0]?.answer({ title: 'x', detail: 'no token' }, 401);
  await turn();
  expect(sign.querySelector('.sign-says')?.textContent).toContain('Recorded as number 8');
  const field = sign.querySelector('.token input') as HTMLInputElement;
  field.value = 'a-token-of-sixteen';
  await press(sign, 'Use this token');
  expect(waiting[0]?.sent).toBe(scan);
  await waiting[0]?.answer(decision({ id: 9, task: 'scan' }), 201);
  await turn();
  const says = sign.querySelector('.sign-says')?.textContent ?? '';
  expect(says).toContain('Recorded as number 8');
  expect(says).toContain('Recorded as number 9');
  expect(sign.querySelector('.token')).toBe(null);
});
