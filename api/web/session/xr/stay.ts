// One stay in the scene with a headset, frame by frame: what the hands do, where that brings one,
// what is drawn.
import { Vector3 } from 'three';
import type { OrdersBar } from '../panel/orders_bar';
import type { ScenePeople } from '../panel/scene_people';
import type { WaypointEdit } from '../panel/waypoint_edit';
import { last_notice } from '../look/notice';
import { keep_settings } from '../look/settings';
import type { SceneView, Shown } from '../scene/scene_view';
import { colours } from '../look/palette';
import type { Station } from '../station';
import { board_lines, helm_buttons, type BoardButton, type BoardLine } from './board_words';
import { Flight, narrowed, out_of_bed_m, SEATED_LIFT_M, SnapTurn } from './comfort';
import type { HelmHand } from './helm_hand';
import type { Mode } from './modes';
import { INDEX_TIP } from './joints';
import { own_buttons } from './own_buttons';
import { Presses } from './presses';
import { HandReader, SIDES, spot_of, turn_of, type HandReading, type Side } from './reading';
import { Ride } from './ride';
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
  /** A hand of the headset is on the vehicle's stick, and that is what goes out. */
  drives: () => boolean;
  /** It begins, ends, or has other hands. */
  on_change: () => void;
}

export interface OnBoard {
  lines: string[];
  /** And where each is, in the headset's own metres. */
  buttons: { text: string; at: Vector3 }[];
}

export class Stay {
  readonly wearer: Wearer;
  private readonly reader = new HandReader();
  private readonly table: TableHand;
  private readonly snap = new SnapTurn();
  private readonly flight = new Flight();
  private readonly ride = new Ride();
  private readonly floor = new FloorAhead();
  private hands: HandReading[] = [];
  private readonly presses = new Presses();
  private readonly busy = new Set<Side>(); // with the board
  private was_hold = false;
  private throwing: Side | null = null;
  private narrow = 0;
  private before_ms: number | null = null;
  private board_ms = -Infinity;
  private told = '';
  private lines: readonly BoardLine[] = [];

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

  /** What the board shows, for who stands beside. */
  on_board(): OnBoard {
    const lines = this.lines.map((it) => it.text);
    return { lines, buttons: this.wearer.board.buttons() };
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

  end(): void {
    this.let_go();
    this.floor.end();
    this.wearer.dispose();
  }

  frame(now_ms: number, frame: XRFrame): void {
    const space = this.view.renderer.xr.getReferenceSpace();
    const head = space === null ? null : spot_of(frame.getViewerPose(space));
    const is_seen = this.session.visibilityState === 'visible';
    if (head === null || !is_seen) this.let_go();
    if (space === null || head === null) return;
    this.wearer.rig.take_head(head);
    if (!this.wearer.is_table) this.wearer.rig.lift_m = this.lift_m;
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
    if (this.mode === 'vr') this.stand();
    else {
      this.lay_table();
      void this.floor.begin(this.session);
    }
  }

  private stand(): void {
    const { camera } = this.view.eye;
    const { rig } = this.wearer;
    const [turn_rad, head_turn_rad] = [turn_of(camera.quaternion), turn_of(rig.head.quaternion)];
    this.let_go();
    this.ride.end();
    rig.lift_m = this.lift_m;
    this.wearer.stand(camera.position, turn_rad, head_turn_rad);
  }

  private lay_table(): void {
    this.let_go();
    this.ride.end();
    this.wearer.lay_table(this.lent.shown());
  }

  /** As the settings have it now: they may change while it is worn. */
  private get lift_m(): number {
    const is_lifted = this.mode === 'vr' && this.lent.station.settings.headset_is_seated;
    return is_lifted ? SEATED_LIFT_M : 0;
  }

  private use_hands(step_s: number): void {
    const { hands, helm, wearer } = this;
    const { station, orders } = this.lent;
    this.presses.look(hands);
    this.press_board();
    const is_hold = hands.some((it) => it.is_hold);
    if (is_hold && !this.was_hold && station.may_hold()) orders.hold();
    this.was_hold = is_hold;
    if (wearer.is_table) this.table.take(hands, this.presses, this.busy);
    else this.throw_on();
    const may = (it: HandReading): boolean =>
      !wearer.is_table &&
      !this.busy.has(it.side) &&
      this.throwing !== it.side &&
      (it.kind === 'controller' || station.has_helm());
    helm.take(hands, turn_of(wearer.rig.head.quaternion), may, performance.now());
    const { poses } = station.session;
    const flies = this.move(step_s);
    const ridden = this.ride.step(poses);
    if (ridden !== null) wearer.rig.move(ridden);
    const is_moved = flies || this.ride.is_felt(poses);
    const wants = station.settings.headset_narrows && !wearer.is_table;
    this.narrow = narrowed(this.narrow, wants && is_moved, step_s);
    wearer.vignette.show(this.narrow);
    this.point();
    for (const side of SIDES) {
      const hand = hands.find((it) => it.side === side) ?? null;
      const is_held = helm.held_by === side;
      wearer.hands[side].show(hand, is_held && this.lent.drives(), !is_held);
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
    this.ride.end();
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
    if (!is_table) {
      const head = rig.head_at();
      rig.move(new Vector3(0, out_of_bed_m(head.y, this.view.surround.bed_under(head)), 0));
    }
    return true;
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
    this.lines = board_lines(station, {
      stick: orders.said(),
      way: way.said(),
      notice: last_notice(),
    });
    const hold = station.may_hold() ? (): void => orders.hold() : null;
    board.show(this.lines, hold, [...helm_buttons(station), ...this.own_buttons()]);
  }

  private own_buttons(): BoardButton[] {
    const { wearer, ride, floor } = this;
    const { station, way, choose, shown } = this.lent;
    return own_buttons(station, way, {
      mode: this.mode,
      is_table: wearer.is_table,
      rides: ride.is_on,
      is_seated: station.settings.headset_is_seated,
      finds_floor: floor.at !== null,
      ride: (pose) => ride.begin(pose),
      end_ride: () => ride.end(),
      stand: () => this.stand(),
      lay_table: () => this.lay_table(),
      lay_table_there: () => wearer.lay_table(shown(), floor.at),
      sit: (is_seated) => {
        station.settings.headset_is_seated = is_seated;
        keep_settings(station.settings);
      },
      choose,
      leave: this.leave,
    });
  }
}
