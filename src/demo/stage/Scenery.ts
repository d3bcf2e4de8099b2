import { Group, type Matrix4, Scene, Vector3 } from 'three';
import type { TonalArtMap } from 'three-hatching';
import { releaseGraphics } from '../drawing/releaseGraphics.js';
import type { Look } from '../settings/lookOf.js';
import { UPRIGHT } from '../settings/settingValues.js';
import { Ground } from './Ground.js';
import type { Layer } from './layers.js';
import { LightRig } from './light/LightRig.js';
import { ShownModel } from './ShownModel.js';

/** What is drawn: the model, turned so that its up axis is y, the ground that it stands on, and the lights. */
export class Scenery {
  readonly scene = new Scene();
  readonly lights = new LightRig(this.scene);
  readonly ground: Ground;
  readonly shown: ShownModel;
  /** How it is drawn; undefined before that was said. */
  look: Look | undefined;
  private readonly upright = new Group();
  private turn: Look['upright'] = UPRIGHT.y;
  private map: TonalArtMap | undefined;
  /** Whether the model throws a shadow on what it stands on, for which it goes aside when it is framed. */
  private showsShadow = false;

  /**
   * @param onGround called when a frame with the ground can be drawn
   * @param onModel as {@link ShownModel} calls it
   */
  constructor(onGround: () => void, onModel: ConstructorParameters<typeof ShownModel>[1]) {
    this.ground = new Ground(this.scene, onGround);
    this.shown = new ShownModel(this.upright, onModel);
    this.scene.add(this.upright);
  }

  /**
   * Gives a look to the lights, the model and the ground. Shadows stay as they are.
   *
   * @returns whether the model was turned, or whether its shadow has come or gone: it may have to be framed anew
   */
  apply(look: Look): { isTurned: boolean; hasOtherShadow: boolean } {
    const { shown, lights, ground, upright } = this;
    lights.apply(look.lights);
    const hadShadow = this.showsShadow;
    this.showsShadow = look.lights.castsShadows && look.ground !== 'none';
    const isTurned = look.upright !== this.turn;
    this.turn = look.upright;
    if (isTurned) upright.rotation.set(...look.upright);
    shown.apply(look);
    ground.apply(look);
    return { isTurned, hasOtherShadow: this.showsShadow !== hadShadow };
  }

  /** Puts the ground under the model. @returns xyz of points of the model, enough to tell where it ends; undefined without one */
  standOnGround(): Float32Array | undefined {
    const { shown, ground, upright } = this;
    upright.updateMatrix();
    if (!shown.model) return undefined;
    ground.height = shown.model.bounds.clone().applyMatrix4(upright.matrix).min.y;
    return turned(shown.model.outline, upright.matrix);
  }

  /** xyz of points of the shadow that an outline casts on the ground, seen from a direction; undefined without one. */
  shadowOf(outline: ArrayLike<number>, toEye: Vector3): number[] | undefined {
    return this.showsShadow ? this.lights.shadowOf(outline, this.ground.height, toEye) : undefined;
  }

  get tonalArtMap(): TonalArtMap | undefined {
    return this.map;
  }

  set tonalArtMap(map: TonalArtMap) {
    this.map = map;
    this.shown.tonalArtMap = map;
    this.ground.tonalArtMap = map;
  }

  /** Whether there is a model, and a map if one is drawn with. */
  get isComplete(): boolean {
    return this.shown.model !== undefined && (this.map !== undefined || this.look?.needsMap === false);
  }

  /**
   * Sets how wide strokes and lines are.
   *
   * @param strokeRatio pixels of the render target per pixel of the look
   * @param share of the full resolution, where it is drawn in a lower one
   */
  setWidths(strokeRatio: number, share: number): void {
    if (!this.look) return;
    this.shown.model?.setWidths(this.look, strokeRatio, share);
    this.ground.setWidths(this.look, strokeRatio, share);
  }

  /** Leaves away, until the look is applied again, what takes programs of its own: lines and ground. */
  showSketch(): void {
    this.shown.model?.showLines(false);
    this.ground.hide();
  }

  /** Shows or hides the paper. Without it, only strokes are drawn. */
  showPaper(isShown: boolean): void {
    this.shown.model?.showPaper(isShown);
    this.ground.showPaper(isShown);
  }

  /** Shows one layer alone, on a transparent ground; or all of them again. */
  showLayer(layer: Layer | undefined): void {
    if (!this.look) return;
    this.shown.model?.showLayer(layer, this.look);
    this.ground.showLayer(layer, this.look);
  }

  /** Disposes of what everything has on the graphics card. To be called while the context is lost. */
  releaseGraphics(): void {
    this.shown.releaseGraphics();
    releaseGraphics(this.scene);
  }
}

/** Points, given as xyz, after a rotation. */
function turned(points: Float32Array, rotation: Matrix4): Float32Array {
  const point = new Vector3();
  const result = points.slice();
  for (let i = 0; i < points.length; i += 3) point.fromArray(points, i).applyMatrix4(rotation).toArray(result, i);
  return result;
}
