// The window of hands (api/web/hands), which this page opens and listens to: what it wishes of the
// camera goes out as this station's own orders, where those may go out.
import { button } from '../../look/element';
import { read_wish, shared_ms, wish_answer } from '../../look/camera_wish';
import { notice } from '../look/notice';
import type { Answer, CameraPointing } from '../session/message';
import type { Station } from '../station';
import { CameraHand } from './camera_hand';
import { gate_of } from './driver';
import { BLOCK_TEXT, block_of } from './stick';

const ORDER_BY_HAND_IS_VALID_MS = 1000;

export class HandWindow {
  readonly opener = button('By hand', () => this.open(), {
    title: 'Opens a window in which your hand before a webcam turns the camera. Experimental.',
  });
  private readonly hand = new CameraHand();
  private channel: BroadcastChannel | null = null;
  private vehicle: number | null = null;

  constructor(private readonly station: Station) {}

  /** As often as the stick. */
  tick(): void {
    const { station, hand } = this;
    if (station.chosen !== this.vehicle) {
      this.vehicle = station.chosen;
      hand.drop();
    }
    const order = hand.tick(shared_ms(performance.now()), this.block() === '', this.camera());
    if (order === null) return;
    const message = { do: 'camera', ...order };
    const on_answer = (answer: Answer): void => {
      if (answer.taken) return;
      hand.drop();
      notice(`Camera by hand: refused. ${answer.text || answer.reason}`, 'alarm');
    };
    if (!station.command('Camera by hand', message, on_answer, ORDER_BY_HAND_IS_VALID_MS))
      hand.drop();
  }

  /** The camera was turned at the controls: the hand does not turn it back. */
  overrule(camera: CameraPointing): void {
    this.hand.overrule(camera, shared_ms(performance.now()));
  }

  /** Each time a channel of its own: the window that was opened last is the one that is heard. */
  private open(): void {
    this.channel?.close();
    this.hand.drop();
    const name = `slackwater-hands-${crypto.getRandomValues(new Uint32Array(4)).join('-')}`;
    const channel = new BroadcastChannel(name);
    channel.addEventListener('message', (event) => {
      const wish = read_wish(event.data);
      if (wish === null) return;
      this.hand.take(wish, shared_ms(performance.now()));
      channel.postMessage(wish_answer(this.answer()));
    });
    this.channel = channel;
    // Without a tie to this page: its detector is not to keep this one waiting.
    const { palette } = this.station.settings;
    const how = 'noopener,popup,width=440,height=720';
    window.open(`/session/hands?palette=${palette}#${name}`, '_blank', how);
  }

  private camera() {
    const { session, chosen } = this.station;
    return chosen === null ? null : (session.statuses.get(chosen)?.camera ?? null);
  }

  /** Why nothing may be sent; empty: it may. The window of hands may have the focus, not a duty. */
  private block(): string {
    const block = block_of({ ...gate_of(this.station), has_focus: true });
    if (block === 'no_helm') return 'You do not have the helm.';
    return block === null ? '' : BLOCK_TEXT[block];
  }

  private answer(): string {
    const block = this.block();
    const name = this.station.chosen_name();
    if (block !== '') return block;
    if (this.camera() === null) return `${name} tells of no camera.`;
    if (this.hand.has_to_rest()) return 'Let the hand rest once.';
    return this.hand.is_turning() ? `Turns the camera of ${name}.` : `Ready: camera of ${name}.`;
  }
}
