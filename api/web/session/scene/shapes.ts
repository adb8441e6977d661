// What stands, floats and swims, made of a few plain bodies. Kinds are told apart by their shape.
import {
  BoxGeometry,
  CapsuleGeometry,
  ConeGeometry,
  ExtrudeGeometry,
  Group,
  Mesh,
  MeshLambertMaterial,
  Shape,
  TorusGeometry,
} from 'three';
import type { Vessel } from '../session/around';
import type { Vehicle } from '../session/message';
import { give_names } from './met';

const HULL = new MeshLambertMaterial({ color: '#e2b33c' });
const DARK = new MeshLambertMaterial({ color: '#2b3138' });
const STEEL = new MeshLambertMaterial({ color: '#8d979f' });
const SHIP = new MeshLambertMaterial({ color: '#7c4136' });

/** All that its shape is made by: another session may have another vehicle of its number. */
export function vehicle_key(of: Vehicle): string {
  return `vehicle ${of.vehicle} ${of.kind} ${of.model} ${of.length_m} ${of.width_m} ${of.name}`;
}

/** The bow along -z, as long and wide as the vehicle says. */
export function vehicle_shape(vehicle: Vehicle): Group {
  const made = new Group();
  const long = Math.max(0.3, vehicle.length_m);
  const wide = Math.max(0.25, Math.min(long, vehicle.width_m));
  if (vehicle.kind.includes('uav')) {
    made.add(new Mesh(new BoxGeometry(0.3 * wide, 0.12 * wide, 0.4 * long), DARK));
    for (const [x, z] of [[1, 1], [1, -1], [-1, 1], [-1, -1]] as const) {
      const rotor = new Mesh(new TorusGeometry(0.16 * wide, 0.012 * wide, 6, 20), DARK);
      rotor.rotation.x = Math.PI / 2;
      rotor.position.set(x * 0.33 * wide, 0.08 * wide, z * 0.33 * long);
      made.add(rotor);
    }
  } else if (vehicle.kind.includes('auv')) {
    const hull = new Mesh(new CapsuleGeometry(0.09 * long, 0.8 * long, 6, 14), HULL);
    hull.rotation.x = Math.PI / 2;
    const fins = new Mesh(new BoxGeometry(0.3 * long, 0.015 * long, 0.08 * long), DARK);
    fins.position.z = 0.42 * long;
    const rudder = fins.clone();
    rudder.rotation.z = Math.PI / 2;
    made.add(hull, fins, rudder);
  } else if (vehicle.kind.includes('rov')) {
    const float = new Mesh(new BoxGeometry(0.7 * wide, 0.18 * long, 0.9 * long), HULL);
    float.position.y = 0.14 * long;
    const frame = new Mesh(new BoxGeometry(0.75 * wide, 0.2 * long, 0.85 * long), DARK);
    frame.position.y = -0.05 * long;
    const dome = new Mesh(new ConeGeometry(0.09 * long, 0.1 * long, 12), STEEL);
    dome.rotation.x = -Math.PI / 2;
    dome.position.z = -0.47 * long;
    made.add(float, frame, dome);
  } else {
    made.add(hull_of(long, Math.min(wide, 0.5 * long), HULL));
  }
  made.name = vehicle.name;
  give_names(made, [vehicle.name]);
  return made;
}

/** Pointed ahead, square aft, half of it in the water. */
function hull_of(long: number, wide: number, material: MeshLambertMaterial): Group {
  const made = new Group();
  const deck = new Shape();
  deck.moveTo(-wide / 2, -long / 2);
  deck.lineTo(wide / 2, -long / 2);
  deck.lineTo(wide / 2, 0.2 * long);
  deck.quadraticCurveTo(0.4 * wide, 0.4 * long, 0, long / 2);
  deck.quadraticCurveTo(-0.4 * wide, 0.4 * long, -wide / 2, 0.2 * long);
  const high = 0.35 * wide;
  const body = new ExtrudeGeometry(deck, { depth: high, bevelEnabled: false, curveSegments: 8 });
  body.rotateX(-Math.PI / 2);
  body.translate(0, -high / 2, 0);
  const house = new Mesh(new BoxGeometry(0.55 * wide, 0.4 * wide, 0.2 * long), STEEL);
  house.position.set(0, high / 2 + 0.2 * wide, 0.12 * long);
  made.add(new Mesh(body, material), house);
  return made;
}

const UNKNOWN_LENGTH_M = 30;

export function vessel_size({ length_m }: Vessel): { long_m: number; wide_m: number } {
  const long_m = length_m ?? UNKNOWN_LENGTH_M;
  return { long_m, wide_m: long_m / 6 };
}

export function vessel_key({ mmsi, length_m, name }: Vessel): string {
  return `vessel ${mmsi} ${length_m} ${name}`;
}

export function vessel_shape(vessel: Vessel): Group {
  const { long_m, wide_m } = vessel_size(vessel);
  const made = hull_of(long_m, wide_m, SHIP);
  made.name = vessel.name;
  give_names(made, [vessel.name]);
  return made;
}
