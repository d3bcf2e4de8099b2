import type { Camera, IUniform, Scene, WebGLRenderer } from 'three';
import { isFitted } from '../exposure/isFitted.js';
import { writeFit } from '../exposure/writeFit.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { fetchedPart, fetchPart } from './parts.js';

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
