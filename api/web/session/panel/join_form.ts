// Taking a seat: which session, who, and the token that was given out of band.
import { button, element, labelled, set_hidden, set_text } from '../../look/element';
import { begin_session, listed_sessions } from '../session/browser_means';
import {
  is_passing,
  session_label,
  session_of_address,
  to_join,
  type ListedSession,
  type SessionOffer,
} from '../session/session_list';

const LOOK_AGAIN_MS = 1000;

export interface JoinForm {
  readonly box: HTMLElement;
  show(is_busy: boolean, text: string): void;
}

export function join_form(
  on_join: (session_id: string, token: string, name: string) => void,
): JoinForm {
  const sessions = element('select', { required: true });
  const name = element('input', { type: 'text', maxlength: 40, autocomplete: 'nickname' });
  const token = element('input', {
    type: 'password',
    required: true,
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const join = element('button', { type: 'submit', class: 'strong' }, 'Join');
  const problem = element('p', { class: 'problem', role: 'alert' });
  set_hidden(problem, true);

  // A log that is watched again is open to whoever is at this machine.
  let recorded = new Set<string>();
  let is_first = true;
  const is_recorded = (): boolean => recorded.has(sessions.value);

  const begins = element('div', {
    class: 'buttons',
    role: 'group',
    'aria-label': 'Begin a session',
  });

  /** The one to be chosen once it is listed. */
  let wanted = session_of_address(location.search);
  /** The one that was begun here last: if it fails, it is said why. */
  let begun = '';
  const choose = (listed: ListedSession[], before: string): void => {
    const is_listed = (id: string): boolean => listed.some((it) => it.id === id);
    if (is_listed(wanted)) {
      sessions.value = wanted;
      wanted = '';
    } else if (is_listed(before)) sessions.value = before;
  };
  const fill = async (): Promise<void> => {
    const before = sessions.value;
    try {
      const { sessions: all, may_begin } = await listed_sessions();
      const listed = to_join(all);
      sessions.replaceChildren(
        ...listed.map((it) => element('option', { value: it.id }, session_label(it, listed))),
      );
      recorded = new Set(listed.filter((it) => it.state === 'recorded').map((it) => it.id));
      const missing = all.find((it) => [wanted, begun].includes(it.id) && !listed.includes(it));
      choose(listed, before);
      show_begins(may_begin);
      show_fields();
      if (is_first && listed.length === 1 && is_recorded()) on_join(sessions.value, '', '');
      is_first = false;
      if (missing?.state === 'failed') tell(`${missing.name} has failed: ${missing.why}.`);
      else if (missing !== undefined) tell(`${missing.name} is ${missing.state}.`);
      else if (listed.length === 0)
        tell(
          may_begin.length === 0
            ? 'There is no session now. Look again later.'
            : 'There is no session now. With the token of a supervisor you may begin one.',
        );
      else if (problem.dataset.of === 'list') set_hidden(problem, true);
      if (all.some((it) => is_passing(it)) && form.isConnected)
        setTimeout(() => void fill(), LOOK_AGAIN_MS);
    } catch (error) {
      tell(error instanceof Error ? error.message : 'The list of sessions could not be had.');
    }
  };
  const show_begins = (may_begin: SessionOffer[]): void => {
    const shown = JSON.stringify(may_begin);
    if (begins.dataset.shown === shown) return;
    begins.dataset.shown = shown;
    begins.replaceChildren(
      ...may_begin.map((it) => button(`Begin ${it.name}`, () => void begin(it))),
    );
    set_hidden(begins, may_begin.length === 0);
  };
  const begin = async (offer: SessionOffer): Promise<void> => {
    const secret = read_token();
    if (secret === null) return;
    try {
      wanted = begun = await begin_session(offer.id, secret);
    } catch (error) {
      tell_of('begin', error instanceof Error ? error.message : 'It could not be begun.');
      return;
    }
    if (problem.dataset.of === 'begin') set_hidden(problem, true);
    await fill();
  };
  const tell = (text: string): void => {
    // Why the last link ended is not lost for want of a list.
    if (problem.dataset.of === 'link' && !problem.hidden) return;
    tell_of('list', text);
  };
  const tell_of = (of: string, text: string): void => {
    problem.dataset.of = of;
    set_text(problem, text);
    set_hidden(problem, false);
  };
  /** The token that was typed; nothing where it is none, which is said. */
  const read_token = (): string | null => {
    const secret = token.value.trim();
    // Only these letters may stand in a sub-protocol's name; with others the browser would refuse
    // it.
    if (/^[A-Za-z0-9._~+-]+$/.test(secret)) return secret;
    tell_of('token', 'This is no token: it has letters, digits and . _ ~ + - only.');
    token.focus();
    return null;
  };

  const name_field = labelled(
    'Your name',
    name,
    'The others see it. A token that carries a name keeps its own.',
  );
  const token_field = labelled(
    'Token',
    token,
    'As it was given to you. It says whether you look on, drive or supervise.',
  );
  const show_fields = (): void => {
    set_hidden(name_field, is_recorded());
    set_hidden(token_field, is_recorded());
    token.required = !is_recorded();
  };
  sessions.addEventListener('change', show_fields);
  const form = element(
    'form',
    { class: 'join' },
    element('h2', {}, 'Join a session'),
    labelled('Session', sessions),
    name_field,
    token_field,
    problem,
    element(
      'div',
      { class: 'buttons' },
      join,
      button('Look again for sessions', () => void fill()),
    ),
    begins,
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (sessions.value === '') {
      tell('Choose a session first.');
      return;
    }
    if (is_recorded()) {
      on_join(sessions.value, '', '');
      return;
    }
    const secret = read_token();
    if (secret !== null) on_join(sessions.value, secret, name.value.trim());
  });
  void fill();
  return {
    box: form,
    show: (is_busy, text) => {
      join.disabled = is_busy;
      set_text(join, is_busy ? 'Joining' : 'Join');
      if (text !== '') {
        tell_of('link', text);
        void fill();
      } else if (is_busy) set_hidden(problem, true);
    },
  };
}
