// One stay in the scene with a headset, frame by frame: what the hands do, where that brings one,
// what is drawn.
import { Vector3 } from 'three';
import type { OrdersBar } from '../panel/orders_bar';
import type { ScenePeople } from '../panel/scene_people';
import type { WaypointEdit } from '../panel/waypoint_edit';
import { keep_settings } from '../look/settings';
import { at_place } from '../scene/axes';
import type { SceneView, Shown } from '../scene/scene_view';
import { colours } from '../look/palette';
import type { Station } from '../station';
import { board_lines, helm_buttons, may_hold, type BoardButton } from './board_words';
import { Flight, narrowed, out_of_bed_m, SEATED_LIFT_M, SnapTurn } from './comfort';
import type { HelmHand } from './helm_hand';
import type { Mode } from './modes';
import { INDEX_TIP } from './joints';
import { Presses } from './presses';
import { HandReader, SIDES, turn_of, type HandReading, type Side } from './reading';
import { TableHand } from './table';
import { FloorAhead } from './floor_ahead';
import { landing_of } from './teleport';
import { Wearer } from './wearer';

const BOARD_EVERY_MS = 200;
const TABLE_FLIGHT = 0.1; // of the flight's speed, as the hand sees it

/** What the page lends it. */
export interface Lent {
  station: Station;
  way: WaypointEdit;
  orders: OrdersBar;
  people: Pick<ScenePeople, 'point_at'>;
  shown: () => Shown;
  /** Draws a frame of the scene, and tells the server so. */
  draw: () => void;
  choose: (vehicle: number) => void;
  /** It begins, ends, or has other hands. */
  on_change: () => void;
}

export class Stay {
  readonly wearer: Wearer;
  private readonly reader = new HandReader();
  private readonly table: TableHand;
  private readonly snap = new SnapTurn();
  private readonly flight = new Flight();
  private readonly floor = new FloorAhead();
  private hands: HandReading[] = [];
  private readonly presses = new Presses();
  private readonly busy = new Set<Side>(); // with the board
  private was_hold = false;
  private throwing: Side | null = null;
  private rides: { vehicle: number; at: Vector3 } | null = null;
  private narrow = 0;
  private before_ms: number | null = null;
  private board_ms = -Infinity;
  private told = '';

  constructor(
    readonly mode: Mode,
    readonly session: XRSession,
    private readonly view: SceneView,
    private readonly helm: HelmHand,
    private readonly lent: Lent,
    private readonly leave: () => void,
  ) {
    this.wearer = new Wearer(view);
    const { way, choose } = lent;
    this.table = new TableHand(this.wearer.rig, {
      places: () => way.draft()?.places ?? null,
      pick: (nth) => way.pick(nth),
      move: (to) => way.move(to),
      lift: (up_m) => way.lift(up_m),
      let_go: () => way.let_go(),
      vehicles: () => [...lent.station.session.poses.values()],
      choose,
    });
  }

  /** Hands that are drawn, in words. */
  hands_text(): string {
    const parts = SIDES.flatMap((side) => {
      const { controller_is_drawn, joints_drawn } = this.wearer.hands[side];
      if (controller_is_drawn) return [`${side} controller`];
      return joints_drawn > 0 ? [`${side} hand (${joints_drawn} joints)`] : [];
    });
    return parts.length === 0 ? 'no hands seen' : parts.join(', ');
  }

  let_go(): void {
    this.helm.lose();
    this.presses.lose_all();
    this.table.lose();
    for (const side of SIDES) this.wearer.board.lose(side);
    this.throwing = null;
    this.wearer.throw_mark.hide();
    this.lent.people.point_at(null);
  }

  frame(now_ms: number, frame: XRFrame): void {
    const space = this.view.renderer.xr.getReferenceSpace();
    const pose = space === null ? undefined : frame.getViewerPose(space);
    const is_seen = this.session.visibilityState === 'visible';
    if (space === null || pose === undefined || pose === null || !is_seen) this.let_go();
    if (space === null || pose === undefined || pose === null) return;
    const { rig } = this.wearer;
    const { position, orientation } = pose.transform;
    rig.take_head({
      at: new Vector3(position.x, position.y, position.z),
      turned: rig.head.quaternion
        .clone()
        .set(orientation.x, orientation.y, orientation.z, orientation.w),
    });
    const step_s = this.before_ms === null ? 0 : (now_ms - this.before_ms) / 1000;
    if (this.before_ms === null) this.arrive();
    this.before_ms = now_ms;
    this.hands = is_seen ? this.reader.read(frame, space) : [];
    this.floor.look(frame, space);
    this.use_hands(step_s);
    this.show_board(now_ms);
    this.lent.draw();
    const text = this.hands_text();
    if (text !== this.told) {
      this.told = text;
      this.lent.on_change();
    }
  }

