// Above the map: the depth of its current, and the place by name for those who do not click.
import type { Desk } from '../look/desk';
import { element, labelled } from '../../look/element';
import type { SiteMap } from '../server/answers';
import type { Place } from '../view';

interface Tool {
  node: HTMLElement;
  show: (site: SiteMap | null) => void;
}

export function depth_choice({ view }: Desk): Tool {
  const select = element('select');
  select.addEventListener('change', () => view.set({ depth_m: Number(select.value) }));
  const show = (site: SiteMap | null): void => {
    const levels = [...(site?.levels_m ?? [])];
    // A link may name a depth between the levels: it is shown as the nearest, and listed as it is.
    if (!levels.includes(view.values.depth_m)) levels.push(view.values.depth_m);
    levels.sort((a, b) => a - b);
    select.replaceChildren(
      ...levels.map((level) => element('option', { value: level }, `${level} m`)),
    );
    select.value = String(view.values.depth_m);
  };
  show(null);
  return { node: labelled('Current at depth', select), show };
}

export function place_choice({ view }: Desk): Tool {
  const select = element('select');
  let places: Place[] = [];
  select.addEventListener('change', () => {
    const place = places[Number(select.value)];
    if (place === undefined) return;
    const { longitude_deg, latitude_deg } = place;
    view.set({ place: { longitude_deg, latitude_deg }, panel: 'place' });
  });
  const show = (site: SiteMap | null): void => {
    const columns = site?.columns ?? [];
    const turbines = site?.turbines ?? [];
    places = [...columns, ...turbines];
    const names = [
      ...columns.map(({ location }) => `Column ${location}`),
      ...turbines.map(({ id }) => `Turbine ${id}`),
    ];
    const chosen = places.findIndex((place) => is_same(place, view.values.place ?? site?.place));
    select.replaceChildren(
      ...(chosen < 0 ? [element('option', { value: -1 }, 'Chosen on the map')] : []),
      ...names.map((name, i) => element('option', { value: i }, name)),
    );
    select.value = String(chosen);
  };
  show(null);
  return { node: labelled('Place', select), show };
}

function is_same(a: Place, b: Place | null | undefined): boolean {
  const near = (left: number, right: number): boolean => Math.abs(left - right) < 2e-5;
  return (
    b !== undefined &&
    b !== null &&
    near(a.longitude_deg, b.longitude_deg) &&
    near(a.latitude_deg, b.latitude_deg)
  );
}
