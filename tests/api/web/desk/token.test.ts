// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { Refused, Server } from 'page/server/server';
import { or_token_form } from 'page/server/token_form';

const TOKEN = 'a-token-of-the-desk';

/** A server on another machine, that takes one token; what was posted with which is noted. */
function far_server(): { server: Server; shown: (string | null)[]; paths: string[] } {
  const shown: (string | null)[] = [];
  const paths: string[] = [];
  const ask = async (path: string, init: RequestInit = {}): Promise<Response> => {
    paths.push(path);
    const authorization = new Headers(init.headers).get('Authorization');
    shown.push(authorization);
    if (init.method !== 'POST' || authorization === `Bearer ${TOKEN}`) {
      return new Response(JSON.stringify({ taken: init.body ?? null }));
    }
    const status = 401;
    return new Response(JSON.stringify({ detail: 'Writing needs …', status }), { status });
  };
  const told = (): void => undefined;
  return { server: new Server(ask, told, () => 'bay'), shown, paths };
}

const turns = (): Promise<void> => new Promise((over) => setTimeout(over, 0));

test('ATokenIsSentWithWhatIsPostedAndWithNothingElse', async () => {
  const { server, shown, paths } = far_server();
  expect(server.token.give(` ${TOKEN}\n`)).toBeNull();
  await server.get('/sites/bay/windows');
  expect(await server.post('/sites/bay/what-if', { a: 1 })).toEqual({ taken: '{"a":1}' });
  expect(shown).toEqual([null, `Bearer ${TOKEN}`]);
  expect(paths.join()).not.toContain(TOKEN);
  const stored = [localStorage, sessionStorage].flatMap((it) => Object.values({ ...it }));
  expect(`${stored.join()} ${location.href} ${document.cookie}`).not.toContain(TOKEN);
});

test('WithoutATokenItIsSaidWhatIsWanted', async () => {
  const { server } = far_server();
  await expect(server.post('/x', {})).rejects.toMatchObject({
    status: 401,
    detail: expect.stringContaining('or for who shows'),
  });
});

test('AWrongTokenIsToldAndNotSentAgain', async () => {
  const { server, shown } = far_server();
  server.token.give('another-token');
  await expect(server.post('/x', {})).rejects.toMatchObject({
    status: 401,
    detail: expect.stringContaining('does not take this token'),
  });
  await expect(server.post('/x', {})).rejects.toMatchObject({
    detail: expect.stringContaining('or for who shows'),
  });
  expect(shown).toEqual(['Bearer another-token', null]);
});

test('ALateRefusalOfAnOldTokenDoesNotThrowTheNewOneAway', async () => {
  const { server } = far_server();
  server.token.give('another-token');
  const late = expect(server.post('/x', {})).rejects.toBeInstanceOf(Refused);
  server.token.give(TOKEN);
  await late;
  expect(await server.post('/x', {})).toEqual({ taken: '{}' });
});

test('WhatNoRequestCanCarryIsNoToken', () => {
  const { server } = far_server();
  for (const typed of ['', '  ', 'two words', 'clé-du-serveur', 'a\u0000b']) {
    expect(server.token.give(typed), typed).toContain('expected letters');
  }
  expect(server.token.headers).toEqual({});
});

test('TheFieldAsksAgainWithWhatWasTyped', async () => {
  const { server, shown } = far_server();
  const body = document.createElement('div');
  document.body.replaceChildren(body);
  const ask = async (): Promise<void> => {
    const coming = server.post<unknown>('/x', {}).then((it) => JSON.stringify(it));
    body.replaceChildren(await coming.catch(or_token_form(server, () => void ask())));
  };
  const type = async (text: string): Promise<void> => {
    const input = body.querySelector('input');
    if (input === null) throw new Error('there is no field for a token');
    input.value = text;
    body.querySelector('button')?.click();
    await turns();
  };
  await ask();
  expect(body.querySelector('label')?.textContent).toBe('Token of the server');
  expect(body.querySelector('input')?.type).toBe('password');
  await type('two words');
  expect(body.querySelector('[role=alert]')?.textContent).toContain('Found no token');
  expect(shown.length).toBe(1);
  await type('another-token');
  expect(body.textContent).toContain('does not take this token');
  await turns();
  expect(document.activeElement).toBe(body.querySelector('input'));
  expect(body.innerHTML).not.toContain('another-token');
  await type(TOKEN);
  expect(body.textContent).toBe('{"taken":"{}"}');
});

test('OtherRefusalsPassTheFieldBy', () => {
  const { server } = far_server();
  const form = or_token_form(server, () => undefined);
  expect(() => form(new Refused(404, 'no such site'))).toThrow('no such site');
  expect(() => form(new TypeError('a fault of the page'))).toThrow('a fault of the page');
});
