import type { BufferGeometry, Camera, IUniform, Material, Object3D, WebGLRenderer } from 'three';
import type { HatchingTechnique, Medium } from '../../look/hatchingProperties.js';
import type { HatchingLook } from '../../look/queries.js';

/** A hatching material, as far as the checks look at it. */
export interface DrawnMaterial extends Material, HatchingLook {
  readonly technique: HatchingTechnique;
  readonly medium: Medium;
  readonly exposure: number | 'auto';
  readonly lights: boolean;
  readonly uniforms: Readonly<Record<string, IUniform>>;
  readonly ready: Promise<void>;
}

/** A mesh that is drawn for the first time: by this material, or by this material with another technique or geometry. */
export interface FirstDraw {
  readonly material: DrawnMaterial;
  readonly mesh: Object3D;
  readonly geometry: BufferGeometry;
  readonly scene: Object3D;
  readonly camera: Camera;
  readonly renderer: WebGLRenderer;
  /** Whether it is drawn to the screen, where alone three.js maps tones. */
  readonly isOnScreen: boolean;
  /** Of the picture, in pixels. */
  readonly height: number;
  /** The frame of the renderer in which it is drawn. */
  readonly frame: number;
  /** Whether the map and the code that the material draws with are there. */
  readonly isWhole: boolean;
}