  /** Where the desk looks from; in AR the table before the hands. */
  private arrive(): void {
    this.wearer.rig.lift_m = this.mode === 'vr' && this.is_seated ? SEATED_LIFT_M : 0;
    if (this.mode === 'vr') this.stand();
    else {
      this.wearer.lay_table(this.lent.shown());
      void this.floor.begin(this.session);
    }
  }

  private stand(): void {
    const { camera } = this.view.eye;
    const { rig } = this.wearer;
    this.wearer.stand(camera.position, turn_of(camera.quaternion), turn_of(rig.head.quaternion));
  }

  private get is_seated(): boolean {
    return this.lent.station.settings.headset_is_seated;
  }

  private use_hands(step_s: number): void {
    const { hands, helm, wearer } = this;
    const { station, orders } = this.lent;
    this.presses.look(hands);
    this.press_board();
    const is_hold = hands.some((it) => it.is_hold);
    if (is_hold && !this.was_hold && may_hold(station)) orders.hold();
    this.was_hold = is_hold;
    if (wearer.is_table) this.table.take(hands, this.presses, this.busy);
    else this.throw_on();
    const may = (it: HandReading): boolean =>
      !wearer.is_table &&
      !this.busy.has(it.side) &&
      this.throwing !== it.side &&
      (it.kind === 'controller' || station.has_helm());
    helm.take(hands, turn_of(wearer.rig.head.quaternion), may, performance.now());
    const is_moved = this.move(step_s) || this.ride();
    const wants = station.settings.headset_narrows && !wearer.is_table;
    this.narrow = narrowed(this.narrow, wants && is_moved, step_s);
    wearer.vignette.show(this.narrow);
    this.point();
    for (const side of SIDES) {
      const hand = hands.find((it) => it.side === side) ?? null;
      wearer.hands[side].show(hand, helm.held_by === side, helm.held_by !== side);
    }
  }

  /** A press that begins on the board is the board's until it ends. */
  private press_board(): void {
    const { presses, busy, wearer } = this;
    const { rig, board } = wearer;
    for (const side of SIDES) {
      if (!presses.is_held(side)) busy.delete(side);
      const hand = this.hands.find((it) => it.side === side);
      if (hand?.is_tracked !== true) {
        board.lose(side);
        continue;
      }
      const { ray } = hand;
      if (
        presses.begins(side) &&
        ray !== null &&
        board.press(rig.in_scene(ray.at), rig.along(ray.turned))
      )
        busy.add(side);
      const tip = hand.joints?.[INDEX_TIP];
      if (tip !== undefined && !hand.is_pressed && board.touch(side, tip)) busy.add(side);
    }
  }

  /** Pressed shows where one would come to, let go brings one there. */
  private throw_on(): void {
    const { wearer, hands, presses } = this;
    const { station } = this.lent;
    const throws = (it: HandReading): boolean =>
      it.is_tracked &&
      it.ray !== null &&
      this.helm.held_by === null &&
      !this.busy.has(it.side) &&
      (it.kind === 'controller' || !station.has_helm());
    const hand = hands.find((it) => it.side === this.throwing);
    if (this.throwing === null)
      this.throwing = hands.find((it) => presses.begins(it.side) && throws(it))?.side ?? null;
    else if (hand === undefined || !throws(hand)) this.throwing = null;
    const thrower = hands.find((it) => it.side === this.throwing);
    if (thrower?.ray == null) return wearer.throw_mark.hide();
    const from = wearer.rig.in_scene(thrower.ray.at);
    const ahead = wearer.rig.along(thrower.ray.turned);
    const landing = landing_of(from, ahead, {
      structures: station.session.structures,
      bed_under: (at) => this.view.surround.bed_under(at),
      is_water_open: Math.abs(wearer.rig.group.position.y) < 0.5,
    });
    if (thrower.is_pressed) {
      const { accent, alarm } = colours();
      wearer.throw_mark.show(from, ahead, landing, accent, alarm);
      return;
    }
    this.throwing = null;
    wearer.throw_mark.hide();
    if (landing === null) return;
    this.rides = null;
    wearer.rig.stand_at(landing.at);
  }

