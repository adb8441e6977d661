// What one may ask about the helm of the chosen vehicle now. Panels and the headset's board offer
// the same.
import type { Station } from '../station';

export type HelmDeed = 'ask' | 'grant' | 'deny' | 'give_back' | 'allow';

export const DEED_TEXT: Readonly<Record<HelmDeed, string>> = {
  ask: 'Ask for the helm',
  grant: 'Grant',
  deny: 'Deny',
  give_back: 'Give back',
  allow: 'Let anyone take it',
};

export function helm_deeds(station: Station): Set<HelmDeed> {
  const { session, chosen } = station;
  const deeds = new Set<HelmDeed>();
  if (session.role === 'spectator' || chosen === null) return deeds;
  const state = session.helms.get(chosen)?.state;
  if (!station.has_helm()) return deeds.add('ask');
  deeds.add('give_back');
  if (state === 'requested') deeds.add('grant').add('deny');
  if (state === 'held') deeds.add('allow');
  return deeds;
}

/** One has asked already, and waits. */
export function has_asked({ session, chosen }: Station): boolean {
  const asker = chosen === null ? null : (session.helms.get(chosen)?.asker ?? null);
  return asker !== null && asker === session.seat;
}

export function do_deed(station: Station, deed: HelmDeed): void {
  station.ask(DEED_TEXT[deed], { do: deed, vehicle: station.chosen });
}
