// What is about the vehicles in the scene beside sea and sky: foundations, what is laid, what is
// inspected, thrusters at work, the wind, and pictures of cameras.
import { Vector3, type Scene } from 'three';
import { colours } from '../look/palette';
import type { Pose } from '../session/frame';
import type { Vehicle } from '../session/message';
import type { Session } from '../session/state';
import { at_place } from './axes';
import type { BedView } from './bed_view';
import { is_small, type Lens } from './detail';
import { FindingsView } from './findings_view';
import { Foundations } from './foundations';
import { InspectedView } from './inspected_view';
import { Jets } from './jets';
import { LaidView } from './laid_view';
import type { Layers } from './layers';
import { PictureView, aspect_of, type LastPicture } from './picture_view';
import { WindView } from './wind_view';

const JETS_WITHIN_M = 80;

export class SiteView {
  readonly inspected: InspectedView;
  /** Of the camera that is looked through beside the controls. */
  picture: LastPicture | null = null;
  private readonly foundations: Foundations;
  private readonly laid: LaidView;
  private readonly jets: Jets;
  private readonly findings: FindingsView;
  private readonly wind: WindView;
  private readonly pane: PictureView;

  constructor(scene: Scene) {
    this.foundations = new Foundations(scene);
    this.laid = new LaidView(scene);
    this.jets = new Jets(scene);
    this.inspected = new InspectedView(scene);
    this.findings = new FindingsView(scene);
    this.wind = new WindView(scene);
    this.pane = new PictureView(scene);
  }

  show(session: Session, lens: Lens, bed: BedView, layers: Layers): void {
    const paint = colours();
    const { eye } = lens;
    this.foundations.show(session.structures, lens);
    this.show_jets(session, eye);
    if (layers.laid) this.laid.show(session, bed, lens, paint);
    else this.laid.hide();
    if (layers.inspected) {
      this.inspected.show(session, lens, paint);
      this.findings.show(session.findings.values(), paint.alarm);
    } else {
      this.inspected.hide(session);
      this.findings.hide();
    }
    if (layers.wind) this.wind.show(session, eye, paint.ink);
    else this.wind.hide();
  }

  /** At the far end of what the camera of a vehicle sees, if there is one of it, and of now. */
  show_picture(pose: Pose | null, session: Session, layers: Layers): void {
    const { picture } = this;
    const pointing = pose === null ? null : session.statuses.get(pose.vehicle)?.camera;
    const is_shown =
      layers.picture && picture !== null && !picture.is_old && picture.of.vehicle === pose?.vehicle;
    if (is_shown && pose !== null && pointing != null) this.pane.show(pose, pointing, picture);
    else this.pane.hide();
  }

  /** As the picture is, if there is one of that vehicle. */
  aspect(vehicle: number): number | undefined {
    const { picture } = this;
    return picture?.of.vehicle === vehicle ? aspect_of(picture) : undefined;
  }

  private show_jets(session: Session, eye: Vector3): void {
    this.jets.begin();
    for (const pose of session.poses.values()) {
      const vehicle = session.vehicles.get(pose.vehicle);
      if (vehicle === undefined || at_place(pose).distanceTo(eye) > JETS_WITHIN_M) continue;
      this.jets.add(vehicle, pose, session.thrusts.get(pose.vehicle) ?? []);
    }
    this.jets.end(colours().sky);
  }
}

/** Drawn as one mark: so small that its shape would not be seen. */
export function is_far(lens: Lens, pose: Pose, vehicle: Vehicle): boolean {
  return is_small(lens, at_place(pose), Math.max(0.3, vehicle.length_m));
}
