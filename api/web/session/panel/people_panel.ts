// Who is here, and what they say.
import { element, labelled, set_hidden, set_text } from '../../look/element';
import { seconds_left } from '../look/units';
import type { Panel, Station } from '../station';

const WORDS_SHOWN = 8;

export function people_panel(station: Station): Panel {
  const seats = element('ul', { class: 'seats' });
  const said = element('ul', { class: 'said' });
  const words = element('input', { type: 'text', maxlength: 200 });
  const form = element(
    'form',
    { class: 'say' },
    labelled('Say to all', words),
    element('button', { type: 'submit' }, 'Say'),
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const text = words.value.trim();
    if (
      text !== '' &&
      station.ask('Say', { do: 'say', text }, (answer) => {
        if (!answer.taken) set_text(refusal, `Refused: ${answer.text || answer.reason}`);
        set_hidden(refusal, answer.taken);
      })
    )
      words.value = '';
  });
  const refusal = element('p', { class: 'problem', role: 'alert' });
  set_hidden(refusal, true);
  const box = element(
    'section',
    { class: 'people' },
    element('h2', {}, 'People'),
    seats,
    said,
    form,
    refusal,
  );
  let shown_said = '';

  return {
    box,
    show: () => {
      const { session } = station;
      set_hidden(box, session.playback !== null); // nobody is there any more
      const lines = [...session.seats.values()].map((seat) => {
        const you = seat.seat === session.seat ? ' (you)' : '';
        const left =
          seat.kept_until === null
            ? ''
            : `, seat kept ${seconds_left(seat.kept_until, station.clock_ms())} s`;
        return `${seat.name}${you}, ${seat.role}${seat.is_here ? '' : `, link down${left}`}`;
      });
      while (seats.children.length > lines.length) seats.lastChild?.remove();
      lines.forEach((text, i) => {
        const known = seats.children[i];
        if (known === undefined) seats.append(element('li', {}, text));
        else set_text(known, text);
      });
      const now = session.said.slice(-WORDS_SHOWN);
      const key = JSON.stringify(now);
      if (key !== shown_said) {
        shown_said = key;
        said.replaceChildren(
          ...now.map((it) => element('li', {}, element('strong', {}, `${it.name}: `), it.text)),
        );
      }
      set_hidden(said, now.length === 0);
      set_hidden(form, session.role === 'spectator');
    },
  };
}
