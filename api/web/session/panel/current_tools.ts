// Hands on the current in the scene: whether a slice of it is shown, and how deep.
import { button, element, set_hidden, set_text } from '../../look/element';
import { current_at, type Current } from '../session/currents';

export interface CurrentTools {
  nodes: HTMLElement[];
  show(currents: readonly Current[]): void;
}

export function current_tools(on_change: (up_m: number | null) => void): CurrentTools {
  let is_on = false;
  const value = element('output', {});
  const depth = element('input', {
    type: 'range',
    min: 0,
    max: 40,
    step: 0.5,
    value: 5,
    'aria-label': 'How deep the slice of the current is, in metres',
    hidden: true,
  });
  const changed = (): void => on_change(is_on ? -depth.valueAsNumber : null);
  depth.addEventListener('input', changed);
  const toggle = button(
    'Current',
    () => {
      is_on = !is_on;
      toggle.setAttribute('aria-pressed', String(is_on));
      changed();
    },
    { 'aria-pressed': 'false' },
  );
  return {
    nodes: [toggle, depth, value],
    show: (currents) => {
      set_hidden(toggle, currents.length < 2);
      set_hidden(depth, !is_on || currents.length < 2);
      const deepest_m = Math.floor(-(currents.at(-1)?.up_m ?? -40));
      if (depth.max !== String(deepest_m)) depth.max = String(deepest_m);
      const at = current_at(currents, -depth.valueAsNumber);
      const speed = at === null ? '' : `: ${Math.hypot(at.east_m_s, at.north_m_s).toFixed(2)} m/s`;
      set_text(value, is_on ? `${depth.valueAsNumber} m deep${speed}` : '');
    },
  };
}
