import type { BufferGeometry, Camera, IUniform, Mesh, Object3D, WebGLRenderer } from 'three';
import type { Hand } from '../../strokes/hand/Hand.js';
import type { StrokeProfiles } from '../../strokes/strokeProfiles.js';
import type { VertexLayout } from '../deformation/canDeform.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import type { ShaderFiles } from '../shaders/hatchingShaders.js';
import type { MeshUniforms } from '../three/MeshUniforms.js';
import type { Surface } from './surface.js';

/**
 * The shader files and code of a technique, beyond what every material has. Each part is fetched when a material first
 * needs it.
 */
export interface MaterialPart {
  /** What every part needs. */
  readonly surface: Surface;
  /** Its files from shaders/. */
  readonly files: ShaderFiles;
  /**
   * Writes the uniforms of this part after all others. Allocates nothing after the first call.
   *
   * @param pixelRatio pixels of the render target per CSS pixel
   */
  writeUniforms?(uniforms: Record<string, IUniform>, material: HatchingMaterialProperties, pixelRatio: number): void;
  /** @throws TypeError or RangeError with the fault of a hand */
  checkHand?(hand: Hand): void;
  /**
   * The strokes of a hand as they are drawn in rows.
   *
   * @throws TypeError or RangeError with the fault of the hand
   */
  profilesOf?(hand: Hand): StrokeProfiles;
  /**
   * Sets the uniforms for a mesh that the material is about to draw.
   *
   * @returns the layout in which the vertex shader finds the mesh's adjacency, if the part needs adjacency
   */
  bindMesh?(
    renderer: WebGLRenderer,
    camera: Camera,
    geometry: BufferGeometry,
    object: Object3D,
    material: HatchingMaterialProperties & { readonly ofMesh: MeshUniforms },
  ): VertexLayout | undefined;
  /** Builds the other programs that the part needs for a mesh. */
  compile?(renderer: WebGLRenderer, mesh: Mesh): void;
}
