import {
  type BufferGeometry,
  Camera,
  FloatType,
  GLSL3,
  type Material,
  type Matrix4,
  type Mesh,
  NearestFilter,
  NoBlending,
  Points,
  Scene,
  ShaderMaterial,
  type Skeleton,
  type SkinnedMesh,
  type Texture,
  Vector2,
  type Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { pullColumns, pullTextureSize } from '../bake/pullLayout.js';
import { identityOf } from '../geometry/identityOf.js';
import type { PulledVertices } from '../geometry/PulledVertices.js';
import { deformationShaders } from './hatchingShaders.js';
import { Pose } from './Pose.js';

/** The corners of a mesh as points; with an index, its vertices. three.js uploads bones and morph targets for them as for the mesh. */
class CornerPoints extends Points {
  isSkinnedMesh = false;
  skeleton: Skeleton | undefined;
  bindMatrix: Matrix4 | undefined;
  bindMatrixInverse: Matrix4 | undefined;
}

const noScene = /* @__PURE__ */ new Scene();
const noCamera = /* @__PURE__ */ new Camera();
const allCorners = { start: 0, count: Infinity };
/** With this three.js builds the program, and then neither binds nor draws. */
const noCorners = { start: 1, count: -2 };

/**
 * Positions, normals and rotations of one mesh of the `pull` or `indexed` layout in its present pose: one texel per vertex, on
 * one graphics context. Each vertex is deformed once per pose, however many corners, materials, cameras and frames use it.
 */
export class Deformation {
  private readonly points: CornerPoints;
  private readonly shader: ShaderMaterial;
  private readonly target: WebGLRenderTarget;
  private readonly pose = new Pose();
  private readonly users = new Set<Material>();
  private disposed = false;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly geometry: BufferGeometry,
    vertices: PulledVertices | null,
  ) {
    const { count } = geometry.attributes.position;
    const { width, height } = vertices?.positions.image ?? pullTextureSize(count);
    this.target = new WebGLRenderTarget(width, height, {
      count: 3,
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthBuffer: false,
    });
    this.shader = new ShaderMaterial({
      name: 'HatchingDeformation',
      uniforms: {
        pullRowShift: { value: vertices?.rowShift ?? Math.log2(pullColumns(count)) },
        triangleVertices: { value: vertices?.triangleVertices ?? null },
        targetSize: { value: new Vector2(width, height) },
      },
      defines: vertices ? {} : { VERTEX_PER_TEXEL: '' },
      ...deformationShaders(),
      glslVersion: GLSL3,
      blending: NoBlending,
      depthTest: false,
      depthWrite: false,
    });
    this.points = new CornerPoints(geometry);
    geometry.addEventListener('dispose', this.dispose);
    renderer.domElement.addEventListener('webglcontextlost', this.dispose);
  }

  /** x, y, z of each vertex as drawn, in object space. */
  get positions(): Texture {
    return this.target.textures[0];
  }

  /** x, y, z of each vertex's normal as drawn, in object space, not of unit length. */
  get normals(): Texture {
    return this.target.textures[1];
  }

  /** The rotation of each vertex by its skin, as a quaternion; zero where morph targets move it too. */
  get turns(): Texture {
    return this.target.textures[2];
  }

  get isDisposed(): boolean {
    return this.disposed;
  }

  isOf(geometry: BufferGeometry): boolean {
    return identityOf(geometry) === identityOf(this.geometry);
  }

  /**
   * Brings the textures up to date while the renderer draws `mesh` with `material` for `camera`. Does nothing if the pose has not
   * changed. Leaves the renderer's state as it was. Allocates nothing.
   */
  update(camera: Camera, mesh: Mesh, material: Material): void {
    if (!this.users.has(material)) {
      this.users.add(material);
      material.addEventListener('dispose', this.dispose);
    }
    if (this.pose.update(mesh)) this.draw(camera, mesh, allCorners);
  }

  /** Builds the program, and draws nothing: the geometry need not be on the graphics card yet. */
  compile(mesh: Mesh): void {
    this.draw(noCamera, mesh, noCorners);
  }

  /**
   * Frees the graphics memory. Called when the geometry or a material that draws it is disposed of, and when the context is
   * lost: later the names of what it held may mean something else, in a context that came back.
   */
  readonly dispose = (): void => {
    this.disposed = true;
    this.target.dispose();
    this.shader.dispose();
    this.geometry.removeEventListener('dispose', this.dispose);
    this.renderer.domElement.removeEventListener('webglcontextlost', this.dispose);
    for (const material of this.users) material.removeEventListener('dispose', this.dispose);
  };

  private draw(camera: Camera, mesh: Mesh, corners: typeof allCorners): void {
    const { points, renderer } = this;
    points.morphTargetInfluences = mesh.morphTargetInfluences;
    if ('isSkinnedMesh' in mesh) {
      const { skeleton, bindMatrix, bindMatrixInverse } = mesh as SkinnedMesh;
      points.isSkinnedMesh = true;
      points.skeleton = skeleton;
      points.bindMatrix = bindMatrix;
      points.bindMatrixInverse = bindMatrixInverse;
    }

    const target = renderer.getRenderTarget();
    const face = renderer.getActiveCubeFace();
    const level = renderer.getActiveMipmapLevel();
    const { start, count } = this.geometry.drawRange;
    this.geometry.setDrawRange(0, Infinity);
    renderer.setRenderTarget(this.target);
    // Not render(): that would begin a frame of its own, with lights, shadows, background and counters.
    renderer.renderBufferDirect(camera, noScene, this.geometry, this.shader, points, corners);
    renderer.setRenderTarget(target, face, level);
    this.geometry.setDrawRange(start, count);
    // Each camera of an ArrayCamera draws into its own part of the target.
    const { viewport } = camera as Camera & { viewport?: Vector4 };
    if (viewport) renderer.state.viewport(viewport);

    // The bones refer to the mesh, which must stay collectable.
    points.skeleton = undefined;
  }
}
