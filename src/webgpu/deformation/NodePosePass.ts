import {
  type BufferGeometry,
  type Camera,
  FloatType,
  type IUniform,
  type Matrix4,
  type Mesh,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  Points,
  RenderTarget,
  type Skeleton,
  type SkinnedMesh,
  Vector2,
} from 'three';
import { NodeMaterial, type WebGPURenderer } from 'three/webgpu';
import type { PosePass } from '../../material/deformation/Deformation.js';
import type { PulledVertices } from '../../material/geometry/PulledVertices.js';
import { pullTextureSize } from '../../mesh/bake/pullLayout.js';
import { OF_CORNERS, OF_VERTICES } from './poseNodes.js';

/** The corners of meshes as points, or their vertices if they have an index. three.js poses them as it does the meshes. */
class CornerPoints extends Points {
  isSkinnedMesh = false;
  skeleton: Skeleton | undefined;
  bindMatrix: Matrix4 | undefined;
  bindMatrixInverse: Matrix4 | undefined;
}

class PoseMaterial extends NodeMaterial {
  /** What nodes read. */
  readonly uniforms: Record<string, IUniform>;

  static override get type(): string {
    return 'HatchingPoseNodeMaterial';
  }

  constructor(vertices: PulledVertices | null, size: Vector2) {
    super();
    const { vertex, fragment } = vertices ? OF_CORNERS : OF_VERTICES;
    this.uniforms = {
      triangleVertices: { value: vertices?.triangleVertices ?? null },
      targetSize: { value: size },
    };
    this.vertexNode = vertex;
    this.fragmentNode = fragment;
    this.blending = NoBlending;
    // Passes that leave out opaque objects draw outlines too.
    this.transparent = true;
    this.depthTest = false;
    this.depthWrite = false;
    this.fog = false;
  }

  /** The vertex node poses vertices. */
  override setupPosition(): ReturnType<NodeMaterial['setupPosition']> {
    return undefined as unknown as ReturnType<NodeMaterial['setupPosition']>;
  }
}

/** three.js fits its projection to the device, so it must have one. */
const noCamera = /* @__PURE__ */ new OrthographicCamera();

/**
 * Poses the vertices of a geometry for WebGPURenderer, into two textures: positions, and rotations by the skin or else normals. A third one
 * would be more than every device of WebGPU can draw into at once.
 */
export class NodePosePass implements PosePass {
  private readonly size = new Vector2();
  private readonly material: PoseMaterial;
  /** By the number of bones, which chooses a program. */
  private readonly points = new Map<number, CornerPoints>();

  /** @param vertices the textures of the `pull` layout; null if the geometry has an index, whose vertices are then deformed */
  constructor(
    private readonly renderer: WebGPURenderer,
    private readonly geometry: BufferGeometry,
    vertices: PulledVertices | null,
  ) {
    const { width, height } = vertices?.positions.image ?? pullTextureSize(geometry.attributes.position.count);
    this.size.set(width, height);
    this.material = new PoseMaterial(vertices, this.size);
  }

  makeTarget(): RenderTarget {
    return new RenderTarget(this.size.x, this.size.y, {
      count: 2,
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthBuffer: false,
    });
  }

  draw(into: RenderTarget, _camera: Camera, mesh: Mesh): void {
    const { geometry, renderer } = this;
    const points = this.pointsOf(mesh);
    const target = renderer.getRenderTarget();
    const face = renderer.getActiveCubeFace();
    const level = renderer.getActiveMipmapLevel();
    const outputs = renderer.getMRT();
    const drawObject = renderer.getRenderObjectFunction();
    const { start, count } = geometry.drawRange;
    const { calls } = renderer.info.render;
    geometry.setDrawRange(0, Infinity);
    renderer.setMRT(null);
    renderer.setRenderObjectFunction(null);
    renderer.setRenderTarget(into);
    renderer.render(points, noCamera);
    renderer.setRenderTarget(target, face, level);
    renderer.setRenderObjectFunction(drawObject);
    renderer.setMRT(outputs);
    geometry.setDrawRange(start, count);
    // Frames are told apart by it, and this one goes on.
    renderer.info.render.calls = calls;
    // The bones refer to the mesh, which must stay collectable.
    points.skeleton = undefined;
  }

  dispose(): void {
    this.material.dispose();
  }

  private pointsOf(mesh: Mesh): CornerPoints {
    const { bindMatrix, bindMatrixInverse, skeleton } = mesh as Partial<SkinnedMesh>;
    const bones = skeleton?.bones.length ?? 0;
    let points = this.points.get(bones);
    if (!points) {
      points = new CornerPoints(this.geometry, this.material);
      points.isSkinnedMesh = skeleton !== undefined;
      points.frustumCulled = false;
      this.points.set(bones, points);
    }
    points.morphTargetInfluences = mesh.morphTargetInfluences;
    points.skeleton = skeleton;
    points.bindMatrix = bindMatrix;
    points.bindMatrixInverse = bindMatrixInverse;
    return points;
  }
}
