import type { Camera, IUniform, Scene, WebGLRenderer } from 'three';
import type { HatchingTechnique, Medium } from '../../look/hatchingProperties.js';
import { isFitted } from '../exposure/isFitted.js';
import { writeFit } from '../exposure/ToneFit.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import type { MaterialPart } from './MaterialPart.js';
import { fetchedPart, fetchPart, type PartName, partNameOf } from './parts.js';

/** The part that the program of one material uses. */
export class PartInUse {
  /** The part; null if the program needs none. */
  part: MaterialPart | null = null;
  private awaited: PartName | null = null;

  /** @param onFetched called when a missing part has loaded */
  constructor(private readonly onFetched: () => void) {}

  /**
   * Uses the part that a look needs, or fetches it.
   *
   * @returns whether it has loaded; if not, the previous part stays in use
   */
  take({ technique, medium }: { technique: HatchingTechnique; medium: Medium }): boolean {
    const name = partNameOf(technique, medium);
    const part = name && fetchedPart(name);
    if (part !== undefined) this.part = part;
    else if (this.awaited !== name) this.await(name!);
    return part !== undefined;
  }

  private await(name: PartName): void {
    this.awaited = name;
    const end = (): void => {
      if (this.awaited === name) this.awaited = null;
    };
    fetchPart(name).then(() => {
      end();
      this.onFetched();
    }, end);
  }
}

/** The exposure of one material, if it is fitted to the scene. */
export class ExposureInUse {
  private isAwaited = false;

  /** Fetches the code that fits an exposure, if a material needs it. */
  fetch({ exposure }: HatchingMaterialProperties): void {
    if (exposure !== 'auto' || this.isAwaited) return;
    this.isAwaited = true;
    // Failures are reported where they occur.
    fetchPart('exposure').catch(() => {});
  }

  /** Writes the exposure that suits the scene being drawn, once the code has loaded. */
  write(
    material: HatchingMaterialProperties,
    renderer: WebGLRenderer,
    scene: Scene,
    camera: Camera,
    uniforms: Readonly<Record<string, IUniform>>,
  ): void {
    this.fetch(material);
    if (!isFitted(material)) return;
    const fit = fetchedPart('exposure')?.sceneExposure?.(renderer, scene, camera);
    if (fit) writeFit(fit, material, uniforms);
  }
}
