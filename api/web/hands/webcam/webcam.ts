// The webcam: on only between start and stop, also where the browser answers a start after its
// stop. Its picture goes to its element and nowhere else.

export class Webcam {
  readonly video = document.createElement('video');
  private stream: MediaStream | null = null;
  private starts = 0; // and stops: what the browser grants is of the last one, or of none

  constructor(private readonly on_end: () => void) {
    this.video.muted = true;
    this.video.playsInline = true;
  }

  /**
   * False: it was stopped, or started anew, while the browser asked.
   * @throws Error in words, where there is none or it is not allowed
   */
  async start(): Promise<boolean> {
    this.stop();
    const this_start = this.starts;
    // Browsers have it for this machine and over TLS alone.
    const devices = navigator.mediaDevices as MediaDevices | undefined;
    if (devices === undefined)
      throw new Error('The browser gives a camera to pages over https or of this machine only.');
    let stream: MediaStream;
    try {
      stream = await devices.getUserMedia({
        audio: false,
        video: { width: { ideal: 640 }, height: { ideal: 480 }, facingMode: 'user' },
      });
    } catch (error) {
      throw new Error(reason_of(error));
    }
    if (this.starts !== this_start) {
      for (const track of stream.getTracks()) track.stop();
      return false;
    }
    this.stream = stream;
    for (const track of stream.getTracks()) track.addEventListener('ended', this.on_end);
    this.video.srcObject = stream;
    await this.video.play();
    return this.starts === this_start;
  }

  stop(): void {
    this.starts += 1;
    for (const track of this.stream?.getTracks() ?? []) track.stop();
    this.stream = null;
    this.video.srcObject = null;
  }
}

function reason_of(error: unknown): string {
  switch (error instanceof DOMException ? error.name : '') {
    case 'NotAllowedError':
      return 'The camera is not allowed for this page.';
    case 'NotFoundError':
      return 'There is no camera.';
    case 'NotReadableError':
      return 'The camera is in use, or does not answer.';
    default:
      return `The camera does not start: ${error instanceof Error ? error.message : String(error)}`;
  }
}
