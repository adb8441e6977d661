// Taking a seat: which session, who, and the token that was given out of band.
import { button, element, labelled, set_hidden, set_text } from '../look/element';
import { listed_sessions } from '../session/browser_means';

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

  const fill = async (): Promise<void> => {
    const before = sessions.value;
    try {
      const listed = await listed_sessions();
      sessions.replaceChildren(
        ...listed.map((it) => {
          const seats =
            it.seats === null ? '' : it.seats === 1 ? ', 1 person' : `, ${it.seats} people`;
          return element(
            'option',
            { value: it.id },
            `${it.name} (${it.state || 'state not told'}${seats})`,
          );
        }),
      );
      if (listed.some((it) => it.id === before)) sessions.value = before;
      if (listed.length === 0) tell('There is no session now. Look again later.');
      else if (problem.dataset.of === 'list') set_hidden(problem, true);
    } catch (error) {
      tell(error instanceof Error ? error.message : 'The list of sessions could not be had.');
    }
  };
  const tell = (text: string): void => {
    // Why the last link ended is not lost for want of a list.
    if (problem.dataset.of === 'link' && !problem.hidden) return;
    problem.dataset.of = 'list';
    set_text(problem, text);
    set_hidden(problem, false);
  };

  const form = element(
    'form',
    { class: 'join' },
    element('h2', {}, 'Join a session'),
    labelled('Session', sessions),
    labelled('Your name', name, 'The others see it. A token that carries a name keeps its own.'),
    labelled(
      'Token',
      token,
      'As it was given to you. It says whether you look on, drive or supervise.',
    ),
    problem,
    element(
      'div',
      { class: 'buttons' },
      join,
      button('Look again for sessions', () => void fill()),
    ),
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const secret = token.value.trim();
    if (sessions.value === '') {
      tell('Choose a session first.');
      return;
    }
    // Only these letters may stand in a sub-protocol's name; with others the browser would refuse
    // it.
    if (!/^[A-Za-z0-9._~+-]+$/.test(secret)) {
      problem.dataset.of = 'token';
      set_text(problem, 'This is no token: it has letters, digits and . _ ~ + - only.');
      set_hidden(problem, false);
      token.focus();
      return;
    }
    on_join(sessions.value, secret, name.value.trim());
  });
  void fill();
  return {
    box: form,
    show: (is_busy, text) => {
      join.disabled = is_busy;
      set_text(join, is_busy ? 'Joining' : 'Join');
      if (text !== '') {
        problem.dataset.of = 'link';
        set_text(problem, text);
        set_hidden(problem, false);
        void fill();
      } else if (is_busy) set_hidden(problem, true);
    },
  };
}
