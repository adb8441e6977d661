// A hand model posed by its 25 joints, skin-coloured and lit before a plain wall; and where its 21
// landmarks are in the picture, by the camera that drew it.
import type { Point } from 'page/gesture/hand';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const finger_names = ['thumb', 'index-finger', 'middle-finger', 'ring-finger', 'pinky-finger'];
const bones = (finger: string): string[] =>
  (finger === 'thumb'
    ? ['metacarpal', 'phalanx-proximal', 'phalanx-distal', 'tip']
    : ['metacarpal', 'phalanx-proximal', 'phalanx-intermediate', 'phalanx-distal', 'tip']
  ).map((it) => `${finger}-${it}`);
/** Names of the model's joints in the order of the 21 landmarks. */
export const landmark_joints = [
  'wrist',
  ...bones('thumb'),
  ...finger_names.slice(1).flatMap((finger) => bones(finger).slice(1)),
];

/** Tips of thumb and index that touch are so far apart: half the thickness of each. */
const PADS_M = 0.01;

export interface Pose {
  x_m: number; // where the palm's middle is, right and up in the picture, before the camera
  y_m: number;
  away_m: number;
  roll_deg: number; // about the view, then yaw and pitch
  yaw_deg: number;
  pitch_deg: number;
  curl_deg: number[]; // of each finger, thumb first, at each of its joints
  apart_deg?: number; // index and middle finger, more than at rest
  pinch?: boolean; // thumb's tip on the index's
}

export class DrawnHand {
  readonly canvas = document.createElement('canvas');
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera: THREE.PerspectiveCamera;
  private readonly joints = new Map<string, THREE.Object3D>();
  private readonly bind = new Map<string, THREE.Matrix4>();
  private readonly hand = new THREE.Group();

