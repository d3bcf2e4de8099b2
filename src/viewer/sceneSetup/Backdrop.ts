import type { Scene } from 'three';
import { HatchingBackground, type SceneExtent } from 'three-hatching';
import type { Look } from '../settings/lookOf.js';
import type { Layer } from './Ground.js';

/** The hatched background, created when a look first needs it. */
export class Backdrop {
  private background: HatchingBackground | undefined;

  constructor(private readonly scene: Scene) {}

  /** @param subject extent of the scene in front of it */
  apply({ background: wanted }: Look, subject: SceneExtent | null): void {
    if (wanted) {
      this.background ??= this.make();
      const { ink, ...numbers } = wanted;
      this.background.ink.set(ink);
      Object.assign(this.background, numbers, { subject });
    }
    if (this.background) this.background.visible = wanted !== undefined;
  }

  /** Sets the spacing of the background's lines. @param factor on the spacing of the page */
  setWidths({ background }: Look, factor: number): void {
    if (this.background && background) this.background.spacing = background.spacing * factor;
  }

  /** Hides it until a look is applied again. */
  hide(): void {
    if (this.background) this.background.visible = false;
  }

  /** Shows the background in its layer: the one below the model's ink. */
  showLayer(layer: Layer | undefined, { background }: Look): void {
    if (this.background) this.background.visible = background !== undefined && (layer ?? 'shadow') === 'shadow';
  }

  private make(): HatchingBackground {
    const background = new HatchingBackground();
    this.scene.add(background);
    return background;
  }
}
