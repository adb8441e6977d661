// A board that goes along with who wears the headset: words above, buttons below, HOLD lowest, all
// pressed by a ray or a finger tip. It is drawn on a canvas, and anew only when its words have
// changed.
import {
  CanvasTexture,
  LinearFilter,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Raycaster,
  SRGBColorSpace,
  Vector2,
  Vector3,
} from 'three';
import { colours } from '../look/palette';
import type { BoardButton, BoardLine } from './board_words';
import { SIDES, type Side, type Spot } from './reading';

const [WIDE_PX, HIGH_PX, PER_M] = [560, 780, 1500];
const [EDGE_PX, LINE_PX, BUTTON_PX] = [20, 34, 54];
const [AWAY_M, BELOW_M, TO_THE_LEFT_RAD] = [0.65, 0.15, 0.6];
const LEFT_BEHIND_RAD = 1.4;
const [TOUCHES_M, LEAVES_M] = [0.01, 0.04];
const UP = new Vector3(0, 1, 0);

const LINES_FROM_PX = EDGE_PX + LINE_PX / 2;

/** Left, top, width, in the canvas. */
interface Box {
  x: number;
  y: number;
  wide: number;
}
/** HOLD is alone in the lowest row, whatever else there is: it is found without looking for it. */
export const HOLD_BOX: Box = {
  x: EDGE_PX,
  y: HIGH_PX - BUTTON_PX - 16,
  wide: WIDE_PX - 2 * EDGE_PX,
};

/** Where the others lie, two in a row, above it. */
export function button_boxes(many: number): Box[] {
  const rows = Math.ceil(many / 2);
  const wide = (WIDE_PX - 3 * EDGE_PX) / 2;
  return Array.from({ length: many }, (_, nth) => ({
    x: EDGE_PX + (nth % 2) * (wide + EDGE_PX),
    y: HOLD_BOX.y - (rows - Math.floor(nth / 2)) * (BUTTON_PX + 10),
    wide,
  }));
}

export class Board {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly canvas = document.createElement('canvas');
  private readonly texture: CanvasTexture;
  private placed: readonly { button: BoardButton; box: Box }[] = [];
  private drawn = '';
  private readonly touching = new Set<Side>(SIDES); // it must be seen away before it touches
  private is_placed = false;

