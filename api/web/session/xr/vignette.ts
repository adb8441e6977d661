// A dark frame about the view while one is moved: less of what streams past is seen.
import { BufferAttribute, Group, Mesh, MeshBasicMaterial, RingGeometry } from 'three';

const [OPEN, NARROW] = [3, 0.75]; // the hole's radius, a metre before the eyes

/** A ring whose inner edge is clear and whose outer edge is dark. */
function soft_ring(): RingGeometry {
  const ring = new RingGeometry(0.75, 1, 48, 1);
  const colours = new Float32Array(4 * ring.getAttribute('position').count);
  for (let i = 0; i < colours.length / 4; i += 1) colours[4 * i + 3] = i <= 48 ? 0 : 1;
  return ring.setAttribute('color', new BufferAttribute(colours, 4)) as RingGeometry;
}

export class Vignette {
  readonly group = new Group();
  private readonly parts: readonly Mesh<RingGeometry, MeshBasicMaterial>[];

  constructor() {
    const dark = { color: '#000000', depthTest: false, depthWrite: false, fog: false };
    const soft = new MeshBasicMaterial({ ...dark, transparent: true, vertexColors: true });
    this.parts = [
      new Mesh(soft_ring(), soft),
      new Mesh(new RingGeometry(1, 20, 48), new MeshBasicMaterial({ ...dark, transparent: true })),
    ];
    for (const part of this.parts) {
      part.renderOrder = 1000; // over all
      part.frustumCulled = false;
    }
    this.group.add(...this.parts);
    this.group.position.z = -1;
    this.show(0);
  }

  show(narrowed: number): void {
    this.group.visible = narrowed > 0;
    this.group.scale.set(OPEN + (NARROW - OPEN) * narrowed, OPEN + (NARROW - OPEN) * narrowed, 1);
  }

  dispose(): void {
    for (const part of this.parts) {
      part.geometry.dispose();
      part.material.dispose();
    }
  }
}
