import {
  type BufferGeometry,
  type Camera,
  FloatType,
  type IUniform,
  type Mesh,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  RenderTarget,
  type SkinnedMesh,
  Vector2,
} from 'three';
import { NodeMaterial, type WebGPURenderer } from 'three/webgpu';
import type { PosePass } from '../../material/deformation/Deformation.js';
import { Deformations } from '../../material/deformation/Deformations.js';
import type { PulledVertices } from '../../material/geometry/PulledVertices.js';
import { CornerPoints } from '../../material/three/posing.js';
import { pullTextureSize } from '../../mesh/bake/pullLayout.js';
import { OF_CORNERS, OF_VERTICES } from '../nodes/outlines/poses.js';

class PoseMaterial extends NodeMaterial {
  /** The uniforms that nodes read. */
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
    // Applications that render without opaque objects still draw outlines, which need poses.
    this.transparent = true;
    this.depthTest = false;
    this.depthWrite = false;
    this.fog = false;
  }

  /** The vertex node places the vertex, so three.js must not. */
  override setupPosition(): ReturnType<NodeMaterial['setupPosition']> {
    return undefined as unknown as ReturnType<NodeMaterial['setupPosition']>;
  }
}

/** The camera that three.js requires. */
const noCamera = /* @__PURE__ */ new OrthographicCamera();

/**
 * Renders the deformed vertices of a geometry into two textures for WebGPURenderer: positions, and rotations by the skin or else normals.
 * Some WebGPU devices cannot render into three such textures at once.
 */
export class NodePosePass implements PosePass {
  private readonly size = new Vector2();
  private readonly material: PoseMaterial;
  /** By the number of bones, which the program depends on. */
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
    // three.js tells frames apart by this count, and the current frame goes on.
    renderer.info.render.calls = calls;
    points.skeleton = undefined;
  }

  dispose(): void {
    this.material.dispose();
  }

  private pointsOf(mesh: Mesh): CornerPoints {
    const bones = (mesh as Partial<SkinnedMesh>).skeleton?.bones.length ?? 0;
    let points = this.points.get(bones);
    if (!points) {
      points = new CornerPoints(this.geometry, this.material);
      points.frustumCulled = false;
      this.points.set(bones, points);
    }
    points.takePose(mesh);
    return points;
  }
}

/** The deformed geometries of WebGPURenderer. */
export const nodeDeformations: Deformations<WebGPURenderer> = /* @__PURE__ */ new Deformations<WebGPURenderer>(
  (renderer) => renderer,
  (renderer, geometry, vertices) => new NodePosePass(renderer, geometry, vertices),
);

/** Whether the device can render into float textures. Every WebGPU device can. */
export const hasFloatTargets = ({ backend }: WebGPURenderer): boolean =>
  (backend as { extensions?: { has(name: string): boolean } }).extensions?.has('EXT_color_buffer_float') ?? true;
