// The last picture of a camera, at the far end of what it sees: right is right, up is up. From
// behind it is seen as through a pane.
import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  SRGBColorSpace,
  type Scene,
} from 'three';
import type { Pose } from '../session/frame';
import type { CameraPointing, Picture } from '../session/message';
import { camera_corners } from './marks';

export interface LastPicture {
  of: Picture;
  canvas: HTMLCanvasElement;
  is_old: boolean; // the vehicle may have gone on since
}

// By its moment, too: another session counts its pictures anew.
const key_of = ({ of }: LastPicture): string => `${of.vehicle} ${of.sensor} ${of.number} ${of.at}`;

export function aspect_of({ canvas }: LastPicture): number {
  return canvas.width / Math.max(1, canvas.height);
}

export class PictureView {
  private readonly pane: Mesh<BufferGeometry, MeshBasicMaterial>;
  private texture: CanvasTexture | null = null;
  private drawn = '';

  constructor(scene: Scene) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(12), 3));
    // Upper left, upper right, lower right, lower left, as the corners of a camera are told.
    const at = Float32Array.of(0, 1, 1, 1, 1, 0, 0, 0);
    geometry.setAttribute('uv', new BufferAttribute(at, 2));
    geometry.setIndex([0, 3, 1, 1, 3, 2]);
    const paint = new MeshBasicMaterial({ side: DoubleSide, fog: false });
    this.pane = new Mesh(geometry, paint);
    this.pane.frustumCulled = false;
    this.pane.visible = false;
    scene.add(this.pane);
  }

  show(pose: Pose, pointing: CameraPointing, picture: LastPicture): void {
    this.upload(picture);
    const at = this.pane.geometry.getAttribute('position') as BufferAttribute;
    camera_corners(pose, pointing, aspect_of(picture)).forEach((corner, nth) =>
      at.setXYZ(nth, corner.x, corner.y, corner.z),
    );
    at.needsUpdate = true;
    this.pane.visible = true;
  }

  hide(): void {
    this.pane.visible = false;
  }

  /** Only a picture that is new, or of another canvas. */
  private upload(picture: LastPicture): void {
    const key = key_of(picture);
    if (key === this.drawn && this.texture?.image === picture.canvas) return;
    this.drawn = key;
    // A texture keeps the size that it was made with; pictures of another camera have another.
    this.texture?.dispose();
    this.texture = new CanvasTexture(picture.canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.pane.material.map = this.texture;
    this.pane.material.needsUpdate = true;
  }
}
