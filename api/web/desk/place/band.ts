// A band from p10 to p90 as one shape of a custom series.
import type { Option } from '../look/chart';

interface Means {
  coord(point: [number, number]): [number, number];
}

/** `edges`: the corners around the band, in the values of the axes. */
export function band(edges: [number, number][], fill: string, stroke: string): Option {
  return {
    type: 'custom',
    silent: true,
    data: [0],
    clip: true,
    z: 1,
    renderItem: (_: unknown, means: Means) => ({
      type: 'polygon',
      shape: { points: edges.map((point) => means.coord(point)) },
      style: { fill, stroke, lineWidth: stroke === 'none' ? 0 : 1, lineDash: [3, 3] },
    }),
  };
}
