// The frames of a link, one after the other: whole ones, and such as tell what moved since.
import { decode_frame, type Frame } from './frame';
import { Moved } from './moved';

export class FrameReader {
  private moved = new Moved();
  /** The last frame could not be taken: a whole one is needed. */
  is_lost = false;

  /** Of another link: nothing is known. */
  forget(): void {
    this.moved = new Moved();
    this.is_lost = false;
  }

  /** Nothing where the bytes are no frame, or one that does not follow on what is known. */
  take(bytes: Uint8Array): Frame | null {
    const frame = decode_frame(bytes);
    const poses = frame === null ? null : this.moved.take(frame);
    this.is_lost = poses === null;
    if (frame === null || poses === null) return null;
    return { ...frame, poses };
  }
}
