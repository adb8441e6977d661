// Where the floor or a table is that one looks at, as far as the headset finds such places (AR's
// hit-test, which not every one has).
import { Vector3 } from 'three';

export class FloorAhead {
  /** In the headset's metres; null: nothing is found there. */
  at: Vector3 | null = null;
  private is_over = false;
  private source: XRHitTestSource | null = null;

  async begin(session: XRSession): Promise<void> {
    try {
      const space = await session.requestReferenceSpace('viewer');
      this.source = (await session.requestHitTestSource?.({ space })) ?? null;
    } catch {
      this.source = null; // it was not granted
    }
    if (this.is_over) this.end();
  }

  end(): void {
    this.is_over = true;
    try {
      this.source?.cancel();
    } catch {
      // it went with its session
    }
    this.source = null;
    this.at = null;
  }

  look(frame: XRFrame, space: XRReferenceSpace): void {
    if (this.source === null) return;
    const pose = frame.getHitTestResults(this.source)[0]?.getPose(space);
    const place = pose?.transform.position;
    this.at = place === undefined ? null : new Vector3(place.x, place.y, place.z);
  }
}
