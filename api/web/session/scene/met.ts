// What a line from an eye meets: only what is drawn, by the name that it is told by.
import { Raycaster, type Intersection, type Object3D, type Vector3 } from 'three';

interface Told {
  names?: readonly string[]; // of each of many of one body, else one
  is_all_about?: boolean; // it hides, and nobody puts anything on it
}

const told_of = (thing: Object3D): Told => thing.userData;

export function give_names(thing: Object3D, names: readonly string[]): void {
  told_of(thing).names = names;
}
export function set_all_about(thing: Object3D): void {
  told_of(thing).is_all_about = true;
}

/** A line meets what is hidden, too: three looks at `visible` only where it draws. */
function drawn(things: readonly Object3D[]): Object3D[] {
  return things.flatMap((it) => (it.visible ? [it, ...drawn(it.children)] : []));
}

/** The nearest of things and their parts along a unit vector; nothing: none is there. */
export function met_along(
  things: readonly Object3D[],
  from: Vector3,
  ahead: Vector3,
): Intersection | null {
  return new Raycaster(from, ahead).intersectObjects(drawn(things), false)[0] ?? null;
}

/** Of what it is part of; empty: it has none. */
export function name_of({ object, instanceId }: Intersection): string {
  let thing: Object3D | null = object;
  while (thing !== null && told_of(thing).names === undefined) thing = thing.parent;
  return (thing !== null && told_of(thing).names?.[instanceId ?? 0]) || '';
}

/** Things of a scene that a line can meet: those with a name. */
export function that_hide(scene: Object3D): Object3D[] {
  return scene.children.filter((it) => it.name !== '');
}
/** Those of them that stand somewhere, and are not all about. */
export function that_can_be_pressed(scene: Object3D): Object3D[] {
  return that_hide(scene).filter((it) => told_of(it).is_all_about !== true);
}
