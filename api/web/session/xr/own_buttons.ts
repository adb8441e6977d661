// What the board offers beside HOLD and the helm: the way, the next vehicle, a ride, the table, how
// one sits, the way out.
import type { Pose } from '../session/frame';
import type { Station } from '../station';
import type { WaypointEdit } from '../panel/waypoint_edit';
import type { BoardButton } from './board_words';
import type { Mode } from './modes';

/** How the stay is now, and what a press makes of it. */
export interface OwnDeeds {
  mode: Mode;
  is_table: boolean;
  rides: boolean;
  is_seated: boolean;
  finds_floor: boolean; // where one looks
  ride: (pose: Pose) => void;
  end_ride: () => void;
  stand: () => void;
  lay_table: () => void;
  lay_table_there: () => void;
  sit: (is_seated: boolean) => void;
  choose: (vehicle: number) => void;
  leave: () => void;
}

export function own_buttons(station: Station, way: WaypointEdit, own: OwnDeeds): BoardButton[] {
  const buttons: BoardButton[] = [];
  const add = (text: string, press: () => void): void => void buttons.push({ text, press });
  if (way.may_send()) add('Send the way', () => way.send());
  if (way.draft() !== null) add('Drop the changes', () => way.end());
  else if (station.may_direct()) add('Edit the way', () => way.begin());
  const vehicles = [...station.session.vehicles.keys()];
  const next = vehicles[(vehicles.indexOf(station.chosen ?? -1) + 1) % vehicles.length];
  if (vehicles.length > 1 && next !== undefined) add('Next vehicle', () => own.choose(next));
  const pose = station.session.poses.get(station.chosen ?? -1);
  if (own.rides) add('Stop riding', own.end_ride);
  else if (!own.is_table && pose !== undefined) add('Ride along', () => own.ride(pose));
  if (own.mode === 'vr') {
    if (own.is_table) add('Back to VR', own.stand);
    else add('Table', own.lay_table);
    add(`Sitting: ${own.is_seated ? 'yes' : 'no'}`, () => own.sit(!own.is_seated));
  } else if (own.finds_floor) add('Put the table there', own.lay_table_there);
  add('Leave', own.leave);
  return buttons;
}
