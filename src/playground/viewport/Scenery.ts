import { Group, type Matrix4, type PerspectiveCamera, Scene, Vector3 } from 'three';
import type { TonalArtMap } from 'three-hatching';
import { type NodeMakers, releaseGraphics } from '../../viewer/drawing/materials.js';
import { Backdrop } from '../../viewer/sceneSetup/Backdrop.js';
import { Ground, type Layer } from '../../viewer/sceneSetup/Ground.js';
import { castersOf, type SheetPart } from '../../viewer/sceneSetup/groundShadow.js';
import { LightRig } from '../../viewer/sceneSetup/LightRig.js';
import type { Look } from '../../viewer/settings/lookOf.js';
import { UPRIGHT } from '../../viewer/settings/settingValues.js';
import { ShownModel } from './ShownModel.js';

/** The scene: the model, turned so that its up axis is y, the ground, and the lights. */
export class Scenery {
  readonly scene = new Scene();
  readonly lights = new LightRig(this.scene);
  readonly ground: Ground;
  private readonly backdrop: Backdrop;
  readonly shown: ShownModel;
  /** The present look; undefined until the first one is applied. */
  look: Look | undefined;
  private readonly upright = new Group();
  private turn: Look['upright'] = UPRIGHT.y;
  private map: TonalArtMap | undefined;
  /** The model's shadow casters in its present orientation; undefined until a shadow falls on the ground. */
  private casters: Float32Array | undefined;
  /** Whether the model casts a shadow on the ground, for which framing leaves room. */
  private showsShadow = false;

  /**
   * @param onGround called when the ground can be drawn
   * @param onModel called when another model is shown, see {@link ShownModel}
   */
  constructor(onGround: () => void, onModel: ConstructorParameters<typeof ShownModel>[1]) {
    this.ground = new Ground(this.scene, onGround);
    this.backdrop = new Backdrop(this.scene);
    this.shown = new ShownModel(this.upright, onModel);
    this.scene.add(this.upright);
  }

  /**
   * Applies a look to the lights, the model and the ground. Does not redraw shadow maps.
   *
   * @returns whether the model was turned, and whether its shadow has appeared or disappeared; both require another framing
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
    this.backdrop.apply(look, shown.model?.extent ?? null);
    return { isTurned, hasOtherShadow: this.showsShadow !== hadShadow };
  }

  /** Lends the model to a node scene, until {@link takeBack}. Does nothing if it is there already. */
  lend(scene: Scene, makers: NodeMakers): void {
    const { shown, look, upright } = this;
    if (look) shown.model?.makeNodes(makers, look);
    shown.model?.useMaterials('nodes');
    if (upright.parent !== scene) scene.add(upright);
  }

  /** Returns the model to its own scene, for WebGLRenderer. */
  takeBack(): void {
    if (this.upright.parent === this.scene) return;
    this.shown.drawn?.useMaterials('drawn');
    this.scene.add(this.upright);
  }

  /** Takes the model back for good, and frees its node materials. */
  dropNodes(): void {
    this.takeBack();
    this.shown.dropNodes();
  }

  /** Puts the ground under the model. @returns xyz of points that suffice to frame the model; undefined without a model */
  standOnGround(): ArrayLike<number> | undefined {
    const { shown, ground, upright } = this;
    upright.updateMatrix();
    if (!shown.model) return undefined;
    ground.extent = shown.model.extent;
    if (this.look) this.backdrop.apply(this.look, shown.model.extent);
    ground.height = shown.model.bounds.clone().applyMatrix4(upright.matrix).min.y;
    this.casters = undefined;
    return turned(shown.model.framedPoints, upright.matrix);
  }

  /** Call this when parts of the model were hidden or shown. */
  outdateCasters(): void {
    this.casters = undefined;
  }

  /** The shadow of points (xyz) on the ground, seen from a direction, as xyz; undefined without a shadow. */
  shadowOf(framedPoints: ArrayLike<number>, toEye: Vector3): number[] | undefined {
    return this.showsShadow ? this.lights.shadowOf(framedPoints, this.ground.height, toEye) : undefined;
  }

  /**
   * Fades the shadow on a ground before it reaches the edges of the sheet, which is a part of the camera's picture. The lights must be
   * placed.
   *
   * @param ground and lights of the renderer in use: the scenery's own, or copies of them
   */
  endShadow(
    camera: PerspectiveCamera,
    part: SheetPart,
    { ground, lights }: Pick<Scenery, 'ground' | 'lights'> = this,
  ): void {
    const { look, shown } = this;
    if (!look || !shown.model || !this.showsShadow) return;
    this.casters ??= castersOf(shown.model.root, shown.model.motion);
    ground.endShadows(look, lights.fadeOf(this.casters, ground.height, camera, part));
  }

  get tonalArtMap(): TonalArtMap | undefined {
    return this.map;
  }

  set tonalArtMap(map: TonalArtMap) {
    this.map = map;
    this.shown.tonalArtMap = map;
    this.ground.tonalArtMap = map;
  }

  /** Whether there is a model, and a map if the look needs one. */
  get isComplete(): boolean {
    return this.shown.model !== undefined && (this.map !== undefined || this.look?.needsMap === false);
  }

  /**
   * Sets the widths of strokes and outlines.
   *
   * @param share of the full width, below 1 on small sheets
   * @param scale of a picture relative to the page
   */
  setWidths(share: number, scale: number): void {
    if (!this.look) return;
    this.shown.model?.setWidths(this.look, share, scale);
    this.ground.setWidths(this.look, share, scale);
    this.backdrop.setWidths(this.look, share * scale);
  }

  /** Hides outlines, ground and shadows, which need programs or frames of their own, until the look is applied again. */
  showSketch(): void {
    this.shown.model?.show('sketch');
    this.ground.hide();
    this.backdrop.hide();
  }

  /**
   * Shows a part of a picture until {@link showWhole}, on a transparent background: all, all but the paper (`ink`), or one layer.
   *
   * @param hasLines whether outlines and background are drawn, which a vector file contains as lines
   */
  show(part: 'whole' | 'ink' | Layer, hasLines: boolean): void {
    const { look, shown, ground, backdrop } = this;
    if (!look) return;
    shown.model?.show(part, hasLines);
    if (part === 'ink') ground.showPaper(false);
    else if (part !== 'whole') {
      ground.showLayer(part);
      backdrop.showLayer(part, look);
    }
    if (!hasLines) backdrop.hide();
  }

  /** Shows what a frame shows. */
  showWhole(): void {
    if (!this.look) return;
    this.shown.model?.apply(this.look);
    this.ground.apply(this.look);
    this.backdrop.showLayer(undefined, this.look);
  }

  /** Disposes of all GPU resources. Call this while the context is lost. */
  releaseGraphics(): void {
    this.shown.releaseGraphics();
    releaseGraphics(this.scene);
  }
}

/** Rotates points, given as xyz. */
function turned(points: Float32Array, rotation: Matrix4): Float32Array {
  const point = new Vector3();
  const result = points.slice();
  for (let i = 0; i < points.length; i += 3) point.fromArray(points, i).applyMatrix4(rotation).toArray(result, i);
  return result;
}
