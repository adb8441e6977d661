// The coast, Natural Earth 1:50 million: fetched once, when the site stands; a map without it still
// shows the site.
import { geoPath, type GeoProjection } from 'd3-geo';
import { feature } from 'topojson-client';
import type { GeometryCollection, Topology } from 'topojson-specification';
import type { Server } from '../server/server';

interface Land {
  polygon: GeoJSON.Polygon;
  west: number;
  south: number;
  east: number;
  north: number;
}

let land: Land[] | null = null;

export async function fetch_coast(server: Server): Promise<void> {
  if (land !== null) return;
  const topology = await server.get<Topology>('/desk/land-50m.json');
  const object = topology.objects.land as GeometryCollection | undefined;
  if (object === undefined) return;
  land = feature(topology, object).features.flatMap(({ geometry }) =>
    geometry.type === 'MultiPolygon' ? geometry.coordinates.map(land_of) : [],
  );
}

/** The box in degrees will do: Natural Earth cuts its land at the date line. */
function land_of(coordinates: GeoJSON.Position[][]): Land {
  const box = { west: 180, south: 90, east: -180, north: -90 };
  for (const [x = 0, y = 0] of coordinates[0] ?? []) {
    box.west = Math.min(box.west, x);
    box.east = Math.max(box.east, x);
    box.south = Math.min(box.south, y);
    box.north = Math.max(box.north, y);
  }
  return { polygon: { type: 'Polygon', coordinates }, ...box };
}

/** The path of the land that can be seen from west to east; empty before it came. */
export function coast_path(
  projection: GeoProjection,
  view: { west: number; south: number; east: number; north: number },
): string {
  if (land === null) return '';
  const path = geoPath(projection).digits(1);
  return land
    .filter(
      ({ west, south, east, north }) =>
        west <= view.east && east >= view.west && south <= view.north && north >= view.south,
    )
    .map(({ polygon }) => path(polygon) ?? '')
    .join('');
}
