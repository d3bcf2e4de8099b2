import type { BufferGeometry, Camera, IUniform, Material, Object3D, WebGLRenderer } from 'three';
import type { HatchingTechnique } from '../../look/hatchingProperties.js';
import type { HatchingLook } from '../../look/queries.js';
import type { HatchingComposition } from '../groups/HatchingComposition.js';
import type { Mistake } from './sentences.js';

/** The parts of a hatching material that the checks read. */
export interface DrawnMaterial extends Material, HatchingLook {
  readonly technique: HatchingTechnique;
  readonly composition: HatchingComposition;
  readonly lights: boolean;
  readonly uniforms: Readonly<Record<string, IUniform>>;
  readonly ready: Promise<void>;
}

/** The first draw of a mesh by this material, or by this material with another technique or geometry. */
export interface FirstDraw {
  readonly material: DrawnMaterial;
  readonly mesh: Object3D;
  readonly geometry: BufferGeometry;
  readonly scene: Object3D;
  readonly camera: Camera;
  readonly renderer: WebGLRenderer;
  /** Whether the mesh is drawn to the screen; three.js applies tone mapping only there. */
  readonly isOnScreen: boolean;
  /** The height of the picture, in pixels. */
  readonly height: number;
  /** The renderer's frame number. */
  readonly frame: number;
  /** Whether the material's map and code have loaded. */
  readonly isWhole: boolean;
}

/**
 * Registers a mistake.
 *
 * @param culprit the object to change; a mistake is reported once per culprit
 * @param details the further arguments of the message, after the name of the mesh
 */
export type NoteMistake = (mistake: Mistake, draw: FirstDraw, culprit: object, ...details: string[]) => void;
