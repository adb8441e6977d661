// Thrusters at work: at each mount of a vehicle near the eye the water that it throws, opposite to
// its push, the longer the more it gives; and the rings that the thrusters turn in.
import {
  ConeGeometry,
  CylinderGeometry,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
  type Scene,
} from 'three';
import type { Pose } from '../session/frame';
import type { Vehicle } from '../session/message';
import type { Mount, OfBody } from '../session/thrust';
import { at_place, turned } from './axes';
import { Instances } from './instances';

const LEAST_SHARE = 0.02;
const LONG_PER_VEHICLE = 1.2; // of a jet at full push, in lengths of its vehicle
const LONGEST_M = 4;
const RING_PER_VEHICLE = 0.07;

/** To the axes of a shape whose bow looks along -z, its mast along y. */
export function of_shape([forward, right, down]: OfBody): Vector3 {
  return new Vector3(right, -down, -forward);
}

export interface Jet {
  from: Vector3;
  to: Vector3; // its far end
}

/** In the scene's axes; nothing: it rests. */
export function jet_of(mount: Mount, share: number, pose: Pose, length_m: number): Jet | null {
  if (Math.abs(share) < LEAST_SHARE) return null;
  const most_m = Math.min(LONGEST_M, LONG_PER_VEHICLE * length_m);
  const turn = turned(pose);
  const from = of_shape(mount.at).applyEuler(turn).add(at_place(pose));
  const thrown = of_shape(mount.axis)
    .applyEuler(turn)
    .multiplyScalar(-share * most_m);
  return { from, to: from.clone().add(thrown) };
}

export class Jets {
  private readonly paint = new MeshBasicMaterial({
    transparent: true,
    opacity: 0.55,
    depthWrite: false,
  });
  private readonly jets: Instances;
  private readonly rings: Instances;

  constructor(scene: Scene) {
    const cone = new ConeGeometry(0.12, 1, 10, 1, true);
    cone.translate(0, -0.5, 0); // its tip at the mount, its wide end along -y
    this.jets = new Instances(scene, cone, this.paint);
    const ring = new CylinderGeometry(1, 1, 0.7, 14, 1, true);
    this.rings = new Instances(scene, ring, new MeshLambertMaterial({ color: '#3c444c', side: 2 }));
  }

  begin(): void {
    this.jets.begin();
    this.rings.begin();
  }

  add(vehicle: Vehicle, pose: Pose, shares: readonly number[]): void {
    const size_m = Math.max(0.3, vehicle.length_m);
    const turn = new Quaternion().setFromEuler(turned(pose));
    const up = new Vector3(0, 1, 0);
    vehicle.mounts.forEach((mount, nth) => {
      const { part: ring } = this.rings;
      ring.position.copy(of_shape(mount.at).applyQuaternion(turn)).add(at_place(pose));
      ring.quaternion.setFromUnitVectors(up, of_shape(mount.axis).applyQuaternion(turn));
      ring.scale.setScalar(Math.min(0.3, RING_PER_VEHICLE * size_m));
      this.rings.add();
      const jet = jet_of(mount, shares[nth] ?? 0, pose, size_m);
      if (jet === null) return;
      const way = jet.to.clone().sub(jet.from);
      const { part } = this.jets;
      part.position.copy(jet.from);
      part.scale.set(size_m, way.length(), size_m);
      part.quaternion.setFromUnitVectors(new Vector3(0, -1, 0), way.normalize());
      this.jets.add();
    });
  }

  end(colour: string): void {
    this.paint.color.set(colour);
    this.jets.end();
    this.rings.end();
  }
}
