// The map's camera: a Mercator of d3-geo, held as a centre and a zoom (each step doubles).
import { geoMercator, type GeoProjection } from 'd3-geo';
import type { Place } from '../view';

export type Camera = Place & { zoom: number };
export interface Size {
  width: number;
  height: number;
}

const WORLD_PX = 256; // the world's width at zoom 0
const EARTH_RADIUS_M = 6_371_008.8;
export const LEAST_ZOOM = 3;
export const MOST_ZOOM = 18;

export function projection_of(camera: Camera, { width, height }: Size): GeoProjection {
  return geoMercator()
    .scale((WORLD_PX * 2 ** camera.zoom) / (2 * Math.PI))
    .center([camera.longitude_deg, camera.latitude_deg])
    .translate([width / 2, height / 2])
    .clipExtent([
      [-8, -8],
      [width + 8, height + 8],
    ]);
}

export function place_at(camera: Camera, size: Size, x: number, y: number): Place {
  const [longitude_deg, latitude_deg] = projection_of(camera, size).invert?.([x, y]) ?? [0, 0];
  return { longitude_deg, latitude_deg };
}

export function moved(camera: Camera, size: Size, right_px: number, down_px: number): Camera {
  return {
    ...place_at(camera, size, size.width / 2 + right_px, size.height / 2 + down_px),
    zoom: camera.zoom,
  };
}

/** Zoomed so that what lies at (x, y) stays there. */
export function zoomed(camera: Camera, size: Size, by: number, x: number, y: number): Camera {
  const zoom = Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, camera.zoom + by));
  const shrink = 1 - 2 ** (camera.zoom - zoom);
  return {
    ...moved(camera, size, (x - size.width / 2) * shrink, (y - size.height / 2) * shrink),
    zoom,
  };
}

/** Shows all places, with room around; never less than `least_m` from side to side. */
export function fit(places: Place[], size: Size, least_m = 1500): Camera {
  const longitudes = places.map(({ longitude_deg }) => longitude_deg);
  const latitudes = places.map(({ latitude_deg }) => latitude_deg);
  const west = Math.min(...longitudes);
  const east = Math.max(...longitudes);
  const south = Math.min(...latitudes);
  const north = Math.max(...latitudes);
  const centre = { longitude_deg: (west + east) / 2, latitude_deg: (south + north) / 2 };
  const cosine = Math.cos((centre.latitude_deg * Math.PI) / 180);
  const least_deg = ((least_m / EARTH_RADIUS_M) * 180) / Math.PI / cosine;
  const wide_deg = Math.max(east - west, least_deg);
  const high_deg = Math.max((north - south) / cosine, least_deg / 3);
  const room = 0.7; // of the map's width and height
  const px_per_deg = Math.min((room * size.width) / wide_deg, (room * size.height) / high_deg);
  const zoom = Math.log2((px_per_deg * 360) / WORLD_PX);
  return { ...centre, zoom: Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, zoom)) };
}

export function metres_per_px({ latitude_deg, zoom }: Camera): number {
  const around_m = 2 * Math.PI * EARTH_RADIUS_M * Math.cos((latitude_deg * Math.PI) / 180);
  return around_m / (WORLD_PX * 2 ** zoom);
}

/** A round length that takes at most so many pixels. */
export function scale_bar(camera: Camera, most_px: number): { px: number; text: string } {
  const most_m = metres_per_px(camera) * most_px;
  const power = 10 ** Math.floor(Math.log10(most_m));
  const length_m = [5, 2, 1].map((n) => n * power).find((m) => m <= most_m) ?? power;
  const text = length_m >= 1000 ? `${length_m / 1000} km` : `${length_m} m`;
  return { px: length_m / metres_per_px(camera), text };
}