  constructor(
    readonly width: number,
    readonly height: number,
  ) {
    this.renderer = new THREE.WebGLRenderer({
      canvas: this.canvas,
      antialias: true,
      preserveDrawingBuffer: true,
    });
    this.renderer.setSize(width, height, false);
    this.camera = new THREE.PerspectiveCamera(45, width / height, 0.05, 10);
    this.scene.background = new THREE.Color(0x9aa7ad);
    this.scene.add(this.hand);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a7a70, 1.6));
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(-0.6, 1.0, 1.2);
    this.scene.add(sun);
  }

  /** The model of a right hand. */
  async load(glb: ArrayBuffer): Promise<void> {
    const gltf = await new GLTFLoader().parseAsync(glb, '');
    this.hand.add(gltf.scene);
    gltf.scene.updateMatrixWorld(true);
    gltf.scene.traverse((it) => {
      if (it instanceof THREE.SkinnedMesh) {
        it.material = new THREE.MeshStandardMaterial({ color: 0xd9a07e, roughness: 0.75 });
        it.frustumCulled = false;
      }
      this.joints.set(it.name, it);
    });
    for (const name of ['wrist', ...finger_names.flatMap(bones)]) {
      const joint = this.joints.get(name);
      if (!joint) throw new Error(`no joint ${name}`);
      joint.updateMatrix();
      this.bind.set(name, joint.matrix.clone());
    }
    // A forearm, for the wrist is where the model ends.
    const wrist = new THREE.Vector3().setFromMatrixPosition(this.bind.get('wrist')!);
    const arm = new THREE.Mesh(
      new THREE.CapsuleGeometry(0.027, 0.25, 8, 24),
      new THREE.MeshStandardMaterial({ color: 0xd9a07e, roughness: 0.75 }),
    );
    arm.position.set(wrist.x, wrist.y + 0.125, wrist.z);
    gltf.scene.add(arm);
  }

  /** Chains below the metacarpals are bent about their own x axis; -z is along the bone. */
  private chain(finger: string, bend: THREE.Quaternion[]): void {
    const names = bones(finger);
    let now = this.bind.get(names[0]!)!.clone();
    names.forEach((name, at) => {
      if (at > 0) {
        const rest = this.bind
          .get(names[at - 1]!)!
          .clone()
          .invert()
          .multiply(this.bind.get(name)!);
        now.multiply(rest);
      }
      now.multiply(new THREE.Matrix4().makeRotationFromQuaternion(bend[at]!));
      now.decompose(
        this.joints.get(name)!.position,
        this.joints.get(name)!.quaternion,
        new THREE.Vector3(),
      );
    });
  }

  /** Draws it. Null: the wall alone. */
  draw(pose: Pose | null): Point[] {
    this.hand.visible = pose !== null;
    if (pose === null) {
      this.renderer.render(this.scene, this.camera);
      return [];
    }
    const x = new THREE.Vector3(1, 0, 0);
    const flex = (deg: number) =>
      new THREE.Quaternion().setFromAxisAngle(x, (-deg * Math.PI) / 180);
    const bends = finger_names.map((finger, f) => {
      const count = bones(finger).length;
      const is_bent = (at: number): boolean => at < count - 1 && (at > 0 || f === 0);
      return Array.from({ length: count }, (_, at) => flex(is_bent(at) ? pose.curl_deg[f]! : 0));
    });
    // At the knuckle, about what is up on the back of the hand.
    for (const [f, side] of [
      [1, 1],
      [2, -1],
    ] as const) {
      const half = ((side * (pose.apart_deg ?? 0)) / 2) * (Math.PI / 180);
      const turn = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 1, 0), half);
      bends[f]![1]!.premultiply(turn);
    }
    finger_names.forEach((finger, f) => this.chain(finger, bends[f]!));
    if (pose.pinch) this.pinch(bends[1]!);
    // Palm to the camera, fingers up: the model's -y is up, its palm faces -x.
    const face = new THREE.Matrix4()
      .makeBasis(
        new THREE.Vector3(0, 0, -1),
        new THREE.Vector3(0, -1, 0),
        new THREE.Vector3(-1, 0, 0),
      )
      .transpose();
    const d = Math.PI / 180;
    const turn = new THREE.Matrix4().makeRotationFromEuler(
      new THREE.Euler(pose.pitch_deg * d, pose.yaw_deg * d, pose.roll_deg * d, 'ZYX'),
    );
    const middle = new THREE.Vector3().setFromMatrixPosition(
      this.bind.get('middle-finger-phalanx-proximal')!,
    );
    const all = new THREE.Matrix4()
      .makeTranslation(pose.x_m, pose.y_m, -pose.away_m)
      .multiply(turn)
      .multiply(face)
      .multiply(new THREE.Matrix4().makeTranslation(-middle.x, -middle.y, -middle.z));
    this.hand.matrixAutoUpdate = false;
    this.hand.matrix.copy(all);
    this.hand.updateMatrixWorld(true);
    this.renderer.render(this.scene, this.camera);
    return landmark_joints.map((name) => {
      const at = new THREE.Vector3().setFromMatrixPosition(this.joints.get(name)!.matrixWorld);
      at.project(this.camera);
      const wide = this.width / this.height;
      return { x: (wide * (at.x + 1)) / 2, y: (1 - at.y) / 2 };
    });
  }

  /**
   * Thumb and index towards each other, until their tips are as far apart as two pads are thick:
   * cyclic coordinate descent of the joints of both.
   */
  private pinch(index_bend: THREE.Quaternion[]): void {
    const bends = {
      thumb: bones('thumb').map(() => new THREE.Quaternion()),
      'index-finger': index_bend,
    };
    const tip_of = (finger: string) => this.joints.get(`${finger}-tip`)!;
    for (let round = 0; round < 60; round += 1)
      for (const [finger, other, joints, share] of [
        ['thumb', 'index-finger', [2, 1, 0], 0.2],
        ['index-finger', 'thumb', [3, 2, 1], 0.05],
      ] as const)
        for (const at of joints) {
          const target = tip_of(other).position;
          if (target.distanceTo(tip_of(finger).position) < PADS_M) return;
          const joint = this.joints.get(bones(finger)[at]!)!;
          const to_local = joint.quaternion.clone().invert();
          const towards = (point: THREE.Vector3): THREE.Vector3 =>
            point.clone().sub(joint.position).applyQuaternion(to_local).normalize();
          const whole = new THREE.Quaternion().setFromUnitVectors(
            towards(tip_of(finger).position),
            towards(target),
          );
          bends[finger][at]!.multiply(new THREE.Quaternion().slerp(whole, share));
          this.chain(finger, bends[finger]);
        }
  }
}
