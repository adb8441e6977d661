// What of the scene is shown or not, as one likes; offered where there is something to show.
import type { Session } from '../session/state';
import { wind_of } from './wind_view';

export interface Layers {
  laid: boolean;
  inspected: boolean;
  wind: boolean;
  picture: boolean;
}

export const ALL_LAYERS: Readonly<Layers> = {
  laid: true,
  inspected: true,
  wind: true,
  picture: true,
};

export const LAYER_WORDS: readonly (readonly [keyof Layers, string])[] = [
  ['laid', 'Cables'],
  ['inspected', 'Coverage'],
  ['wind', 'Wind'],
  ['picture', 'Picture'],
];

/** There is something to show. */
export function has_layer(layer: keyof Layers, session: Session, chosen: number | null): boolean {
  switch (layer) {
    case 'laid':
      return session.cables.length > 0 || session.moorings.length > 0;
    case 'inspected':
      return (
        session.surfaces.size > 0 || [...session.findings.values()].some((it) => it.length > 0)
      );
    case 'wind':
      return wind_of(session) !== null;
    case 'picture':
      return [...session.pictures.values()].some((it) => it.vehicle === chosen);
  }
}
