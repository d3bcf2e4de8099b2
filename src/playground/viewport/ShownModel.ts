import type { Group } from 'three';
import type { TonalArtMap } from 'three-hatching';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { Slices } from '../../viewer/files/common/Slices.js';
import { DEFAULT_VIEW } from '../../viewer/sceneSetup/createCamera.js';
import type { Look } from '../../viewer/settings/lookOf.js';

/** The direction from a model to the eye when the model is framed. */
type ViewDirection = readonly [number, number, number];

/**
 * What has changed: another model or its stand-in is drawn for the first time, a model has taken its stand-in's place, or an earlier model
 * is back.
 */
export type ModelChange = 'another' | 'completed' | 'back';

/** The model that is shown. A stand-in may take its place until the next model is baked; if that fails, the earlier model comes back. */
export class ShownModel {
  private current: HatchedModel | undefined;
  private forerunner: HatchedModel | undefined;
  private firstView: ViewDirection = DEFAULT_VIEW;
  private isTemporary = false;
  /** The model that a stand-in has replaced. It comes back if the next model is not baked. */
  private replaced: { model: HatchedModel | undefined; firstView: ViewDirection } | undefined;
  /** Earlier models are kept until the new one has been drawn, so that programs which both use are not compiled again. */
  private previous: HatchedModel[] = [];
  private map: TonalArtMap | undefined;
  private look: Look | undefined;

  /**
   * @param holder the object that the model is put into
   * @param onChange called when another model is shown, with the direction to the eye when it is framed
   */
  constructor(
    private readonly holder: Group,
    private readonly onChange: (change: ModelChange, firstView: ViewDirection) => void,
  ) {}

  get model(): HatchedModel | undefined {
    return this.current;
  }

  /** What is drawn: the model or, before there is one, its forerunner. */
  get drawn(): HatchedModel | undefined {
    return this.current ?? this.forerunner;
  }

  /** Whether the model only stands in for one that is still being baked. */
  get isStandIn(): boolean {
    return this.isTemporary;
  }

  /** Draws something until the first model is shown. It is disposed of as an earlier model is. */
  setForerunner(forerunner: HatchedModel): void {
    this.forerunner = forerunner;
    this.holder.add(forerunner.root);
  }

  /**
   * Replaces the model. The previous one is disposed of when the new one has been drawn.
   *
   * @param hasStandIn whether the model that is shown stands in for this one, and not for another that was given up
   */
  set(next: HatchedModel, firstView: ViewDirection = DEFAULT_VIEW, hasStandIn = this.isTemporary): void {
    this.disposePrevious();
    const change = hasStandIn ? 'completed' : 'another';
    const before = this.exchange(next);
    this.previous.push(...[before, this.replaced?.model].filter((model) => model !== undefined));
    this.isTemporary = false;
    this.replaced = undefined;
    this.report(change, firstView);
  }

  /** Shows a model until {@link set} sets the one that is being baked, or {@link removeStandIn} brings back the earlier one. */
  setStandIn(next: HatchedModel, firstView: ViewDirection = DEFAULT_VIEW): void {
    this.disposePrevious();
    const before = this.exchange(next);
    if (!this.isTemporary) this.replaced = { model: before, firstView: this.firstView };
    else if (before) this.previous.push(before);
    this.isTemporary = true;
    this.report('another', firstView);
  }

  /** Takes away the stand-in, if one is shown. */
  removeStandIn(): void {
    const { replaced } = this;
    if (!this.isTemporary || !replaced) return;
    this.disposePrevious();
    const standIn = this.exchange(replaced.model);
    if (standIn) this.previous.push(standIn);
    this.isTemporary = false;
    this.replaced = undefined;
    this.report('back', replaced.firstView);
  }

  /**
   * Gives a model the present look before it is set, in slices, so that {@link set} has little to do. Rejects with the reason of
   * the signal.
   */
  async dress(next: HatchedModel, signal: AbortSignal): Promise<void> {
    const slices = new Slices(signal);
    if (this.map) next.tonalArtMap = this.map;
    for (const _ of this.look ? next.applying(this.look) : []) await slices.next();
    signal.throwIfAborted();
  }

  /** Gives the model a look. */
  apply(look: Look): void {
    this.look = look;
    this.drawn?.apply(look);
  }

  set tonalArtMap(map: TonalArtMap) {
    this.map = map;
    if (this.current) this.current.tonalArtMap = map;
  }

  /** Frees what models have for a renderer of nodes. */
  dropNodes(): void {
    for (const model of [this.drawn, this.replaced?.model, ...this.previous]) model?.dropNodes();
  }

  disposePrevious(): void {
    for (const model of this.previous) model.dispose();
    this.previous = [];
  }

  /** Disposes of what the models have on the graphics card. To be called while the context is lost. */
  releaseGraphics(): void {
    this.disposePrevious();
    this.replaced?.model?.releaseGraphics();
    this.drawn?.releaseGraphics();
  }

  /** Shows a model instead of the present one, which is returned. */
  private exchange(next: HatchedModel | undefined): HatchedModel | undefined {
    const before = this.current;
    before?.root.removeFromParent();
    this.current = next;
    if (this.forerunner) {
      this.forerunner.root.removeFromParent();
      this.previous.push(this.forerunner);
      this.forerunner = undefined;
    }
    if (next) this.holder.add(next.root);
    if (next && this.map) next.tonalArtMap = this.map;
    return before;
  }

  private report(change: ModelChange, firstView: ViewDirection): void {
    this.firstView = firstView;
    this.onChange(change, firstView);
  }
}
