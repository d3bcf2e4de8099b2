import {
  type Camera,
  FrontSide,
  Frustum,
  GLSL3,
  type Material,
  Matrix4,
  type Mesh,
  NearestFilter,
  NoBlending,
  type Object3D,
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
import { FrameStamp } from '../FrameStamp.js';
import type { Shaders } from '../shaders/hatchingShaders.js';
import type { IntersectingOutlines } from './IntersectingOutlines.js';
import { type NumberedPart, numberParts } from './NumberedPart.js';

/** Outlines of WebGLRenderer. */
export type DrawnOutlines = IntersectingOutlines & Object3D & { readonly geometry: Mesh['geometry'] };

/** Frames after which a map of parts is freed, if nothing has moved. */
const KEPT_FRAMES = 60;
/** What the map of parts holds where there is none. */
const NOTHING = /* @__PURE__ */ new Uint32Array(4);
/** Vertices of the triangle that covers the screen. */
const SCREEN_VERTICES = 3;
const MAIN = 'void main() {';

const frustum = /* @__PURE__ */ new Frustum();
const matrix = /* @__PURE__ */ new Matrix4();

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

/** The lines on the screen of one renderer, from a map that holds the part and the plane that each pixel shows. */
class MovingLines {
  private map: WebGLRenderTarget | null = null;
  private readonly frame = new FrameStamp();
  private isMapped = false;
  private lastMoved = 0;
  private readonly parts = new Map<IntersectingOutlines, PartMaterial>();
  private readonly lines = new Map<Material, LineMaterial>();
  /** The outline materials of the frame, and which of them have been drawn. */
  private readonly looks: Material[] = [];
  private readonly isDrawn: boolean[] = [];

  constructor(private readonly renderer: WebGLRenderer) {}

  /** Draws the lines of the material of outlines, once for each camera in a frame. Allocates nothing while the same parts move. */
  draw(outlines: DrawnOutlines, parts: readonly NumberedPart[], root: Object3D, scene: Scene, camera: Camera): void {
    const { renderer } = this;
    if (!this.frame.isOf(renderer, camera)) {
      this.frame.note(renderer, camera);
      this.isMapped = this.update(outlines, parts, root, scene, camera);
    }
    const look = this.isMapped ? this.looks.indexOf(outlines.material) : -1;
    if (look < 0 || this.isDrawn[look]) return;
    this.isDrawn[look] = true;
    const material = this.lineMaterial(outlines.material as ShaderMaterial);
    material.uniforms.partLook.value = look + 1;
    outlines.geometry.setDrawRange(0, SCREEN_VERTICES);
    renderer.renderBufferDirect(camera, scene, outlines.geometry, material, outlines, null!);
  }

  /** Frees the map and the materials; a later frame makes new ones. */
  private readonly free = (): void => {
    this.map?.dispose();
    this.map = null;
    for (const material of [...this.parts.values(), ...this.lines.values()]) material.dispose();
    this.parts.clear();
    this.lines.clear();
    this.renderer.domElement.removeEventListener('webglcontextlost', this.free);
  };

  /** Draws the map, if parts have moved against each other. Returns whether they have. */
  private update(
    { material }: DrawnOutlines,
    parts: readonly NumberedPart[],
    root: Object3D,
    scene: Scene,
    camera: Camera,
  ): boolean {
    const { renderer } = this;
    if (renderer.xr.isPresenting) return false;
    const { frame } = renderer.info.render;
    if (numberParts(parts, root) < 2) {
      if (this.map && frame > this.lastMoved + KEPT_FRAMES) this.free();
      return false;
    }
    this.lastMoved = frame;
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
    this.drawParts(parts, scene, camera);
    renderer.setRenderTarget(target, face, level);
    // Each camera of an ArrayCamera draws into its own part of the render target.
    if (own) renderer.state.viewport(own);
    return true;
  }

  private drawParts(parts: readonly NumberedPart[], scene: Scene, camera: Camera): void {
    this.looks.length = this.isDrawn.length = 0;
    matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const { coordinateSystem, reversedDepth } = camera as Camera & { reversedDepth?: boolean };
    frustum.setFromProjectionMatrix(matrix, coordinateSystem, reversedDepth);
    for (let i = 0; i < parts.length; i++) {
      const { number, outlines } = parts[i];
      const mesh = outlines.mesh!;
      // What lies outside may not be on the card.
      if (number === 0 || !mesh.layers.test(camera.layers) || !frustum.intersectsObject(mesh)) continue;
      const surface = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
      const material = this.partMaterial(outlines);
      material.take(number, this.lookOf(outlines.material), surface);
      mesh.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, mesh.matrixWorld);
      this.renderer.renderBufferDirect(camera, scene, mesh.geometry, material, mesh, null!);
    }
  }

  /** The number of an outline material in this frame, from 1. */
  private lookOf(material: Material): number {
    const known = this.looks.indexOf(material);
    if (known >= 0) return known + 1;
    this.isDrawn.push(false);
    return this.looks.push(material);
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

const all = new WeakMap<WebGLRenderer, MovingLines>();

/**
 * Draws, over what outlines have drawn, the lines where parts of a scene meet that move against each other, are instances or deform.
 *
 * @param root the scene of the parts
 */
export function drawMovingLines(
  outlines: DrawnOutlines,
  parts: readonly NumberedPart[],
  root: Object3D,
  renderer: WebGLRenderer,
  scene: Scene,
  camera: Camera,
): void {
  let lines = all.get(renderer);
  if (!lines) {
    lines = new MovingLines(renderer);
    all.set(renderer, lines);
  }
  lines.draw(outlines, parts, root, scene, camera);
}
