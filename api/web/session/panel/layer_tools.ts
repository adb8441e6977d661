// Hands on what of the scene is shown; each button is there where there is something to show.
import { button, set_hidden } from '../../look/element';
import { ALL_LAYERS, LAYER_WORDS, has_layer, type Layers } from '../scene/layers';
import type { Session } from '../session/state';

export interface LayerTools {
  nodes: HTMLElement[];
  readonly layers: Layers;
  show(session: Session, chosen: number | null): void;
}

export function layer_tools(on_change: () => void): LayerTools {
  const layers: Layers = { ...ALL_LAYERS };
  const toggles = LAYER_WORDS.map(([layer, words]) => {
    const toggle = button(
      words,
      () => {
        layers[layer] = !layers[layer];
        toggle.setAttribute('aria-pressed', String(layers[layer]));
        on_change();
      },
      { 'aria-pressed': String(layers[layer]) },
    );
    return { layer, toggle };
  });
  return {
    nodes: toggles.map((it) => it.toggle),
    layers,
    show: (session, chosen) => {
      for (const { layer, toggle } of toggles)
        set_hidden(toggle, !has_layer(layer, session, chosen));
    },
  };
}
