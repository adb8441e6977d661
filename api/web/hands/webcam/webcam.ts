// The webcam: on only between start and stop. Its picture goes to the element it is given and
// nowhere else.

export class Webcam {
  readonly video = document.createElement('video');
  private stream: MediaStream | null = null;

  constructor(private readonly on_end: () => void) {
    this.video.muted = true;
    this.video.playsInline = true;
  }

  /** @throws Error in words, where there is none or it is not allowed */
  async start(): Promise<void> {
    // Browsers have it for this machine and over TLS alone.
    const devices = navigator.mediaDevices as MediaDevices | undefined;
    if (devices === undefined)
      throw new Error('The browser gives a camera to pages over https or of this machine only.');
    try {
      this.stream = await devices.getUserMedia({
        audio: false,
        video: { width: { ideal: 640 }, height: { ideal: 480 }, facingMode: 'user' },
      });
    } catch (error) {
      throw new Error(reason_of(error));
    }
    for (const track of this.stream.getTracks()) track.addEventListener('ended', this.on_end);
    this.video.srcObject = this.stream;
    await this.video.play();
  }

  stop(): void {
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