  constructor() {
    this.canvas.width = WIDE_PX;
    this.canvas.height = HIGH_PX;
    this.texture = new CanvasTexture(this.canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.minFilter = LinearFilter;
    this.texture.generateMipmaps = false;
    this.mesh = new Mesh(
      new PlaneGeometry(WIDE_PX / PER_M, HIGH_PX / PER_M),
      new MeshBasicMaterial({ map: this.texture, fog: false }),
    );
  }

  /** To the left before the head; anew where it was left behind. */
  follow(head: Spot): void {
    const ahead = new Vector3(0, 0, -1).applyQuaternion(head.turned).setY(0);
    if (ahead.length() < 0.1) return; // looks straight up or down
    ahead.normalize();
    const to_it = this.mesh.position.clone().sub(head.at).setY(0);
    const is_near = this.is_placed && to_it.length() < 2 * AWAY_M;
    if (is_near && to_it.angleTo(ahead) < LEFT_BEHIND_RAD) return;
    this.is_placed = true;
    for (const side of SIDES) this.lose(side); // it came to the finger, not the finger to it
    const to = ahead.applyAxisAngle(UP, TO_THE_LEFT_RAD);
    this.mesh.position.copy(head.at).addScaledVector(to, AWAY_M);
    this.mesh.position.y -= BELOW_M;
    this.mesh.quaternion.setFromAxisAngle(UP, Math.atan2(-to.x, -to.z));
    this.mesh.updateMatrixWorld(true);
  }

  /** @param hold null: HOLD is not there, and its row stays empty */
  show(
    lines: readonly BoardLine[],
    hold: (() => void) | null,
    buttons: readonly BoardButton[],
  ): void {
    const boxes = button_boxes(buttons.length);
    const placed = buttons.map((button, nth) => ({ button, box: boxes[nth]! }));
    if (hold !== null) placed.push({ button: { text: 'HOLD', press: hold }, box: HOLD_BOX });
    this.placed = placed;
    const { paper, ink, alarm, accent, rule } = colours();
    const words = JSON.stringify([lines, placed.map((it) => it.button.text), paper]);
    const context = this.canvas.getContext('2d');
    if (words === this.drawn || context === null) return;
    this.drawn = words;
    context.fillStyle = paper;
    context.fillRect(0, 0, WIDE_PX, HIGH_PX);
    context.textBaseline = 'middle';
    const parts = lines.flatMap((line) => {
      const font = `${line.tone === 'head' ? 'bold 32' : '24'}px system-ui, sans-serif`;
      context.font = font;
      const colour = line.tone === 'alarm' ? alarm : ink;
      return wrapped(context, line.text).map((text) => ({ text, font, colour }));
    });
    const top_px = boxes[0]?.y ?? HOLD_BOX.y;
    const most = 1 + Math.floor((top_px - LINE_PX / 2 - LINES_FROM_PX) / LINE_PX);
    if (parts.length > most)
      parts.splice(most - 1, parts.length, { ...parts[most - 1]!, text: '…' });
    parts.forEach(({ text, font, colour }, nth) => {
      context.font = font;
      context.fillStyle = colour;
      context.fillText(text, EDGE_PX, LINES_FROM_PX + nth * LINE_PX);
    });
    context.font = 'bold 24px system-ui, sans-serif';
    context.textAlign = 'center';
    for (const { button, box } of placed) {
      const is_hold = box === HOLD_BOX;
      context.fillStyle = is_hold ? alarm : rule;
      context.fillRect(box.x, box.y, box.wide, BUTTON_PX);
      context.fillStyle = is_hold ? paper : ink;
      context.fillText(button.text, box.x + box.wide / 2, box.y + BUTTON_PX / 2, box.wide - 10);
    }
    context.textAlign = 'start';
    context.fillStyle = accent;
    context.fillRect(0, 0, WIDE_PX, 6);
    this.texture.needsUpdate = true;
  }

  /** What can be pressed, and where its middle is, in the headset's own metres. */
  buttons(): { text: string; at: Vector3 }[] {
    return this.placed.map(({ button, box }) => {
      const right_px = box.x + box.wide / 2 - WIDE_PX / 2;
      const up_px = HIGH_PX / 2 - box.y - BUTTON_PX / 2;
      const at = new Vector3(right_px / PER_M, up_px / PER_M, 0);
      return {
        text: button.text,
        at: at.applyQuaternion(this.mesh.quaternion).add(this.mesh.position),
      };
    });
  }

  /** True: the ray meets it, and what lies there is pressed, if anything does. */
  press(from: Vector3, ahead: Vector3): boolean {
    const [hit] = new Raycaster(from, ahead).intersectObject(this.mesh);
    if (hit?.uv === undefined) return false;
    this.button_at(hit.uv)?.press();
    return true;
  }

  /** A finger tip that comes through it presses once. In the headset's own metres. */
  touch(side: Side, tip: Vector3): boolean {
    const local = tip.clone().sub(this.mesh.position);
    local.applyQuaternion(this.mesh.quaternion.clone().invert());
    const at = new Vector2((local.x * PER_M) / WIDE_PX + 0.5, (local.y * PER_M) / HIGH_PX + 0.5);
    const is_over = Math.min(at.x, at.y, 1 - at.x, 1 - at.y) > 0;
    if (!is_over || Math.abs(local.z) > LEAVES_M) this.touching.delete(side);
    if (!is_over || Math.abs(local.z) > TOUCHES_M) return this.touching.has(side);
    if (!this.touching.has(side)) this.button_at(at)?.press();
    this.touching.add(side);
    return true;
  }

  /** The hand is gone: it must be seen away from the board before it touches it. */
  lose(side: Side): void {
    this.touching.add(side);
  }

  dispose(): void {
    this.texture.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private button_at(uv: Vector2): BoardButton | undefined {
    const [x, y] = [uv.x * WIDE_PX, (1 - uv.y) * HIGH_PX];
    const on = this.placed.find(
      ({ box }) => x >= box.x && x <= box.x + box.wide && y >= box.y && y <= box.y + BUTTON_PX,
    );
    return on?.button;
  }
}

/** As many parts as the width wants. */
function wrapped(context: CanvasRenderingContext2D, text: string): string[] {
  const parts: string[] = [];
  let part = '';
  for (const word of text.split(' ')) {
    const longer = part === '' ? word : `${part} ${word}`;
    if (part !== '' && context.measureText(longer).width > WIDE_PX - 2 * EDGE_PX) {
      parts.push(part);
      part = word;
    } else part = longer;
  }
  return [...parts, part];
}
