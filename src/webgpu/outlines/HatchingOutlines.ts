import {
  type BufferGeometry,
  type Camera,
  ColorManagement,
  type InstancedMesh,
  type Material,
  type Mesh,
  type RenderTarget,
  type Scene,
  SRGBTransfer,
  Vector2,
  Vector4,
  type WebGLRenderer,
} from 'three';
import type { WebGPURenderer } from 'three/webgpu';
import { warn } from '../../material/diagnostics/warn.js';
import type { HatchingOutlineParameters } from '../../material/outlines/HatchingOutlineMaterial.js';
import { drawMovingLines, type FetchMoving } from '../../material/outlines/loadIntersections.js';
import { fadingLookOf, MeshOutlines, meanScale, NO_PARTS } from '../../material/outlines/MeshOutlines.js';
import type { OutlinePart } from '../../material/outlines/OutlineParts.js';
import { isCutOut, isDrawnBefore, showsBack } from '../../material/outlines/surfaceRules.js';
import { clippingOf } from './clippingOf.js';
import { HatchingOutlineNodeMaterial } from './HatchingOutlineNodeMaterial.js';
import { placesOf } from './instancePlaces.js';
import { hasFloatTargets, nodeDeformations } from './NodePosePass.js';

const fetchMovingLines: FetchMoving = () => import('./NodeMovingLines.js');

const drawnInto = /* @__PURE__ */ new Vector4();
const size = /* @__PURE__ */ new Vector2();

let hasWarnedOfRenderer = false;

/**
 * Draws the contours, borders and creases of a mesh with WebGPURenderer, as the class of the same name does with WebGLRenderer. Add it to
 * the mesh as a child. The geometry of the mesh must come from `prepareHatchingGeometry(geometry, { outlines: true })`.
 *
 *     mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { outlines: true });
 *     mesh.add(new HatchingOutlines(mesh, { outlineWidth: 2 }));
 *
 * The outlines follow skins, morph targets and instances, and are hidden where the surface hides them. They cast no shadow, are left
 * out of raycasts, bounding boxes and exporters, and draw nothing while the mesh has a geometry that was not prepared.
 */
export class HatchingOutlines extends MeshOutlines<HatchingOutlineNodeMaterial> {
  readonly isHatchingOutlines = true;
  /** @internal */
  override readonly type: string = 'HatchingOutlines';

  /** Whether three.js is drawing these outlines an additional time. */
  private isDrawingMore = false;
  /** The parts that are drawn. */
  private drawn: readonly OutlinePart[] = NO_PARTS;
  private isDeformed = false;

  /**
   * @param mesh the mesh whose outlines are drawn. Default: the parent, if that is a mesh.
   * @param look a material, or the parameters of a new one. A material that you pass is not disposed of with the outlines.
   */
  constructor(
    mesh: Mesh | null | undefined = undefined,
    look: HatchingOutlineNodeMaterial | HatchingOutlineParameters = {},
  ) {
    super(mesh, look, HatchingOutlineNodeMaterial);
  }

  override readonly onBeforeRender = (
    either: WebGLRenderer | WebGPURenderer,
    scene: Scene,
    camera: Camera,
    _geometry?: BufferGeometry,
    drawnWith: Material = this.material,
  ): void => {
    if (this.isDrawingMore) return;
    const { mesh } = this;
    this.setCount(0);
    this.drawn = NO_PARTS;
    // Progressive light map helpers replace the material of every object for a moment, and a scene may override it.
    if (!mesh || !(this.material instanceof HatchingOutlineNodeMaterial)) return;
    if (!('isHatchingOutlineNodeMaterial' in drawnWith)) return;
    const parts = this.visibleParts(either, scene, camera, isSupported);
    if (parts.length === 0) return;
    const renderer = either as WebGPURenderer;
    this.drawn = parts;
    this.isDeformed = this.bindDeformation(renderer, camera, mesh);
    this.bindPart(renderer, camera, mesh, parts[0]);
    readWhereDrawn(renderer);
  };

  override readonly onAfterRender = (either: WebGLRenderer | WebGPURenderer, scene: Scene, camera: Camera): void => {
    if (this.isDrawingMore) return;
    const { drawn, material, mesh } = this;
    const renderer = either as WebGPURenderer;
    for (let i = 0; i < drawn.length && mesh; i++) {
      if (i > 0) {
        this.bindPart(renderer, camera, mesh, drawn[i]);
        this.drawMore(renderer, scene, camera, material, `outlines ${i}`);
      }
      this.drawHidden(renderer, scene, camera, i);
      this.endSurface();
    }
    if (drawn.length > 0) drawMovingLines(this, renderer as unknown as WebGLRenderer, scene, camera, fetchMovingLines);
    this.drawn = NO_PARTS;
    this.moveToCentre();
  };

  /**
   * Draws a triangle that covers the screen, unclipped.
   *
   * @param material one that draws something else with the look of these outlines
   * @internal
   */
  drawOnScreen(
    renderer: WebGPURenderer,
    scene: Scene,
    camera: Camera,
    material: HatchingOutlineNodeMaterial,
    pass: string,
  ): void {
    this.count = 1;
    this.setCount(1);
    this.drawMore(renderer, scene, camera, material, pass, null);
  }

