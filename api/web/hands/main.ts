// The page /session/hands, put together. It has no seat and no link to the server: all it can do is
// tell the page that opened it how fast the camera shall turn. The two are not tied, for the
// detector keeps this one busy, and would keep that one waiting.
import { NO_TURN } from '../look/camera_wish';
import { button, by_id, element, set_hidden, set_text } from '../look/element';
import { Follower } from './gesture/follower';
import type { Hand } from './gesture/hand';
import { asked_text, SEEN_TEXT, slow_text } from './say/words';
import { SessionPage } from './say/session_page';
import { Detector, has_detector } from './webcam/detector';
import { draw_mirror } from './webcam/mirror';
import { Webcam } from './webcam/webcam';

const TELL_EVERY_MS = 100;
const ANSWER_IS_OLD_MS = 1000;
const NO_DETECTOR =
  'This server has no detector of hands: build the program where npm reaches its registry, or ' +
  'put the files of @mediapipe/hands 0.4 into the folder "hands" of its data.';
const NO_SESSION = 'No session listens: open this page with "By hand" at the camera of a session.';

const palette = new URLSearchParams(location.search).get('palette');
if (palette === 'dusk' || palette === 'night') document.documentElement.dataset.palette = palette;

const follower = new Follower();
const webcam = new Webcam(() => stop('The camera was taken away.'));
const session_page = new SessionPage(location.hash.slice(1), (text) => {
  answered_ms = performance.now();
  set_text(answer, text);
});
let answered_ms = Number.NEGATIVE_INFINITY;
let detector: Detector | null = null;
let run = 0; // of the camera; 0 while it is off
let runs = 0;

const start_stop = button('Start the camera', () => void (run === 0 ? start() : stop('')), {
  disabled: true,
});
const mirrored = element('input', { type: 'checkbox', id: 'mirrored' });
const picture = element('canvas', {
  role: 'img',
  'aria-label': 'Your picture as in a mirror, with the landmarks of your hand',
});
const problem = element('p', { class: 'problem', role: 'alert' });
const seen = element('p', { class: 'seen', role: 'status' });
const asked = element('p', { class: 'asked' });
const answer = element('p', { class: 'answer', role: 'status' });
mirrored.addEventListener('change', () => {
  follower.forget();
  follower.is_mirrored = mirrored.checked;
});
by_id('built-without').replaceWith(
  element(
    'p',
    {},
    'Your picture stays in this window: it is not kept and not sent. Only how fast the camera of ' +
      'the vehicle shall turn and zoom goes to the session.',
  ),
  element(
    'ul',
    {},
    element('li', {}, 'Pinch thumb and index, then move the hand: pan and tilt that way.'),
    element('li', {}, 'Two fingers up: apart zooms in, together zooms out.'),
    element('li', {}, 'Open hand, fist or no hand: it stops.'),
  ),
  element(
    'div',
    { class: 'buttons' },
    start_stop,
    element(
      'span',
      { class: 'check' },
      mirrored,
      element('label', { for: 'mirrored' }, 'My camera gives a mirror picture'),
    ),
  ),
  problem,
  seen,
  asked,
  answer,
  picture,
  element(
    'p',
    { class: 'note' },
    'Experimental: proved on drawn hands of known pose, not on people. It needs this window and ' +
      "the session's in sight, and the helm.",
  ),
);
set_hidden(problem, true);
set_hidden(picture, true);
void has_detector().then((is_there) => {
  start_stop.disabled = !is_there;
  if (!is_there) complain(NO_DETECTOR);
});
setInterval(tell, TELL_EVERY_MS);
document.addEventListener('visibilitychange', () => follower.forget());
addEventListener('pagehide', () => stop(''));

function complain(text: string): void {
  set_text(problem, text);
  set_hidden(problem, text === '');
}

async function start(): Promise<void> {
  runs += 1;
  const this_run = runs;
  run = this_run;
  complain('');
  set_text(start_stop, 'Stop the camera');
  set_text(seen, 'The detector loads.');
  try {
    if (!(await webcam.start())) return;
    detector ??= await Detector.load();
  } catch (error) {
    if (run === this_run) stop(error instanceof Error ? error.message : String(error));
    return;
  }
  if (run !== this_run) return; // stopped meanwhile
  set_hidden(picture, false);
  void look(this_run, detector);
}

function stop(why: string): void {
  run = 0;
  webcam.stop();
  follower.forget();
  set_text(start_stop, 'Start the camera');
  set_text(seen, '');
  set_hidden(picture, true);
  complain(why);
  session_page.tell({ ...NO_TURN, picture_ms: performance.now() });
  tell();
}

/** Picture by picture, as fast as it goes. A hidden page has no frames, and so sees nothing. */
async function look(this_run: number, with_it: Detector): Promise<void> {
  let last_s = Number.NaN;
  while (run === this_run) {
    await new Promise(requestAnimationFrame);
    if (webcam.video.currentTime === last_s || webcam.video.videoWidth === 0) continue;
    last_s = webcam.video.currentTime;
    const picture_ms = performance.now();
    let hand: Hand | null;
    try {
      hand = await with_it.look(webcam.video);
    } catch (error) {
      detector = null; // its next start is a new one
      void with_it.close();
      stop(`The detector failed: ${error instanceof Error ? error.message : String(error)}`);
      return;
    }
    if (run !== this_run) return;
    follower.take(hand, picture_ms);
    complain(slow_text(performance.now() - picture_ms));
    draw_mirror(picture, webcam.video, hand, follower.is_mirrored);
    set_text(seen, SEEN_TEXT[follower.seen]);
    tell();
  }
}

function tell(): void {
  const now_ms = performance.now();
  const wish = follower.wish_at(now_ms);
  set_text(asked, run === 0 ? '' : asked_text(wish));
  if (run !== 0) session_page.tell(wish);
  if (run === 0) set_text(answer, '');
  else if (now_ms - answered_ms > ANSWER_IS_OLD_MS) set_text(answer, NO_SESSION);
}
