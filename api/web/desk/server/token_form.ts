// The field for the server's token, in place of an answer that is refused for want of it.
import { button, element, labelled, set_hidden, set_text } from '../../look/element';
import { Refused, type Server } from './server';

const HINT =
  'Who runs the server has it: the first line of the file of --token-file. ' +
  'It is kept until this page is closed or loaded anew, and saved nowhere.';
const IN_CLEAR = ' This address is http: others on the network can read what is sent.';

/**
 * For the `catch` of what posts: the field, where the token is wanting. Other problems pass.
 * @param again  asks once more, with the token that was given
 */
export function or_token_form(
  server: Server,
  again: () => void,
): (problem: unknown) => HTMLElement {
  return (problem) => {
    if (!(problem instanceof Refused) || problem.status !== 401) throw problem;
    return token_form(server, problem.detail, again);
  };
}

function token_form(server: Server, why: string, again: () => void): HTMLElement {
  const input = element('input', { type: 'password', autocomplete: 'off', spellcheck: 'false' });
  const says = element('p', { class: 'refused', role: 'alert', hidden: true });
  const use = (): void => {
    const wrong = server.token.give(input.value);
    set_text(says, wrong ?? '');
    set_hidden(says, wrong === null);
    if (wrong !== null) return input.focus();
    input.value = '';
    again();
  };
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') use();
  });
  const hint = location.protocol === 'http:' ? HINT + IN_CLEAR : HINT;
  // Who has just typed a wrong one goes on in this field: the one before it is gone.
  setTimeout(() => {
    if (server.token.was_refused && document.activeElement === document.body) input.focus();
  });
  return element(
    'div',
    { class: 'token' },
    element('p', { class: 'refused' }, why),
    labelled('Token of the server', input, hint),
    says,
    button('Use this token', use),
  );
}
