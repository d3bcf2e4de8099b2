import {
  type BufferGeometry,
  Camera,
  FloatType,
  GLSL3,
  type Mesh,
  NearestFilter,
  NoBlending,
  Scene,
  ShaderMaterial,
  Vector2,
  type Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { pullColumns, pullTextureSize } from '../../mesh/bake/pullLayout.js';
import type { PulledVertices } from '../geometry/PulledVertices.js';
import type { ShaderFiles, Shaders } from '../shaders/hatchingShaders.js';
import { resolveIncludes } from '../shaders/shaderText.js';
import { CornerPoints, NO_CORNERS } from '../three/posing.js';
import type { PosePass } from './Deformation.js';
import { Deformations } from './Deformations.js';

const files: ShaderFiles = import.meta.glob(
  ['./deformation.*', './perTriangle/{pulledVertices,turns}.glsl', './chunks/deformVertex.glsl'],
  { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
);

let made: Shaders | undefined;

/** The shaders of the pre-pass that deforms vertices. The first call resolves their includes. */
export function deformationShaders(): Shaders {
  if (made) return made;
  const chunks = Object.fromEntries(
    Object.entries(files).map(([path, text]) => [
      path.replace('./', '').replace('chunks/', '').replace('.glsl', ''),
      text,
    ]),
  );
  made = {
    vertexShader: resolveIncludes(chunks['deformation.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['deformation.frag'], chunks),
  };
  return made;
}

const noScene = /* @__PURE__ */ new Scene();
const noCamera = /* @__PURE__ */ new Camera();
const allCorners: typeof NO_CORNERS = { start: 0, count: Infinity };

/** The pre-pass: deforms the vertices of a geometry of the `pull` or `indexed` layout into textures, for the poses of its meshes. */
export class PrePass implements PosePass {
  /** The size of the render targets, in texels. */
  private readonly size: { readonly width: number; readonly height: number };
  private readonly points: CornerPoints;
  private readonly shader: ShaderMaterial;

  /** @param vertices the textures of the `pull` layout; null if the geometry has an index, whose vertices are then deformed */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly geometry: BufferGeometry,
    vertices: PulledVertices | null,
  ) {
    const { count } = geometry.attributes.position;
    const { width, height } = vertices?.positions.image ?? pullTextureSize(count);
    this.size = { width, height };
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
  }

  makeTarget(): WebGLRenderTarget {
    return new WebGLRenderTarget(this.size.width, this.size.height, {
      count: 3,
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthBuffer: false,
    });
  }

  draw(target: WebGLRenderTarget, camera: Camera, mesh: Mesh): void {
    this.drawCorners(target, camera, mesh, allCorners);
  }

  /** Builds the program, even before the geometry is on the GPU. */
  compile(target: WebGLRenderTarget, mesh: Mesh): void {
    this.drawCorners(target, noCamera, mesh, NO_CORNERS);
  }

  dispose(): void {
    this.shader.dispose();
  }

  private drawCorners(into: WebGLRenderTarget, camera: Camera, mesh: Mesh, corners: typeof NO_CORNERS): void {
    const { points, renderer } = this;
    points.takePose(mesh);
    const target = renderer.getRenderTarget();
    const face = renderer.getActiveCubeFace();
    const level = renderer.getActiveMipmapLevel();
    const { start, count } = this.geometry.drawRange;
    this.geometry.setDrawRange(0, Infinity);
    renderer.setRenderTarget(into);
    // render() would begin a frame of its own, with lights, shadows, background and counters.
    renderer.renderBufferDirect(camera, noScene, this.geometry, this.shader, points, corners);
    renderer.setRenderTarget(target, face, level);
    this.geometry.setDrawRange(start, count);
    // Each camera of an ArrayCamera draws into its own part of the render target.
    const { viewport } = camera as Camera & { viewport?: Vector4 };
    if (viewport) renderer.state.viewport(viewport);

    points.skeleton = undefined;
  }
}

/** The deformations of WebGLRenderer. Their key is `properties`, which three.js replaces when a lost context is restored. */
export const glslDeformations: Deformations<WebGLRenderer> = /* @__PURE__ */ new Deformations(
  ({ properties }) => properties,
  (renderer, geometry, vertices) => new PrePass(renderer, geometry, vertices),
);
