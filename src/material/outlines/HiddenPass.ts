import {
  type BufferGeometry,
  type Camera,
  GreaterDepth,
  LessEqualDepth,
  type Object3D,
  type Scene,
  type WebGLRenderer,
} from 'three';
import type { HatchingOutlineMaterial } from './HatchingOutlineMaterial.js';
import { copyDrawState } from './surfaceRules.js';

/** An object that draws outlines. */
type Outlines = Object3D & { geometry: BufferGeometry; material: HatchingOutlineMaterial };

/** Draws hidden outlines with a second material, which shares the uniforms of the first and takes over its state. */
export class HiddenPass {
  private material: HatchingOutlineMaterial | null = null;
  private source: HatchingOutlineMaterial | null = null;
  private version = -1;

  /** Draws the hidden parts of outlines, right after the visible ones. */
  draw(outlines: Outlines, renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
    const material = this.materialFor(outlines.material);
    copyDrawState(outlines.material, material);
    // If the depth of the scene is known, the fragment shader decides what is hidden.
    const isKnown: boolean = material.uniforms.hasSceneDepth.value;
    material.depthTest = !isKnown;
    material.depthFunc = isKnown ? LessEqualDepth : GreaterDepth;
    renderer.renderBufferDirect(camera, scene, outlines.geometry, material, outlines, null!);
  }

  dispose(): void {
    this.material?.dispose();
    this.material = null;
    this.source = null;
  }

  private materialFor(source: HatchingOutlineMaterial): HatchingOutlineMaterial {
    if (!this.material || this.source !== source) {
      this.material?.dispose();
      this.material = source.clone();
      this.material.uniforms = source.uniforms;
      this.source = source;
      this.version = -1;
    }
    const { material } = this;
    if (this.version !== source.version) {
      this.version = source.version;
      material.copy(source);
      material.depthWrite = false;
      material.defines = { ...source.defines, HIDDEN: '' };
      material.needsUpdate = true;
    }
    return material;
  }
}
