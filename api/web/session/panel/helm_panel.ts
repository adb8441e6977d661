// Who drives the chosen vehicle, who asks for it, and how long each has: the same words on both
// sides.
import { button, element, labelled, set_disabled, set_hidden, set_text } from '../../look/element';
import { DEED_TEXT, do_deed, has_asked, helm_deeds, type HelmDeed } from '../drive/helm_deeds';
import { seconds_left } from '../look/units';
import type { Helm } from '../session/message';
import { holder_name, type Session } from '../session/state';
import type { Panel, Station } from '../station';

export interface HelmWords {
  state: string;
  countdown: string;
}

/** What a person at this seat reads. */
export function helm_words(session: Session, helm: Helm | undefined, clock_ms: number): HelmWords {
  if (helm === undefined || helm.state === 'free') {
    const asks = session.playback === null ? ' Whoever asks gets the helm.' : '';
    return { state: `Nobody drives.${asks}`, countdown: '' };
  }
  const is_mine = helm.holder !== null && helm.holder === session.seat;
  const i_ask = helm.asker !== null && helm.asker === session.seat;
  const holder = is_mine ? 'You' : holder_name(session, helm.holder);
  const asker = i_ask ? 'you' : holder_name(session, helm.asker);
  const left =
    helm.until === null || !Number.isFinite(clock_ms) ? null : seconds_left(helm.until, clock_ms);
  const in_left = left === null ? '' : `${left} s left`;
  const home =
    helm.home_at === null || !Number.isFinite(clock_ms)
      ? ''
      : ` It goes home in ${seconds_left(helm.home_at, clock_ms)} s.`;
  switch (helm.state) {
    case 'held':
      return {
        state: is_mine ? 'You drive.' : `${holder} drives.`,
        countdown: left === null ? '' : `Without input given back in ${left} s.`,
      };
    case 'requested':
      if (is_mine)
        return {
          state: `You drive. ${asker} asks for the helm.`,
          countdown: `To answer: ${in_left}`,
        };
      return {
        state: `${holder} drives. ${i_ask ? 'You ask' : `${asker} asks`} for the helm.`,
        countdown: i_ask
          ? `Waiting for ${holder}: ${in_left}`
          : `${holder} has to answer: ${in_left}`,
      };
    case 'allowed':
      return {
        state: is_mine
          ? 'You drive. Anyone may take the helm.'
          : `${holder} drives and lets anyone take the helm.`,
        countdown: in_left,
      };
    case 'lost': {
      const waits =
        helm.asker === null ? '' : ` ${i_ask ? 'You ask' : `${asker} asks`} for the helm.`;
      return {
        state:
          (is_mine ? 'Your' : `${holder}'s`) + ` link is down. The vehicle holds.${waits}${home}`,
        countdown: left === null ? '' : `The seat is kept ${left} s.`,
      };
    }
  }
}

export function helm_panel(station: Station): Panel {
  const state = element('p', { class: 'helm-state' });
  const countdown = element('p', { class: 'countdown' });
  const deed = (what: HelmDeed, is_strong: boolean): HTMLButtonElement =>
    button(DEED_TEXT[what], () => do_deed(station, what), is_strong ? { class: 'strong' } : {});
  const ask = deed('ask', true);
  const grant = deed('grant', true);
  const deny = deed('deny', false);
  const give_back = deed('give_back', false);
  const allow = deed('allow', false);
  const take_back = button('Take back', () => {
    set_hidden(reason_form, false);
    reason.focus();
  });
  const reason = element('input', { type: 'text', maxlength: 200, required: true });
  const reason_form = element(
    'form',
    { class: 'inline' },
    labelled('Reason, for the record', reason),
    element(
      'div',
      { class: 'buttons' },
      element('button', { type: 'submit', class: 'strong' }, 'Take back now'),
      button('Not now', () => close_reason()),
    ),
  );
  const close_reason = (): void => {
    reason.value = '';
    set_hidden(reason_form, true);
  };
  reason_form.addEventListener('submit', (event) => {
    event.preventDefault();
    const words = reason.value.trim();
    if (words === '') return;
    if (station.ask('Take back', { do: 'take_back', vehicle: station.chosen, reason: words }))
      close_reason();
  });
  set_hidden(reason_form, true);
  const only_looks = element('p', { class: 'note' }, 'Spectators look on.');
  const box = element(
    'section',
    { class: 'helm' },
    element('h2', {}, 'Helm'),
    state,
    countdown,
    element('div', { class: 'buttons' }, ask, grant, deny, give_back, allow, take_back),
    reason_form,
    only_looks,
  );

  return {
    box,
    show: () => {
      const { session, chosen } = station;
      const helm = chosen === null ? undefined : session.helms.get(chosen);
      const words = helm_words(session, helm, station.clock_ms());
      set_text(state, chosen === null ? 'No vehicle is chosen.' : words.state);
      set_text(countdown, words.countdown);
      set_hidden(countdown, words.countdown === '');
      box.classList.toggle('urgent', helm?.state === 'requested' && helm.holder === session.seat);
      const mine = station.has_helm();
      const may = helm_deeds(station);
      const i_ask = has_asked(station);
      const is_free = helm === undefined || helm.state === 'free';
      set_hidden(only_looks, session.role !== 'spectator' || session.playback !== null);
      set_hidden(ask, !may.has('ask'));
      set_disabled(ask, i_ask);
      set_text(ask, i_ask ? 'Asked' : helm?.state === 'allowed' ? 'Take the helm' : DEED_TEXT.ask);
      set_hidden(grant, !may.has('grant'));
      set_hidden(deny, !may.has('deny'));
      set_hidden(give_back, !may.has('give_back'));
      set_hidden(allow, !may.has('allow'));
      set_hidden(take_back, !station.is_supervisor() || is_free || mine);
      if (take_back.hidden) set_hidden(reason_form, true);
    },
  };
}
