// Axes of a body in north, east, down: the rotation of Fossen, Handbook of Marine Craft
// Hydrodynamics and Motion Control (2011), equation (2.18), written out.

/** North, east, down; or forward, right, down. */
export type Triple = readonly [number, number, number];

export function body_to_ned(roll: number, pitch: number, yaw: number, of: Triple): Triple {
  const [x, y, z] = of;
  const [cphi, sphi] = [Math.cos(roll), Math.sin(roll)];
  const [cth, sth] = [Math.cos(pitch), Math.sin(pitch)];
  const [cpsi, spsi] = [Math.cos(yaw), Math.sin(yaw)];
  return [
    cpsi * cth * x + (-spsi * cphi + cpsi * sth * sphi) * y + (spsi * sphi + cpsi * cphi * sth) * z,
    spsi * cth * x + (cpsi * cphi + sphi * sth * spsi) * y + (-cpsi * sphi + sth * spsi * cphi) * z,
    -sth * x + cth * sphi * y + cth * cphi * z,
  ];
}
