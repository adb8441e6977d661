// Names of things as signs in the scene, as large from near as from far: text of the page is not
// seen in a headset.
import {
  CanvasTexture,
  Group,
  LinearFilter,
  Sprite,
  SpriteMaterial,
  Vector3,
  type Matrix4,
  type Object3D,
} from 'three';
import { colours } from '../look/palette';
import { at_place } from '../scene/axes';
import { HIGH_PX as LINE_PX, spread, type Name, type Spot } from '../scene/labels';

const MOST = 16;
const HIGH_PX = 44;
const HIGH_RAD = 0.025; // as seen
const REDRAWN_MS = 500; // depths change all the time
const RANK = { alarm: 0, chosen: 1, '': 2 };

interface Sign {
  sprite: Sprite;
  text: string;
  drawn_ms: number;
}

function drawn(name: Name): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d')!;
  const font = `28px system-ui, sans-serif`;
  context.font = font;
  canvas.width = Math.ceil(context.measureText(name.text).width) + 24;
  canvas.height = HIGH_PX;
  const { paper, ink, accent, alarm } = colours();
  context.fillStyle = name.tone === 'alarm' ? alarm : name.tone === 'chosen' ? accent : paper;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.font = font; // a canvas that changes its size forgets it
  context.fillStyle = name.tone === '' ? ink : paper;
  context.textBaseline = 'middle';
  context.fillText(name.text, 12, HIGH_PX / 2);
  return canvas;
}

/** Where the head sees it, as if a sign's height were a line of the page; null: not before it. */
function spot_of(at: Vector3, into_head: Matrix4, wide: number): Spot | null {
  const seen = at.clone().applyMatrix4(into_head);
  if (seen.z >= 0) return null;
  const px = LINE_PX / HIGH_RAD;
  return { right: (seen.x / -seen.z) * px, down: (seen.y / seen.z) * px, wide: wide * LINE_PX };
}

export class NameSigns {
  readonly group = new Group();
  private readonly signs = new Map<string, Sign>();

  show(names: readonly Name[], head: Object3D, now_ms: number): void {
    const eye = head.getWorldPosition(new Vector3());
    const into_head = head.matrixWorld.clone().invert();
    const near = names
      .map((name) => ({ name, away_m: at_place(name.at).distanceTo(eye) }))
      .sort((a, b) => RANK[a.name.tone] - RANK[b.name.tone] || a.away_m - b.away_m)
      .slice(0, MOST);
    const keys = new Set(near.map(({ name }) => name.key));
    for (const [key, sign] of this.signs) if (!keys.has(key)) this.drop(key, sign);
    const placed = near.flatMap(({ name, away_m }) => {
      const { sprite } = this.sign_of(name, now_ms);
      sprite.position.copy(at_place(name.at));
      const { width, height } = (sprite.material.map as CanvasTexture).image as HTMLCanvasElement;
      const high_m = HIGH_RAD * away_m;
      sprite.scale.set((high_m * width) / height, high_m, 1);
      const spot = spot_of(sprite.position, into_head, width / height);
      return spot === null ? [] : [{ sprite, spot }];
    });
    // None on another, as far as that helps: lower by so many of its own heights.
    spread(placed.map((it) => it.spot)).forEach((free, nth) => {
      const { sprite, spot } = placed[nth]!;
      sprite.center.set(0, 1.4 + (free.down - spot.down) / LINE_PX);
    });
  }

  dispose(): void {
    for (const [key, sign] of this.signs) this.drop(key, sign);
  }

  private sign_of(name: Name, now_ms: number): Sign {
    let sign = this.signs.get(name.key);
    const text = `${name.tone} ${name.text}`;
    if (sign !== undefined && (sign.text === text || now_ms < sign.drawn_ms + REDRAWN_MS))
      return sign;
    if (sign !== undefined) this.drop(name.key, sign);
    const map = new CanvasTexture(drawn(name));
    map.minFilter = LinearFilter;
    map.generateMipmaps = false;
    const sprite = new Sprite(new SpriteMaterial({ map, fog: false, depthTest: false }));
    sprite.renderOrder = 100;
    sign = { sprite, text, drawn_ms: now_ms };
    this.signs.set(name.key, sign);
    this.group.add(sprite);
    return sign;
  }

  private drop(key: string, { sprite }: Sign): void {
    sprite.material.map?.dispose();
    sprite.material.dispose();
    this.group.remove(sprite);
    this.signs.delete(key);
  }
}
