import {
  type Camera,
  DoubleSide,
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
import clearVertex from '../../../shaders/meetings/clear.vert?raw';
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

/** The shaders of lines on parts that are seen through. */
export const clearShaders = ({ vertexShader, fragmentShader }: Shaders): Shaders => ({
  vertexShader: functionsOf(vertexShader) + clearVertex,
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
    isClear = false,
  ) {
    super({
      name: 'HatchingMovingLines',
      uniforms: {
        ...source.uniforms,
        ...{ partMap: { value: map.texture }, partLook: { value: 0 }, partNumber: { value: 0 } },
        // The outlines of what is seen through may be paler.
        opacity: { value: 1 },
      },
      defines: { ...('PAPER_GRAIN' in source.defines && { PAPER_GRAIN: '' }), ...(isClear && { CLEAR: '' }) },
      ...(isClear ? clearShaders(source) : lineShaders(source)),
      side: DoubleSide,
      clipping: isClear,
      lights: true,
      fog: source.fog,
      transparent: true,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    this.sourceVersion = source.version;
  }

  /** Whether it draws as another outline material does, or its own has been compiled anew since. */
  isStaleFor(source: ShaderMaterial): boolean {
    return this.source !== source || source.version !== this.sourceVersion;
  }

  /** Sets what it draws. @param name of a uniform with a number */
  take(name: 'partLook' | 'partNumber', number: number): void {
    const { uniforms, source } = this;
    if (uniforms[name].value !== number) uniforms[name].value = number;
    if (uniforms.opacity.value !== source.opacity) uniforms.opacity.value = source.opacity;
  }
}

/** Draws lines between parts that move, with WebGLRenderer. */
class MovingLines implements LineDrawer {
  private map: WebGLRenderTarget | null = null;
  private readonly parts = new Map<IntersectingOutlines, PartMaterial>();
  private readonly lines = new Map<Material, LineMaterial>();
  /** Of the parts that are seen through. */
  private readonly clear = new Map<IntersectingOutlines, LineMaterial>();

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
    for (let i = 0; i < parts.length; i++) {
      if (parts[i].look > 0 && !parts[i].isClear) this.drawPart(parts[i], scene, camera);
    }
    renderer.setRenderTarget(target, face, level);
    // Each camera of an ArrayCamera draws into its own part of the render target.
    if (own) renderer.state.viewport(own);
  }

  drawLines(outlines: DrawnOutlines, look: number, scene: Scene, camera: Camera): void {
    const source = outlines.material as ShaderMaterial;
    const material = this.lineMaterial(this.lines, source, source, false);
    material.take('partLook', look);
    outlines.geometry.setDrawRange(0, SCREEN_VERTICES);
    this.renderer.renderBufferDirect(camera, scene, outlines.geometry, material, outlines, null!);
  }

  drawClear({ number }: NumberedPart, outlines: DrawnOutlines, scene: Scene, camera: Camera): void {
    const mesh = outlines.mesh!;
    const material = this.lineMaterial(this.clear, outlines, outlines.material as ShaderMaterial, true);
    const surface = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
    material.take('partNumber', number);
    material.clippingPlanes = surface.clippingPlanes;
    material.clipIntersection = surface.clipIntersection;
    mesh.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, mesh.matrixWorld);
    this.renderer.renderBufferDirect(camera, scene, mesh.geometry, material, mesh, null!);
  }

  readonly free = (): void => {
    this.map?.dispose();
    this.map = null;
    for (const made of [this.parts, this.lines, this.clear]) {
      for (const material of made.values()) material.dispose();
      made.clear();
    }
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

  private lineMaterial<Key>(
    made: Map<Key, LineMaterial>,
    key: Key,
    source: ShaderMaterial,
    isClear: boolean,
  ): LineMaterial {
    let material = made.get(key);
    if (material?.isStaleFor(source)) {
      material.dispose();
      material = undefined;
    }
    if (!material) {
      material = new LineMaterial(source, this.map!, isClear);
      made.set(key, material);
    }
    return material;
  }
}

/** Makes what draws lines with WebGLRenderer. */
export const makeDrawer = (renderer: WebGLRenderer): LineDrawer => new MovingLines(renderer);
