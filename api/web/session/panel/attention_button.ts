// Off until somebody wants it: what this person looks at is kept in the record, by the pointer or,
// where that rests, by what is in the middle of the scene. The others are told nothing of it.
import { button, set_hidden, set_text } from '../../look/element';
import { Attention, type Gaze, type Gazed } from '../session/attention';
import type { Station } from '../station';

const LOOKS_EVERY_MS = 150;
const POINTER_RESTS_MS = 5000;

export function attention_button(station: Station, gazed: Gazed): HTMLButtonElement {
  const attention = new Attention();
  let is_kept = false;
  let pointer: { x: number; y: number; ms: number } | null = null;
  const toggle = button(
    'Keep what I look at',
    () => {
      is_kept = !is_kept;
      if (!is_kept) end();
      show();
    },
    {
      'aria-pressed': 'false',
      title:
        'In the record of this run: what is under your pointer, or in the middle of the scene.',
    },
  );
  addEventListener('pointermove', ({ clientX, clientY }) => {
    pointer = { x: clientX, y: clientY, ms: performance.now() };
  });
  document.documentElement.addEventListener('pointerleave', () => (pointer = null));

  function show(): void {
    toggle.setAttribute('aria-pressed', String(is_kept));
    set_text(toggle, is_kept ? 'What I look at is kept' : 'Keep what I look at');
    set_hidden(toggle, station.session.seat === null);
  }
  function end(): void {
    if (attention.ends()) station.wire.send({ do: 'attend', by: 'off' });
  }
  function gaze(now_ms: number): Gaze {
    if (document.hidden || !document.hasFocus()) return { on: '', by: 'head' };
    const is_resting = pointer === null || now_ms > pointer.ms + POINTER_RESTS_MS;
    return is_resting || pointer === null
      ? { on: gazed.ahead(), by: 'head' }
      : { on: gazed.under(pointer.x, pointer.y), by: 'pointer' };
  }
  let seat: number | null = null;
  setInterval(() => {
    if (station.session.seat !== seat) {
      seat = station.session.seat;
      is_kept = false; // each seat is asked anew
      attention.ends();
    }
    show();
    if (!is_kept || seat === null) return;
    const now_ms = performance.now();
    attention.tell(gaze(now_ms), now_ms, station.links, (news) => {
      return station.wire.send({ do: 'attend', ...news }) !== null;
    });
  }, LOOKS_EVERY_MS);
  return toggle;
}
