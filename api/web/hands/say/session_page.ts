// The page of the session that opened this window: it is told the wish, and says what it makes of
// it, over a channel of this origin whose name the address has. Nothing else is said to anybody.
import { read_wish_answer, shared_ms, wish_message, type CameraWish } from '../../look/camera_wish';

export class SessionPage {
  private readonly channel: BroadcastChannel | null;

  /** @param name of the channel; empty: nobody opened this window */
  constructor(name: string, on_answer: (text: string) => void) {
    this.channel = name === '' ? null : new BroadcastChannel(name);
    this.channel?.addEventListener('message', (event) => {
      const text = read_wish_answer(event.data);
      if (text !== null) on_answer(text);
    });
  }

  /** @param wish its picture by the clock of this window */
  tell(wish: CameraWish): void {
    const picture_ms = shared_ms(wish.picture_ms);
    this.channel?.postMessage(wish_message({ ...wish, picture_ms }));
  }
}
