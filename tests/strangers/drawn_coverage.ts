// In a browser: coverage as it is painted on a pile, in each palette. Of patches that face the eye
// one pixel each is read back: covered ones have the tone of what is covered, the others that of
// what is not, and what is newly told changes its own patch alone.
import { Color, Vector3, type WebGLRenderer } from 'three';
import { SceneView } from 'page/scene/scene_view';
import { LEAST_SHADE } from 'page/scene/inspected_view';
import { colours, use_palette } from 'page/look/palette';
import { empty_session, show_frame, tell } from 'page/session/state';
import { read_surface_mesh } from 'page/session/surface_mesh';
import { Tracks } from 'page/view/tracks';
import style from '../page.css';
import { made_up_pile } from './made_up_surface';
import { pose_with } from './pose_for_tests';

const [AROUND, DOWN, RADIUS_M] = [40, 25, 3.5];
const sheet = document.createElement('style');
sheet.textContent = style;
document.head.append(sheet);
const session = empty_session();
const is_covered = (patch: number): boolean => (patch + Math.floor(patch / AROUND)) % 3 === 0;
const runs = (of: (patch: number) => boolean): number[][] =>
  Array.from({ length: AROUND * DOWN }, (_, i) => [i, 1]).filter(([i]) => of(i!));
tell(session, {
  is: 'welcome',
  vehicles: [{ vehicle: 0, name: 'rov', kind: 'rov', length_m: 0.6 }],
  // The foundation itself is drawn too, and must not show through its paint.
  structures: [
    { name: 'pile', east_m: 40, north_m: 30, radius_m: RADIUS_M, bottom_m: -25, top_m: 0 },
  ],
  surfaces: [
    { vehicle: 0, surface: 0, name: 'pile', kind: 'monopile', patches: AROUND * DOWN, seen: 0.3 },
  ],
  covered: [{ vehicle: 0, surface: 0, seen: 0.3, runs: runs(is_covered) }],
});
const rov = pose_with({ vehicle: 0, east_m: 40, north_m: 22, up_m: -12 }); // 4.5 m south of it
const frame = { number: 1, step: 1, time_s: 0, clock_ms: 0, is_whole: true, left_out: 0 };
show_frame(session, { ...frame, poses: [rov] });
const canvas = document.createElement('canvas');
canvas.style.cssText = 'width: 320px; height: 240px';
const box = document.createElement('div');
box.hidden = true;
document.body.append(canvas, box);
const view = new SceneView(canvas, box);
view.surround.is_clear = true;
const mesh = read_surface_mesh(made_up_pile(40, 30, AROUND, DOWN, { radius_m: RADIUS_M }));
const [surface] = session.surfaces.values();
view.site.inspected.take(surface!, mesh!);
view.eye.turn(0.6, -0.25); // from the south, level
const { renderer } = view as unknown as { renderer: WebGLRenderer };

/** Of a patch, by the server's own numbering: from the south on, the highest row first. */
function middle_of(patch: number): Vector3 {
  const turn = (2 * Math.PI * ((patch % AROUND) + 0.5)) / AROUND;
  const up_m = -25 * ((Math.floor(patch / AROUND) + 0.5) / DOWN);
  // On the chord between its corners.
  const radius_m = RADIUS_M * Math.cos(Math.PI / AROUND);
  return new Vector3(40 + radius_m * Math.sin(turn), up_m, -(30 - radius_m * Math.cos(turn)));
}

/** The tone of a patch in the picture; nothing: it is neither. */
function tone_at(patch: number): 'covered' | 'not_covered' | null {
  const at = middle_of(patch).project(view.eye.camera);
  const pixel = new Uint8Array(4);
  const gl = renderer.getContext();
  const [x, y] = [((at.x + 1) / 2) * canvas.width, ((at.y + 1) / 2) * canvas.height];
  gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  const [red = 0, green = 0, blue = 0] = pixel;
  const is = new Color().setRGB(red / 255, green / 255, blue / 255, 'srgb');
  for (const tone of ['covered', 'not_covered'] as const) {
    const as = new Color(colours()[tone]);
    // Of its shade alone, within what eight bits leave of dark colours.
    const within = (['r', 'g', 'b'] as const).every((part) => {
      const most = as[part] + 0.006;
      return is[part] <= most && is[part] >= LEAST_SHADE * as[part] - 0.006;
    });
    if (within) return tone;
  }
  return null;
}

const facing = [-3, -2, -1, 0, 1, 2].map((i) => (i + AROUND) % AROUND);
const patches = [10, 11, 12, 13].flatMap((row) => facing.map((i) => row * AROUND + i));
const faults: string[] = [];
let read = 0;
function check(what: string, of: (patch: number) => boolean): void {
  view.draw({ session, tracks: new Tracks(), chosen: 0, draft: null });
  for (const patch of patches) {
    const found = tone_at(patch);
    const expected = of(patch) ? 'covered' : 'not_covered';
    read += 1;
    if (found !== expected) faults.push(`${what}: patch ${patch} is ${found}, not ${expected}`);
  }
}
for (const palette of ['day', 'dusk', 'night'] as const) {
  use_palette(palette);
  check(palette, is_covered);
}
const news = patches.find((patch) => !is_covered(patch))!;
tell(session, { is: 'covered', vehicle: 0, surface: 0, seen: 0.31, runs: [[news, 1]] });
check('after one more', (patch) => is_covered(patch) || patch === news);
document.title = JSON.stringify({
  said: `${read} patches of a pile read back in three palettes, covered and not`,
  fault: faults.slice(0, 3).join('; '),
});
