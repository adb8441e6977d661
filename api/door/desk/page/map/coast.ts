// The coast, Natural Earth 1:50 million: fetched once, when the map first asks; a map without it
// still shows the site.
import { geoBounds, geoPath } from 'd3-geo';
import type { GeoProjection } from 'd3-geo';
import { feature } from 'topojson-client';
import type { GeometryCollection, Topology } from 'topojson-specification';
import type { Server } from '../server/server';

interface Land {
  polygon: GeoJSON.Polygon;
  bounds: [[number, number], [number, number]];
}

let land: Land[] | null = null;

export async function fetch_coast(server: Server): Promise<void> {
  const topology = await server.get<Topology>('/desk/land-50m.json');
  const object = topology.objects.land as GeometryCollection | undefined;
  if (object === undefined) return;
  const { features } = feature(topology, object);
  land = features.flatMap(({ geometry }) => {
    const polygons = geometry.type === 'MultiPolygon' ? geometry.coordinates : [];
    return polygons.map((coordinates) => {
      const polygon: GeoJSON.Polygon = { type: 'Polygon', coordinates };
      return { polygon, bounds: geoBounds(polygon) };
    });
  });
}

/** The path of the land that can be seen from west to east; empty before it came. */
export function coast_path(
  projection: GeoProjection,
  west: number,
  south: number,
  east: number,
  north: number,
): string {
  if (land === null) return '';
  const path = geoPath(projection).digits(1);
  const is_near = ({ bounds: [[w, s], [e, n]] }: Land): boolean =>
    s <= north && n >= south && (w > e ? w <= east || e >= west : w <= east && e >= west);
  return land
    .filter(is_near)
    .map(({ polygon }) => path(polygon) ?? '')
    .join('');
}