  /** Binds a part of the outlines for the next draw. */
  private bindPart(renderer: WebGPURenderer, camera: Camera, mesh: Mesh, part: OutlinePart): void {
    const { data, surface } = part;
    const { uniforms, weights } = this.material;
    this.beginSurface(surface);
    uniforms.outlinePoints.value = data.points;
    uniforms.outlinePrimitives.value = data.primitives;
    uniforms.isCutOut.value = isCutOut(surface);
    uniforms.showsBack.value = showsBack(surface);
    uniforms.radius.value = data.radius || 1;
    this.writeEye(uniforms.eye.value, camera, mesh);
    uniforms.objectScale.value = meanScale(mesh.matrixWorld);
    writeViewport(renderer, drawnInto);
    this.material.writeDraw(renderer, camera, mesh, drawnInto, fadingLookOf(mesh), isEncodedLater(renderer));
    // Suggestive contours may lie anywhere on surfaces that face the eye.
    const isAnywhere = this.isDeformed || weights.suggestiveContours > 0;
    const list = isAnywhere ? null : this.listFor(camera, part, mesh, uniforms.eye.value);
    uniforms.isListed.value = list !== null;
    uniforms.candidates.value = list?.texture ?? null;
    this.bindInstances(mesh, list !== null);
    this.setCount(list ? list.count : data.triangleCount + data.edgeCount);
  }

  /** Draws the hidden outlines of the part that was just drawn, from all primitives: lists omit invisible ones. */
  private drawHidden(renderer: WebGPURenderer, scene: Scene, camera: Camera, number: number): void {
    const { geometry, mesh, material } = this;
    const { data } = this.drawn[number];
    if (geometry.drawRange.count <= 0 || material.hidden === 'none' || isDrawnBefore(material)) return;
    material.uniforms.isListed.value = false;
    material.uniforms.candidates.value = null;
    this.bindInstances(mesh!, false);
    this.setCount(data.triangleCount + data.edgeCount);
    this.drawMore(renderer, scene, camera, material.ofHidden(), `hiddenOutlines ${number}`);
  }

  /** Makes three.js draw these outlines once more. @param pass name of the draw: each has uniforms of its own */
  private drawMore(
    renderer: WebGPURenderer,
    scene: Scene,
    camera: Camera,
    material: HatchingOutlineNodeMaterial,
    pass: string,
    clipping = clippingOf(this, renderer),
  ): void {
    this.isDrawingMore = true;
    const lights = renderer.lighting.getNode(scene);
    renderer.renderObject(this, scene, camera, this.geometry, material, null, lights, clipping, pass);
    this.isDrawingMore = false;
  }

  /** Updates the pose of a mesh that deforms. Returns whether there is one. */
  private bindDeformation(renderer: WebGPURenderer, camera: Camera, mesh: Mesh): boolean {
    const { uniforms } = this.material;
    const deformation = this.deformationBy(nodeDeformations, hasFloatTargets, renderer, camera, mesh);
    const isDeformed = deformation !== null;
    uniforms.isDeformed.value = isDeformed;
    uniforms.deformedPositions.value = isDeformed ? deformation.target.textures[0] : null;
    uniforms.deformedTurns.value = isDeformed ? deformation.target.textures[1] : null;
    return isDeformed;
  }

  private bindInstances(mesh: Mesh, isListed: boolean): void {
    const { uniforms } = this.material;
    const isInstanced = 'isInstancedMesh' in mesh;
    uniforms.isInstanced.value = isInstanced;
    // In a list each primitive has its own instance.
    this.count = isInstanced && !isListed ? (mesh as InstancedMesh).count : 1;
    if (!isInstanced) return;
    uniforms.instancePlaces.value = placesOf(mesh as InstancedMesh);
  }
}

/** Writes the drawn part of the target, in pixels from the lower left: WebGPURenderer counts from the upper left. */
function writeViewport(renderer: WebGPURenderer, viewport: Vector4): void {
  const target = renderer.getRenderTarget();
  if (target) {
    viewport.copy(target.viewport);
    size.set(target.width, target.height);
  } else {
    renderer.getViewport(viewport).multiplyScalar(renderer.getPixelRatio());
    renderer.getDrawingBufferSize(size);
  }
  viewport.floor();
  viewport.y = size.y - viewport.y - viewport.w;
}

/** Whether three.js blends linear light and encodes it for a canvas at the end. */
function isEncodedLater(renderer: WebGPURenderer): boolean {
  const target = renderer.getRenderTarget() as (RenderTarget & { isPostProcessingRenderTarget?: boolean }) | null;
  if (!target?.isPostProcessingRenderTarget) return false;
  return ColorManagement.getTransfer(renderer.outputColorSpace) === SRGBTransfer;
}

/** Whether a renderer is WebGPURenderer. Warns once of another. */
function isSupported(renderer: object): boolean {
  if ('isWebGPURenderer' in renderer) return true;
  if (hasWarnedOfRenderer) return false;
  hasWarnedOfRenderer = true;
  warn(
    "HatchingOutlines of 'three-hatching/webgpu' are drawn by WebGPURenderer alone. Under WebGLRenderer take those of 'three-hatching'.",
    'error',
  );
  return false;
}

/**
 * Binds the render target for reading under WebGL. three.js copies the scene's depth from the framebuffer bound for reading, which is the
 * canvas after an application has read pixels of the same target (seen in 0.187).
 */
function readWhereDrawn(renderer: WebGPURenderer): void {
  if (!('isWebGLBackend' in renderer.backend)) return;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const drawn: WebGLFramebuffer | null = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING);
  if (gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) !== drawn) gl.bindFramebuffer(gl.READ_FRAMEBUFFER, drawn);
}
