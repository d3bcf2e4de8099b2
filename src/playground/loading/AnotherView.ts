import { MathUtils, type Vector3 } from 'three';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { viewsOfFile } from '../../viewer/sceneSetup/ofFile.js';
import { eyeDirection } from '../../viewer/sceneSetup/placeCamera.js';
import { type CameraView, lightOf } from '../../viewer/settings/CameraView.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { sceneTriangles } from '../../viewer/views/sceneTriangles.js';
import { findViews } from '../reading/findViews.js';
import type { Session } from '../session/Session.js';
import { extrasInWorld } from './lightModel.js';

/** A view on offer: framed from a direction, or through a camera of the file. */
interface OfferedView {
  /** Undefined for a view that has no name of its own. */
  name?: string;
  /** Undefined for the direction from which the model is framed at first. */
  direction?: Vector3;
  camera?: CameraView;
}

/** Views nearer to the first one than this are not offered, in degrees around the up axis. */
const LEAST_TURN = 45;

/** Goes through the cameras of the model's file, and the views that show it best. The first of them is the view in which it opens. */
export class AnotherView {
  private offered: readonly OfferedView[] = [];
  private shown = 0;
  /** What the views were found for. */
  private model: HatchedModel | undefined;
  private upAxis: Settings['upAxis'] | undefined;

  constructor(private readonly session: Session) {}

  /** Shows the next view as one step of the history. @returns a sentence that names it; undefined without a model */
  async showNext(): Promise<string | undefined> {
    const { session } = this;
    const { model } = session.viewport;
    if (!model) return undefined;
    if (model !== this.model || session.settings.upAxis !== this.upAxis) {
      const offered = await this.find(model);
      // Another model may have come meanwhile.
      if (model !== session.viewport.model) return undefined;
      Object.assign(this, { offered, model, upAxis: session.settings.upAxis, shown: 0 });
    }
    this.shown = (this.shown + 1) % this.offered.length;
    this.show(this.offered[this.shown]);
    const { name } = this.offered[this.shown];
    return `View ${this.shown + 1} of ${this.offered.length}${name ? `: ${name}` : ''}`;
  }

  private async find(model: HatchedModel): Promise<OfferedView[]> {
    const { settings, viewport } = this.session;
    const request = { triangles: sceneTriangles(model.root, model.joinedParts), up: settings.upAxis, cameras: [] };
    const { views } = await findViews(request, new AbortController().signal);
    const { x, z } = viewport.view.firstDirection;
    const first = MathUtils.radToDeg(Math.atan2(x, z));
    const others = views.filter(({ azimuth }) => turnBetween(azimuth, first) >= LEAST_TURN);
    const { views: cameras } = viewsOfFile(extrasInWorld(model).cameras, lightOf(settings), undefined);
    return [
      ...cameras.map(({ name, camera }) => ({ name, ...(camera && { camera }) })),
      {},
      ...others.map(({ azimuth, elevation }) => ({ direction: eyeDirection(azimuth, elevation).toEye })),
    ];
  }

  private show({ direction, camera }: OfferedView): void {
    const { view } = this.session.viewport;
    const place = (): void => {
      if (camera) view.place = camera;
      else if (direction) view.frameFrom(direction);
      else view.frame();
    };
    place();
    this.session.modelLoader.lightForView();
    // Its shadow, for which framing leaves room, has moved with the light.
    place();
    this.session.recordChange();
  }
}

const turnBetween = (a: number, b: number): number => Math.abs(MathUtils.euclideanModulo(a - b + 180, 360) - 180);