  /** Flight and turns by thumb-stick. Squeezed, it is the vehicle's, also where that is refused. */
  private move(step_s: number): boolean {
    const there = this.hands.filter((it) => it.kind === 'controller');
    if (this.helm.held_by !== null || there.some((it) => it.is_squeezed)) return false;
    if (there.length === 0) return false;
    const { rig, is_table } = this.wearer;
    const right = there.find((it) => it.side === 'right') ?? there[0]!;
    const left = there.find((it) => it !== right);
    rig.turn(this.snap.step(right.stick.right));
    const move = left?.stick ?? { right: 0, up: right.stick.up };
    const rise = left === undefined ? 0 : right.stick.up;
    const by = this.flight.step(rig.looks_along(), move, rise, step_s);
    if (by.length() === 0) return false;
    rig.move(is_table ? by.multiplyScalar(rig.scale * TABLE_FLIGHT) : by);
    if (!is_table)
      rig.move(
        new Vector3(
          0,
          out_of_bed_m(rig.head_at().y, this.view.surround.bed_under(rig.head_at())),
          0,
        ),
      );
    return true;
  }

  /** Goes along with a vehicle, and does not turn with it. */
  private ride(): boolean {
    const { rides } = this;
    const pose = rides === null ? undefined : this.lent.station.session.poses.get(rides.vehicle);
    if (rides === null || pose === undefined || this.wearer.is_table) return false;
    const at = at_place(pose);
    const by = at.clone().sub(rides.at);
    rides.at = at;
    this.wearer.rig.move(by);
    return by.length() > 0;
  }

  private point(): void {
    const hand = this.hands.find((it) => it.is_pointing && it.is_tracked && it.ray !== null);
    if (hand?.ray == null) return this.lent.people.point_at(null);
    const { rig } = this.wearer;
    const from = rig.in_scene(hand.ray.at);
    this.lent.people.point_at(this.view.place_along(from, rig.along(hand.ray.turned)));
  }

  private show_board(now_ms: number): void {
    const { rig, board } = this.wearer;
    board.follow({ at: rig.head.position, turned: rig.head.quaternion });
    if (now_ms < this.board_ms + BOARD_EVERY_MS) return;
    this.board_ms = now_ms;
    const { station, orders, way } = this.lent;
    const { text, is_alarm } = orders.said();
    const lines = board_lines(station, {
      stick: text,
      stick_is_alarm: is_alarm,
      way: way.words(),
      notice: document.getElementById('notice')?.textContent ?? '',
    });
    board.show(lines, [...helm_buttons(station, () => orders.hold()), ...this.own_buttons()]);
  }

  private own_buttons(): BoardButton[] {
    const { station, way, choose, shown } = this.lent;
    const { wearer, rides } = this;
    const buttons: BoardButton[] = [];
    const add = (text: string, press: () => void): void =>
      void buttons.push({ text, is_strong: false, press });
    if (way.draft() !== null) {
      add('Send the way', () => way.send());
      add('Drop the changes', () => way.end());
    } else if (station.may_direct()) add('Edit the way', () => way.begin());
    const vehicles = [...station.session.vehicles.keys()];
    const next = vehicles[(vehicles.indexOf(station.chosen ?? -1) + 1) % vehicles.length];
    if (vehicles.length > 1 && next !== undefined) add('Next vehicle', () => choose(next));
    if (!wearer.is_table) {
      const pose = station.session.poses.get(station.chosen ?? -1);
      if (rides !== null) add('Stop riding', () => (this.rides = null));
      else if (pose !== undefined)
        add('Ride along', () => (this.rides = { vehicle: pose.vehicle, at: at_place(pose) }));
    }
    if (this.mode === 'vr') {
      if (wearer.is_table) add('Stand in it', () => this.stand());
      else
        add('Table', () => {
          this.let_go();
          wearer.lay_table(shown());
        });
      add(this.is_seated ? 'I stand' : 'I sit', () => {
        station.settings.headset_is_seated = !this.is_seated;
        keep_settings(station.settings);
        wearer.rig.lift_m = this.is_seated ? SEATED_LIFT_M : 0;
      });
    } else {
      const { at } = this.floor;
      if (at !== null) add('Table where I look', () => wearer.lay_table(shown(), at));
    }
    add('Leave', this.leave);
    return buttons;
  }
}
