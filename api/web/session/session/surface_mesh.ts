// A surface as the server draws it: corners, triangles, and the patch that each belongs to.
import { as_list, as_number, as_object, as_text } from './message';

export interface SurfaceMesh {
  name: string;
  kind: string;
  /** East, north, up of each corner, m. */
  corners: Float64Array;
  /** Three corners each. */
  triangles: Uint32Array;
  /** Of each triangle; -1: of none. */
  patch_of: Int32Array;
}

/** Nothing where one number of it is none, or points to what is not there. */
export function read_surface_mesh(value: unknown): SurfaceMesh | null {
  const it = as_object(value);
  if (it === null) return null;
  const numbers = (of: unknown): number[] | null => {
    const list = as_list(of).map(as_number);
    return list.every((one) => one !== null) ? list : null;
  };
  const [corners, triangles] = [numbers(it.corners), numbers(it.triangles)];
  const patch_of = numbers(it.patch_of);
  if (corners === null || triangles === null || patch_of === null) return null;
  const many = corners.length / 3;
  const is_one_of = (nth: number): boolean => Number.isInteger(nth) && nth >= 0 && nth < many;
  const is_patch = (nth: number): boolean => Number.isInteger(nth) && nth >= -1 && nth < 2 ** 31;
  const is_whole = Number.isInteger(many) && triangles.length === 3 * patch_of.length;
  if (!is_whole || patch_of.length === 0) return null;
  if (!triangles.every(is_one_of) || !patch_of.every(is_patch)) return null;
  return {
    name: as_text(it.name),
    kind: as_text(it.kind),
    corners: Float64Array.from(corners),
    triangles: Uint32Array.from(triangles),
    patch_of: Int32Array.from(patch_of),
  };
}
