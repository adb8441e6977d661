// A session of WebXR from its beginning to its end. Whatever ends or hides it lets go of the
// vehicle's stick first, and the desk has its view again.
import type { Stick } from '../drive/stick';
import { notice } from '../look/notice';
import type { SceneView } from '../scene/scene_view';
import { HelmHand } from './helm_hand';
import { FEATURES_OF, SESSION_OF, SPACE_OF, type Mode } from './modes';
import { Stay, type Lent } from './stay';

export class Headset {
  private readonly helm = new HelmHand();
  private stay: Stay | null = null;
  private is_asked = false;

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

  /** Its hands on the stick, with the other hands. */
  look(stick: Stick): void {
    if (!this.is_seen()) this.helm.lose();
    this.helm.look(stick, performance.now());
  }

  /** By a press of a button: the browser wants to see one. */
  async enter(mode: Mode, view: SceneView): Promise<void> {
    if (this.stay !== null || this.is_asked || navigator.xr === undefined) return;
    this.is_asked = true;
    const { renderer } = view;
    try {
      const session = await navigator.xr.requestSession(SESSION_OF[mode], FEATURES_OF[mode]);
      const stay = new Stay(mode, session, view, this.helm, this.lent, () => this.leave());
      const over = (): void => this.over(stay, view);
      this.stay = stay;
      session.addEventListener('end', over);
      session.addEventListener('visibilitychange', () => {
        if (session.visibilityState !== 'visible') stay.let_go();
      });
      renderer.xr.enabled = true;
      renderer.xr.setReferenceSpaceType(SPACE_OF[mode]);
      // Before the session is set: after it the window's own loop would run beside the headset's.
      renderer.setAnimationLoop((now_ms, frame) => {
        if (frame !== undefined && this.stay === stay) stay.frame(now_ms, frame);
      });
      await renderer.xr.setSession(session);
    } catch (error) {
      notice(`The headset is not there: ${(error as Error).message}`, 'alarm');
      this.leave();
      if (this.stay !== null) this.over(this.stay, view);
    } finally {
      this.is_asked = false;
    }
    this.lent.on_change();
  }

  leave(): void {
    void this.stay?.session.end().catch(() => undefined); // it has ended by itself
  }

  /** The headset was taken off, the session was ended or lost: the desk has its view again. */
  private over(stay: Stay, view: SceneView): void {
    if (this.stay !== stay) return;
    stay.let_go();
    this.stay = null;
    stay.wearer.dispose();
    // Once three has heard of it too, and has put back what it changed.
    setTimeout(() => {
      if (this.stay !== null) return;
      view.renderer.setAnimationLoop(null);
      view.renderer.xr.enabled = false;
      this.lent.on_change();
    });
  }
}
