import type { BufferGeometry, Camera, IUniform, Mesh, Object3D, Scene, WebGLRenderer } from 'three';
import type { ToneFit } from '../exposure/ToneFit.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import type { MeshUniforms } from '../MeshUniforms.js';
import type { ShaderFiles } from '../shaders/hatchingShaders.js';
import type { VertexLayout } from '../shaders/shaderConventions.js';

/** What a technique or a medium needs beside what every material has. Each part is fetched when a material first needs it. */
export interface MaterialPart {
  /** Its files of shaders/. */
  readonly files: ShaderFiles;
  /** Writes the uniforms that are of this part alone. Allocates nothing after the first call. */
  writeUniforms?(uniforms: Record<string, IUniform>): void;
  /**
   * Sets the uniforms of a mesh that the material is about to draw.
   *
   * @returns where the vertex shader finds the mesh's adjacency, if the part needs that
   */
  bindMesh?(
    renderer: WebGLRenderer,
    camera: Camera,
    geometry: BufferGeometry,
    object: Object3D,
    material: HatchingMaterialProperties & { readonly ofMesh: MeshUniforms },
  ): VertexLayout | undefined;
  /** Builds what other programs it needs for a mesh. */
  compile?(renderer: WebGLRenderer, mesh: Mesh): void;
  /** The exposure that is fitted to a scene which is being drawn. Allocates nothing while nothing in it changes. */
  sceneExposure?(renderer: WebGLRenderer, scene: Scene, camera: Camera): ToneFit;
}
