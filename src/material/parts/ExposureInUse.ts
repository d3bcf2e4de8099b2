import type { Camera, IUniform, Scene, WebGLRenderer } from 'three';
import { isFitted } from '../exposure/isFitted.js';
import { writeFit } from '../exposure/writeFit.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { fetchedPart, fetchPart } from './parts.js';

/** The exposure of one material, where that is fitted to the scene. */
export class ExposureInUse {
  private isAwaited = false;

  /** Asks for the code that fits an exposure, if a material needs it. */
  fetch({ exposure }: HatchingMaterialProperties): void {
    if (exposure !== 'auto' || this.isAwaited) return;
    this.isAwaited = true;
    // The failure is told of where it happens.
    fetchPart('exposure').catch(() => {});
  }

  /** Writes the exposure that suits the scene which is being drawn, as soon as the code is there. */
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
