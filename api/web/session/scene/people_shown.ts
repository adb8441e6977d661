// Other people in the scene: where each stands and looks, what is pointed at, notes at places.
import { ConeGeometry, MathUtils, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';
import type { Colours } from '../look/palette';
import type { Look } from '../session/gathering';
import { holder_name, type Session } from '../session/state';
import { at_place } from './axes';
import type { Kept } from './kept';
import type { Name } from './labels';

const HEAD_M = 0.4;
const LOOKS_AHEAD_M = 3;

/** Where somebody looks, unit, in the scene's axes. */
export function direction_of(look: Pick<Look, 'heading_deg' | 'tilt_deg'>): Vector3 {
  const heading_rad = MathUtils.degToRad(look.heading_deg);
  const tilt_rad = MathUtils.degToRad(look.tilt_deg);
  const level = Math.cos(tilt_rad);
  return new Vector3(
    Math.sin(heading_rad) * level,
    Math.sin(tilt_rad),
    -Math.cos(heading_rad) * level,
  );
}

/** The same of a camera that looks along a direction. */
export function look_along(way: Vector3): Pick<Look, 'heading_deg' | 'tilt_deg'> {
  return {
    heading_deg: (MathUtils.radToDeg(Math.atan2(way.x, -way.z)) + 360) % 360,
    tilt_deg: MathUtils.radToDeg(Math.asin(MathUtils.clamp(way.y, -1, 1))),
  };
}

export function place_people(
  kept: Kept,
  session: Session,
  { accent, amber }: Pick<Colours, 'accent' | 'amber'>,
): void {
  for (const look of session.looks) {
    if (look.seat === session.seat) continue; // nobody sees their own head
    const head = kept.of(`head ${look.seat}`, () => {
      const cone = new ConeGeometry(0.6 * HEAD_M, 2 * HEAD_M, 10);
      cone.rotateX(-Math.PI / 2);
      return new Mesh(cone, new MeshBasicMaterial({ fog: false }));
    });
    head.material.color.set(accent);
    const from = at_place(look.from);
    head.position.copy(from);
    head.lookAt(from.clone().sub(direction_of(look))); // its tip is at -z
    const to =
      look.point === null
        ? from.clone().addScaledVector(direction_of(look), LOOKS_AHEAD_M)
        : at_place(look.point);
    kept.line(`gaze ${look.seat}`, [from, to], accent);
  }
  for (const note of session.notes) {
    const pin = kept.of(`note ${note.note}`, () => {
      return new Mesh(new SphereGeometry(0.25, 12, 8), new MeshBasicMaterial({ fog: false }));
    });
    pin.material.color.set(amber);
    pin.position.copy(at_place(note.at));
    kept.line(`note line ${note.note}`, [pin.position, at_place({ ...note.at, up_m: 0 })], amber);
  }
}

export function people_names(session: Session): Name[] {
  const names: Name[] = [];
  for (const look of session.looks) {
    if (look.seat === session.seat) continue;
    const text = holder_name(session, look.seat);
    names.push({ key: `head ${look.seat}`, text, at: look.from, tone: '' });
    if (look.point !== null)
      names.push({ key: `point ${look.seat}`, text: `${text} ▸`, at: look.point, tone: '' });
  }
  for (const note of session.notes)
    names.push({
      key: `note ${note.note}`,
      text: `${note.who}: ${note.text}`,
      at: note.at,
      tone: '',
    });
  return names;
}
