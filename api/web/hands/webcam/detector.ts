// The detector of hands, @mediapipe/hands: its files come from this server, what it looks at stays
// in this page.
import type { Hands, Results } from '@mediapipe/hands';
import type { Hand } from '../gesture/hand';

const MODEL = '/session/hands/model/';

declare global {
  interface Window {
    Hands?: typeof Hands; // left by its script
  }
}

/** Whether the server has its files. */
export async function has_detector(): Promise<boolean> {
  try {
    return (await fetch(`${MODEL}hands.binarypb`, { method: 'HEAD' })).ok;
  } catch {
    return false;
  }
}

export class Detector {
  private results: Results | null = null;

  private constructor(private readonly hands: Hands) {
    hands.setOptions({
      maxNumHands: 1, // looking for a second one takes four times as long
      modelComplexity: 0,
      minDetectionConfidence: 0.6,
      minTrackingConfidence: 0.6,
    });
    hands.onResults((results) => {
      this.results = results;
    });
  }

  /** @throws Error in words */
  static async load(): Promise<Detector> {
    if (window.Hands === undefined) await run_script(`${MODEL}hands.js`);
    if (window.Hands === undefined) throw new Error('The detector of hands does not load.');
    const hands = new window.Hands({ locateFile: (name) => MODEL + name });
    const made = new Detector(hands);
    try {
      await hands.initialize();
    } catch (error) {
      await made.close();
      throw error;
    }
    return made;
  }

  /** Gives back its memory; it has failed, so that closing may fail too. */
  async close(): Promise<void> {
    await this.hands.close().catch(() => undefined);
  }

  /** The hand that was found first and is still there. The page stands still meanwhile. */
  async look(video: HTMLVideoElement): Promise<Hand | null> {
    this.results = null;
    await this.hands.send({ image: video });
    const results = this.results as Results | null; // what its callback has left
    const landmarks = results?.multiHandLandmarks[0];
    if (landmarks === undefined) return null;
    const wide = video.videoWidth / video.videoHeight;
    return {
      landmarks: landmarks.map(({ x, y }) => ({ x: x * wide, y })),
      sureness: results?.multiHandedness[0]?.score ?? 0,
    };
  }
}

function run_script(address: string): Promise<void> {
  return new Promise((done, failed) => {
    const script = document.createElement('script');
    script.src = address;
    script.addEventListener('load', () => done());
    script.addEventListener('error', () => failed(new Error(`${address} does not load.`)));
    document.head.append(script);
  });
}
