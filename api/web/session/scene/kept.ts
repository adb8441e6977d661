// Things of the scene by a key: made when they come, taken away when they are gone.
import {
  BufferGeometry,
  Line,
  LineBasicMaterial,
  Mesh,
  type Object3D,
  type Scene,
  type Vector3,
} from 'three';

type PlainLine = Line<BufferGeometry, LineBasicMaterial>;

export class Kept {
  private readonly things = new Map<string, Object3D>();
  private seen = new Set<string>();
  constructor(private readonly scene: Scene) {}

  of<T extends Object3D>(key: string, make: () => T): T {
    this.seen.add(key);
    let thing = this.things.get(key) as T | undefined;
    if (thing === undefined) {
      thing = make();
      this.things.set(key, thing);
      this.scene.add(thing);
    }
    return thing;
  }

  /** A line that tells something: no haze hides it. */
  line(key: string, through: Vector3[], colour: string): void {
    const made = this.of<PlainLine>(key, () => {
      return new Line(new BufferGeometry(), new LineBasicMaterial({ fog: false }));
    });
    made.geometry.dispose();
    made.geometry = new BufferGeometry().setFromPoints(through);
    made.material.color.set(colour);
    made.frustumCulled = false;
  }

  drop_the_rest(): void {
    for (const [key, thing] of this.things) {
      if (this.seen.has(key)) continue;
      thing.traverse((part) => {
        if (!(part instanceof Mesh || part instanceof Line)) return;
        part.geometry.dispose();
        for (const material of [part.material].flat()) material.dispose();
      });
      this.scene.remove(thing);
      this.things.delete(key);
    }
    this.seen = new Set();
  }
}
