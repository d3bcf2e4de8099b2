import {
  type Camera,
  FrontSide,
  GLSL3,
  type Material,
  NearestFilter,
  NoBlending,
  RGBAIntegerFormat,
  type Scene,
  ShaderMaterial,
  UnsignedIntType,
  type Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import lineFragment from '../../../shaders/meetings/meeting.frag?raw';
import lineVertex from '../../../shaders/meetings/meeting.vert?raw';
import partFragment from '../../../shaders/meetings/part.frag?raw';
import partVertex from '../../../shaders/meetings/part.vert?raw';
import type { Shaders } from '../shaders/hatchingShaders.js';
import type { IntersectingOutlines } from './IntersectingOutlines.js';
import type { NumberedPart } from './NumberedPart.js';
import { type DrawnOutlines, type LineDrawer, SCREEN_VERTICES } from './ScreenLines.js';

/** What the map of parts holds where there is none. */
const NOTHING = /* @__PURE__ */ new Uint32Array(4);
const MAIN = 'void main() {';

/** A shader without its main function, which is its last. */
const functionsOf = (shader: string): string => shader.slice(0, shader.lastIndexOf(MAIN));

/** The shaders of the map of parts. */
export const partShaders = (): Shaders => ({ vertexShader: partVertex, fragmentShader: partFragment });

/** The shaders of lines between parts, with the functions of outlines. */
export const lineShaders = ({ vertexShader, fragmentShader }: Shaders): Shaders => ({
  vertexShader: functionsOf(vertexShader) + lineVertex,
  fragmentShader: functionsOf(fragmentShader) + lineFragment,
});

/** Draws a part into the map of parts. A material for each part, since three.js would look for another program wherever kinds of meshes alternate. */
class PartMaterial extends ShaderMaterial {
  constructor() {
    super({
      name: 'HatchingPart',
      uniforms: { partNumber: { value: 0 }, partLook: { value: 0 } },
      ...partShaders(),
      glslVersion: GLSL3,
      blending: NoBlending,
      clipping: true,
    });
  }

  take(number: number, look: number, surface: Material): void {
    const { partNumber, partLook } = this.uniforms;
    if (partNumber.value !== number) partNumber.value = number;
    if (partLook.value !== look) partLook.value = look;
    this.side = surface.side ?? FrontSide;
    this.clippingPlanes = surface.clippingPlanes;
    this.clipIntersection = surface.clipIntersection;
  }
}

/** Draws the lines of one outline material from the map of parts. */
class LineMaterial extends ShaderMaterial {
  private readonly sourceVersion: number;

  constructor(
    private readonly source: ShaderMaterial,
    map: WebGLRenderTarget,
  ) {
    super({
      name: 'HatchingMovingLines',
      uniforms: { ...source.uniforms, partMap: { value: map.texture }, partLook: { value: 0 } },
      defines: 'PAPER_GRAIN' in source.defines ? { PAPER_GRAIN: '' } : {},
      ...lineShaders(source),
      lights: true,
      fog: source.fog,
      transparent: true,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    this.sourceVersion = source.version;
  }

  /** Whether the outline material has been compiled anew since. */
  isStale(): boolean {
    return this.source.version !== this.sourceVersion;
  }
}

/** Draws lines between parts that move, with WebGLRenderer. */
class MovingLines implements LineDrawer {
  private map: WebGLRenderTarget | null = null;
  private readonly parts = new Map<IntersectingOutlines, PartMaterial>();
  private readonly lines = new Map<Material, LineMaterial>();

  constructor(private readonly renderer: WebGLRenderer) {}

  drawMap(parts: readonly NumberedPart[], { material }: DrawnOutlines, scene: Scene, camera: Camera): void {
    const { renderer } = this;
    const viewport = (material as ShaderMaterial).uniforms.viewport.value as Vector4;
    const target = renderer.getRenderTarget();
    const face = renderer.getActiveCubeFace();
    const level = renderer.getActiveMipmapLevel();
    const { viewport: own } = camera as Camera & { viewport?: Vector4 };
    renderer.setRenderTarget(this.mapOf(viewport.z, viewport.w));
    const { color, depth } = renderer.state.buffers;
    color.setMask(true);
    depth.setMask(true);
    const gl = renderer.getContext() as WebGL2RenderingContext;
    gl.clearBufferuiv(gl.COLOR, 0, NOTHING);
    renderer.clear(false, true, false);
    for (let i = 0; i < parts.length; i++) if (parts[i].look > 0) this.drawPart(parts[i], scene, camera);
    renderer.setRenderTarget(target, face, level);
    // Each camera of an ArrayCamera draws into its own part of the render target.
    if (own) renderer.state.viewport(own);
  }

  drawLines(outlines: DrawnOutlines, look: number, scene: Scene, camera: Camera): void {
    const material = this.lineMaterial(outlines.material as ShaderMaterial);
    material.uniforms.partLook.value = look;
    outlines.geometry.setDrawRange(0, SCREEN_VERTICES);
    this.renderer.renderBufferDirect(camera, scene, outlines.geometry, material, outlines, null!);
  }

  readonly free = (): void => {
    this.map?.dispose();
    this.map = null;
    for (const material of [...this.parts.values(), ...this.lines.values()]) material.dispose();
    this.parts.clear();
    this.lines.clear();
    this.renderer.domElement.removeEventListener('webglcontextlost', this.free);
  };

  private drawPart({ number, look, outlines }: NumberedPart, scene: Scene, camera: Camera): void {
    const mesh = outlines.mesh!;
    const surface = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
    const material = this.partMaterial(outlines);
    material.take(number, look, surface);
    mesh.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, mesh.matrixWorld);
    this.renderer.renderBufferDirect(camera, scene, mesh.geometry, material, mesh, null!);
  }

  private mapOf(width: number, height: number): WebGLRenderTarget {
    if (this.map) {
      this.map.setSize(width, height);
      return this.map;
    }
    this.map = new WebGLRenderTarget(width, height, {
      format: RGBAIntegerFormat,
      internalFormat: 'RGBA32UI',
      type: UnsignedIntType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      generateMipmaps: false,
    });
    this.renderer.domElement.addEventListener('webglcontextlost', this.free);
    return this.map;
  }

  private partMaterial(outlines: IntersectingOutlines): PartMaterial {
    let material = this.parts.get(outlines);
    if (!material) {
      material = new PartMaterial();
      this.parts.set(outlines, material);
    }
    return material;
  }

  private lineMaterial(source: ShaderMaterial): LineMaterial {
    let material = this.lines.get(source);
    if (material?.isStale()) {
      material.dispose();
      material = undefined;
    }
    if (!material) {
      material = new LineMaterial(source, this.map!);
      this.lines.set(source, material);
    }
    return material;
  }
}

/** Makes what draws lines with WebGLRenderer. */
export const makeDrawer = (renderer: WebGLRenderer): LineDrawer => new MovingLines(renderer);
