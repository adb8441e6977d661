// Many of one body, drawn with one call: filled anew for each picture, as many as there are.
import {
  Color,
  InstancedMesh,
  Object3D,
  Sphere,
  Vector3,
  type BufferGeometry,
  type Material,
  type Scene,
} from 'three';
import { give_names } from './met';

const ALL_OVER = new Sphere(new Vector3(), Infinity);

export class Instances {
  /** Where one is put before it is added. */
  readonly part = new Object3D();
  private drawn: InstancedMesh;
  private many = 0;
  private before = 0; // as many were there
  private has_moved = false;
  private readonly names: string[] = [];

  constructor(
    private readonly scene: Scene | Object3D,
    geometry: BufferGeometry,
    material: Material,
    name = '', // of all of them, where one can be pressed
  ) {
    this.drawn = this.of(geometry, material, 16);
    this.drawn.name = name;
    scene.add(this.drawn);
  }

  get mesh(): InstancedMesh {
    return this.drawn;
  }

  begin(): void {
    this.before = this.many;
    this.many = 0;
  }

  /** None: nothing of it is drawn. */
  clear(): void {
    this.begin();
    this.end();
  }

  /** One more, where `part` is; `name`: its own. */
  add(colour: Color | null = null, name = ''): void {
    if (this.many === this.drawn.instanceMatrix.count) this.grow();
    this.part.updateMatrix();
    const { elements } = this.part.matrix;
    const at = this.drawn.instanceMatrix.array;
    const from = 16 * this.many;
    // Only what has moved goes to the graphics card anew.
    for (let i = 0; i < 16; i += 1) {
      const is = Math.fround(elements[i]!);
      if (at[from + i] === is) continue;
      at[from + i] = is;
      this.has_moved = true;
    }
    if (colour !== null) this.paint(colour);
    this.names[this.many] = name;
    this.many += 1;
  }

  end(): void {
    const { drawn } = this;
    drawn.count = this.many;
    drawn.visible = this.many > 0;
    if (this.has_moved || this.many > this.before) drawn.instanceMatrix.needsUpdate = true;
    this.has_moved = false;
  }

  dispose(): void {
    this.scene.remove(this.drawn);
    this.drawn.geometry.dispose();
    this.drawn.dispose();
  }

  private paint(colour: Color): void {
    const at = this.drawn.instanceColor?.array;
    const from = 3 * this.many;
    const is_same = [colour.r, colour.g, colour.b].every(
      (part, i) => at?.[from + i] === Math.fround(part),
    );
    if (is_same) return;
    this.drawn.setColorAt(this.many, colour);
    this.drawn.instanceColor!.needsUpdate = true;
  }

  private of(geometry: BufferGeometry, material: Material, most: number): InstancedMesh {
    const made = new InstancedMesh(geometry, material, most);
    made.frustumCulled = false; // its box is of one of them
    give_names(made, this.names);
    made.boundingSphere = ALL_OVER; // or it is reckoned anew for each picture
    return made;
  }

  private grow(): void {
    const before = this.drawn;
    const after = this.of(before.geometry, before.material as Material, 2 * this.many);
    after.name = before.name;
    after.renderOrder = before.renderOrder;
    (after.instanceMatrix.array as Float32Array).set(before.instanceMatrix.array);
    if (before.instanceColor !== null) {
      after.setColorAt(0, new Color());
      (after.instanceColor!.array as Float32Array).set(before.instanceColor.array);
    }
    this.scene.remove(before);
    before.dispose();
    this.scene.add(after);
    this.has_moved = true;
    this.drawn = after;
  }
}
