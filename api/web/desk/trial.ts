// What a person tries out on the map: turbines elsewhere, zones that are not there. It is drawn
// beside what is true, stands in no address, and goes with the page.
import type { Place } from './position';

export interface Trial {
  turbines: { id: string; place: Place; is_new: boolean }[];
  zones: { id: string; ring: [number, number][] }[];
}
export const NO_TRIAL: Trial = { turbines: [], zones: [] };

const CORNERS = 24;
const M_OF_DEGREE = 111_195; // of latitude, on a sphere of 6371 km

/** Corners of a circle, longitude first, to five digits: about a metre. */
export function ring_around(place: Place, radius_m: number): [number, number][] {
  const north_deg = radius_m / M_OF_DEGREE;
  const east_deg = north_deg / Math.cos((place.latitude_deg * Math.PI) / 180);
  return Array.from({ length: CORNERS }, (_, i) => {
    const turn = (2 * Math.PI * i) / CORNERS;
    return [
      rounded(place.longitude_deg + east_deg * Math.sin(turn)),
      rounded(place.latitude_deg + north_deg * Math.cos(turn)),
    ];
  });
}

export const rounded = (degrees: number): number => Math.round(degrees * 1e5) / 1e5;
