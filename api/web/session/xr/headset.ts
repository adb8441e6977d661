// A session of WebXR from its beginning to its end. Whatever ends or hides it lets go of the
// vehicle's stick first, and the desk has its view again.
import type { Stick } from '../drive/stick';
import { notice } from '../look/notice';
import type { SceneView } from '../scene/scene_view';
import { HelmHand } from './helm_hand';
import { FEATURES_OF, SESSION_OF, SPACE_OF, type Mode } from './modes';
import { Stay, type Lent, type OnBoard } from './stay';

export class Headset {
  private readonly helm = new HelmHand();
  private stay: Stay | null = null;
  private is_asked = false;
  private is_wanted = false; // since it was asked for nobody has left

  constructor(private readonly lent: Lent) {}

  /** Somebody wears it and sees the scene: their hands have what a window calls the focus. */
  is_seen(): boolean {
    return this.stay?.session.visibilityState === 'visible';
  }
  is_worn(): boolean {
    return this.stay !== null;
  }
  /** What it says of the stick where no hand is on it; empty: nobody wears it. */
  words_at_rest(): string {
    if (this.stay === null) return '';
    return this.stay.wearer.is_table
      ? 'At the table nothing drives.'
      : 'Stick at rest. Squeeze or pinch to drive.';
  }
  words(): string {
    const { stay } = this;
    if (stay === null) return '';
    return `In the headset (${stay.mode === 'vr' ? 'VR' : 'AR'}): ${stay.hands_text()}.`;
  }
  on_board(): OnBoard {
    return this.stay?.on_board() ?? { lines: [], buttons: [] };
  }

  /** Its hands on the stick, with the other hands. */
  look(stick: Stick): void {
    if (!this.is_seen()) this.helm.lose();
    this.helm.look(stick, performance.now());
  }

  /** By a press of a button: the browser wants to see one. */
  async enter(mode: Mode, view: SceneView): Promise<void> {
    if (this.stay !== null || this.is_asked || navigator.xr === undefined) return;
    this.is_asked = true;
    this.is_wanted = true;
    try {
      const session = await navigator.xr.requestSession(SESSION_OF[mode], FEATURES_OF[mode]);
      if (this.is_wanted) await this.begin(mode, session, view);
      else await session.end();
    } catch (error) {
      if (this.is_wanted) notice(`The headset did not start: ${(error as Error).message}`, 'alarm');
      this.leave();
      if (this.stay !== null) this.over(this.stay, view);
    } finally {
      this.is_asked = false;
    }
    this.lent.on_change();
  }

  /** Also while the browser still asks whether one may enter. */
  leave(): void {
    this.is_wanted = false;
    void this.stay?.session.end().catch(() => undefined); // it has ended by itself
  }

  private async begin(mode: Mode, session: XRSession, view: SceneView): Promise<void> {
    const { renderer } = view;
    const stay = new Stay(mode, session, view, this.helm, this.lent, () => this.leave());
    this.stay = stay;
    session.addEventListener('end', () => this.over(stay, view));
    session.addEventListener('visibilitychange', () => {
      if (session.visibilityState !== 'visible') stay.let_go();
      if (session.visibilityState === 'hidden') this.leave(); // put down: nobody sees it
    });
    renderer.xr.enabled = true;
    renderer.xr.setReferenceSpaceType(SPACE_OF[mode]);
    // Before the session is set: after it the window's own loop would run beside the headset's.
    renderer.setAnimationLoop((now_ms, frame) => {
      if (frame !== undefined && this.stay === stay) stay.frame(now_ms, frame);
    });
    await renderer.xr.setSession(session);
    // Where it counts from elsewhere now, a hand has leaped that did not move.
    renderer.xr.getReferenceSpace()?.addEventListener('reset', () => stay.let_go());
  }

  /** The headset was taken off, the session was ended or lost: the desk has its view again. */
  private over(stay: Stay, view: SceneView): void {
    if (this.stay !== stay) return;
    this.stay = null;
    stay.end();
    // Once three has heard of it too, and has put back what it changed.
    setTimeout(() => {
      if (this.stay !== null) return;
      view.renderer.setAnimationLoop(null);
      view.renderer.xr.enabled = false;
      this.lent.on_change();
    });
  }
}
