import type { Scene } from 'three';
import { HatchingBackground, type SceneExtent } from 'three-hatching';
import type { Look } from '../settings/lookOf.js';
import type { Layer } from './layers.js';

/** The hatched background behind the model, once a look asks for one. */
export class Backdrop {
  private background: HatchingBackground | undefined;

  constructor(private readonly scene: Scene) {}

  /** @param subject what it lies behind */
  apply({ background: wanted }: Look, subject: SceneExtent | null): void {
    if (wanted) {
      this.background ??= this.make();
      const { ink, ...numbers } = wanted;
      this.background.ink.set(ink);
      Object.assign(this.background, numbers, { subject });
    }
    if (this.background) this.background.visible = wanted !== undefined;
  }

  /** Sets how far apart its lines lie. @param factor on their distance on the page */
  setWidths({ background }: Look, factor: number): void {
    if (this.background && background) this.background.spacing = background.spacing * factor;
  }

  /** Hides it until a look is applied again. */
  hide(): void {
    if (this.background) this.background.visible = false;
  }

  /** Shows it if it is of a layer: that of what lies under the ink of the model. */
  showLayer(layer: Layer | undefined, { background }: Look): void {
    if (this.background) this.background.visible = background !== undefined && (layer ?? 'shadow') === 'shadow';
  }

  private make(): HatchingBackground {
    const background = new HatchingBackground();
    this.scene.add(background);
    return background;
  }
}
