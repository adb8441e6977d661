// Where the sun stands, as the twin has it: Meeus, Astronomical Algorithms (2nd ed.), chapters 12,
// 13, 22 and 25, the low accuracy; 0.01 degrees from 1990 to 2050, without refraction.
const DEGREE = Math.PI / 180;
const sin = (degrees: number): number => Math.sin(degrees * DEGREE);
const cos = (degrees: number): number => Math.cos(degrees * DEGREE);

const J2000_UTC_MS = Date.UTC(2000, 0, 1, 12);
const DAY_MS = 86_400_000;

export interface Sun {
  elevation_deg: number; // above the horizon
  azimuth_deg: number; // clockwise from north
}

export function sun_position(lat_deg: number, lon_deg: number, utc_ms: number): Sun {
  const days = (utc_ms - J2000_UTC_MS) / DAY_MS;
  const t = days / 36525;
  const anomaly = 357.52911 + t * (35999.05029 - 0.0001537 * t);
  const centre =
    sin(anomaly) * (1.914602 - t * (0.004817 + 0.000014 * t)) +
    sin(2 * anomaly) * (0.019993 - 0.000101 * t) +
    sin(3 * anomaly) * 0.000289;
  const node = 125.04 - 1934.136 * t; // of the moon's orbit, which the axis nods with
  const mean = 280.46646 + t * (36000.76983 + 0.0003032 * t);
  const longitude = mean + centre - 0.00569 - 0.00478 * sin(node);
  const tilt = 23.4392911 - t * 0.0130042 + 0.00256 * cos(node);
  const ascension_rad = Math.atan2(cos(tilt) * sin(longitude), cos(longitude));
  const declination_rad = Math.asin(sin(tilt) * sin(longitude));
  const sidereal_deg =
    280.46061837 + 360.98564736629 * days + t * t * 0.000387933 - 0.00478 * sin(node) * cos(tilt);
  const hour_rad = ((sidereal_deg % 360) + lon_deg) * DEGREE - ascension_rad;
  const [level, pole] = [Math.cos(declination_rad), Math.sin(declination_rad)];
  const east = -level * Math.sin(hour_rad);
  const north = cos(lat_deg) * pole - sin(lat_deg) * level * Math.cos(hour_rad);
  const up = sin(lat_deg) * pole + cos(lat_deg) * level * Math.cos(hour_rad);
  const azimuth_deg = Math.atan2(east, north) / DEGREE;
  return {
    elevation_deg: Math.atan2(up, Math.hypot(east, north)) / DEGREE,
    azimuth_deg: (azimuth_deg + 360) % 360,
  };
}
