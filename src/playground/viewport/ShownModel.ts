import type { Group } from 'three';
import type { TonalArtMap } from 'three-hatching';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { Slices } from '../../viewer/files/common/Slices.js';
import { DEFAULT_VIEW } from '../../viewer/sceneSetup/LensCamera.js';
import type { Look } from '../../viewer/settings/lookOf.js';

/** The direction from a model to the eye when the model is framed. */
type ViewDirection = readonly [number, number, number];

/**
 * The kind of change: another model or its placeholder is shown, a model has replaced its placeholder, an earlier model is back, or other
 * parts of the same one are hidden.
 */
export type ModelChange = 'another' | 'completed' | 'back' | 'parts';

/** The shown model. A placeholder may replace it until the next model is baked; if that fails, the earlier model returns. */
export class ShownModel {
  private current: HatchedModel | undefined;
  private warmUp: HatchedModel | undefined;
  private firstView: ViewDirection = DEFAULT_VIEW;
  private isTemporary = false;
  /** The model that a placeholder has replaced, which returns if the next model fails. */
  private replaced: { model: HatchedModel | undefined; firstView: ViewDirection } | undefined;
  /** Earlier models are kept until the new one has been drawn, so that shared programs are not compiled again. */
  private previous: HatchedModel[] = [];
  private map: TonalArtMap | undefined;
  private look: Look | undefined;

  /**
   * @param holder the parent object of the model
   * @param onChange called when another model is shown, with the direction to the eye for framing
   */
  constructor(
    private readonly holder: Group,
    private readonly onChange: (change: ModelChange, firstView: ViewDirection) => void,
  ) {}

  get model(): HatchedModel | undefined {
    return this.current;
  }

  /** The object to draw: the model or, before there is one, the triangle of `warmUpModel`. */
  get drawn(): HatchedModel | undefined {
    return this.current ?? this.warmUp;
  }

  /** Whether the model is a placeholder for one that is still being baked. */
  get isPlaceholder(): boolean {
    return this.isTemporary;
  }

  /** Draws a substitute until the first model is shown, which then is disposed of like an earlier model. */
  setWarmUp(warmUp: HatchedModel): void {
    this.warmUp = warmUp;
    this.holder.add(warmUp.root);
  }

  /**
   * Replaces the model. The previous one is disposed of when the new one has been drawn.
   *
   * @param hasPlaceholder whether the shown placeholder belongs to this model, and not to one that was given up
   */
  set(next: HatchedModel, firstView: ViewDirection = DEFAULT_VIEW, hasPlaceholder = this.isTemporary): void {
    this.disposePrevious();
    const change = hasPlaceholder ? 'completed' : 'another';
    const before = this.exchange(next);
    this.previous.push(...[before, this.replaced?.model].filter((model) => model !== undefined));
    this.isTemporary = false;
    this.replaced = undefined;
    this.report(change, firstView);
  }

  /** Replaces the model by a copy of it with other parts hidden. Both are framed in the same way. */
  replace(next: HatchedModel): void {
    this.disposePrevious();
    const before = this.exchange(next);
    if (before) this.previous.push(before);
    this.report('parts', this.firstView);
  }

  /** Shows a placeholder until {@link set} sets the baked model, or {@link removePlaceholder} brings back the earlier one. */
  setPlaceholder(next: HatchedModel, firstView: ViewDirection = DEFAULT_VIEW): void {
    this.disposePrevious();
    const before = this.exchange(next);
    if (!this.isTemporary) this.replaced = { model: before, firstView: this.firstView };
    else if (before) this.previous.push(before);
    this.isTemporary = true;
    this.report('another', firstView);
  }

  /** Removes the placeholder, if one is shown. */
  removePlaceholder(): void {
    const { replaced } = this;
    if (!this.isTemporary || !replaced) return;
    this.disposePrevious();
    const placeholder = this.exchange(replaced.model);
    if (placeholder) this.previous.push(placeholder);
    this.isTemporary = false;
    this.replaced = undefined;
    this.report('back', replaced.firstView);
  }

  /**
   * Applies the present look to a model before it is set, in time slices, so that {@link set} has little to do. Rejects with the signal's
   * reason.
   */
  async dress(next: HatchedModel, signal: AbortSignal): Promise<void> {
    const slices = new Slices(signal);
    if (this.map) next.tonalArtMap = this.map;
    for (const _ of this.look ? next.applying(this.look) : []) await slices.next();
    signal.throwIfAborted();
  }

  /** Applies a look to the model. */
  apply(look: Look): void {
    this.look = look;
    this.drawn?.apply(look);
  }

  set tonalArtMap(map: TonalArtMap) {
    this.map = map;
    if (this.current) this.current.tonalArtMap = map;
  }

  /** Frees the node materials of models. */
  dropNodes(): void {
    for (const model of [this.drawn, this.replaced?.model, ...this.previous]) model?.dropNodes();
  }

  disposePrevious(): void {
    for (const model of this.previous) model.dispose();
    this.previous = [];
  }

  /** Disposes of the models' GPU resources. Call this while the context is lost. */
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
    if (this.warmUp) {
      this.warmUp.root.removeFromParent();
      this.previous.push(this.warmUp);
      this.warmUp = undefined;
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
