import {
  type BufferGeometry,
  type Camera,
  GreaterDepth,
  LessEqualDepth,
  type Material,
  type Mesh,
  type Object3D,
  type Scene,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { deforms, hasFloatTargets } from '../deformation/canDeform.js';
import { fetchDeformations, fetchedDeformations } from '../deformation/laterDeformations.js';
import { warnOfRenderer } from '../diagnostics/warn.js';
import { forgetClipping } from '../three/clipping.js';
import { HatchingOutlineMaterial, type HatchingOutlineParameters } from './HatchingOutlineMaterial.js';
import { drawMovingLines } from './loadIntersections.js';
import { fadingLookOf, MeshOutlines, meanScale, NO_PARTS } from './MeshOutlines.js';
import type { OutlinePart } from './OutlineParts.js';
import { type SceneDepth, sceneDepthOf } from './SceneDepth.js';
import { copyDrawState, isClipped, isCutOut, isDrawnBefore, showsBack } from './surfaceRules.js';

/** An object that draws outlines. */
type Outlines = Object3D & { geometry: BufferGeometry; material: HatchingOutlineMaterial };

/** Draws hidden outlines with a second material, which shares the uniforms of the first and takes over its state. */
class HiddenPass {
  private material: HatchingOutlineMaterial | null = null;
  private source: HatchingOutlineMaterial | null = null;
  private version = -1;

  /** Draws the hidden parts of outlines, right after the visible ones. */
  draw(outlines: Outlines, renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
    const material = this.materialFor(outlines.material);
    copyDrawState(outlines.material, material);
    // If the depth of the scene is known, the fragment shader decides what is hidden.
    const isKnown: boolean = material.uniforms.hasSceneDepth.value;
    material.depthTest = !isKnown;
    material.depthFunc = isKnown ? LessEqualDepth : GreaterDepth;
    renderer.renderBufferDirect(camera, scene, outlines.geometry, material, outlines, null!);
  }

  dispose(): void {
    this.material?.dispose();
    this.material = null;
    this.source = null;
  }

  private materialFor(source: HatchingOutlineMaterial): HatchingOutlineMaterial {
    if (!this.material || this.source !== source) {
      this.material?.dispose();
      this.material = source.clone();
      this.material.uniforms = source.uniforms;
      this.source = source;
      this.version = -1;
    }
    const { material } = this;
    if (this.version !== source.version) {
      this.version = source.version;
      material.copy(source);
      material.depthWrite = false;
      material.defines = { ...source.defines, HIDDEN: '' };
      material.needsUpdate = true;
    }
    return material;
  }
}

const drawnInto = /* @__PURE__ */ new Vector4();

/** Whether a renderer is WebGLRenderer. Warns of another. */
function isSupported(renderer: object): boolean {
  const isOther = 'isWebGPURenderer' in renderer;
  if (isOther) warnOfRenderer('HatchingOutlines');
  return !isOther;
}

/** Whether the code for the outlines of a mesh is there. What is awaited with the bake may be missing where a geometry was baked elsewhere. */
function canBeDrawn(mesh: Mesh): boolean {
  if (!deforms(mesh.geometry, mesh) || fetchedDeformations()) return true;
  fetchDeformations().catch(() => {});
  return false;
}

/**
 * Draws the contours, borders and creases of a mesh. Add it to the mesh as a child. The geometry of the mesh must come from
 * `prepareHatchingGeometry(geometry, { outlines: true })`.
 *
 *     mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { outlines: true });
 *     mesh.add(new HatchingOutlines(mesh, { outlineWidth: 2 }));
 *
 * The outlines follow skins, morph targets and instances, and are hidden where the surface hides them. They cast no shadow, are left
 * out of raycasts, bounding boxes, exporters and passes with an override material, and draw nothing while the mesh has a geometry
 * that was not prepared.
 */
export class HatchingOutlines extends MeshOutlines<HatchingOutlineMaterial> {
  readonly isHatchingOutlines = true;
  /** @internal Left out of the declarations, because three.js 0.170 declares an accessor and other versions a property. */
  override readonly type: string = 'HatchingOutlines';

  /** The copies of the scene's depth that these outlines have used. */
  private readonly depths = new Set<SceneDepth>();
  private hiddenPass: HiddenPass | null = null;
  /** The parts that are being drawn. */
  private drawn: readonly OutlinePart[] = NO_PARTS;
  private isDeformed = false;

  /**
   * @param mesh the mesh whose outlines are drawn. Default: the parent, if that is a mesh.
   * @param look a material, or the parameters of a new one. A material that you pass is not disposed of with the outlines.
   */
  constructor(
    mesh: Mesh | null | undefined = undefined,
    look: HatchingOutlineMaterial | HatchingOutlineParameters = {},
  ) {
    super(mesh, look, HatchingOutlineMaterial);
  }

  override dispose(): void {
    super.dispose();
    this.hiddenPass?.dispose();
    for (const depth of this.depths) depth.dispose();
    this.depths.clear();
  }

  override readonly onBeforeRender = (
    renderer: WebGLRenderer,
    scene: Scene,
    camera: Camera,
    _geometry?: BufferGeometry,
    drawnWith: Material = this.material,
  ): void => {
    const { mesh } = this;
    this.setCount(0);
    this.drawn = NO_PARTS;
    // Helpers that light a scene step by step give every object another material for a moment, and a scene may have one override
    // material.
    if (!mesh || !(this.material instanceof HatchingOutlineMaterial) || !('isHatchingOutlineMaterial' in drawnWith))
      return;
    const parts = this.visibleParts(renderer, scene, camera, isSupported);
    if (parts.length === 0 || !canBeDrawn(mesh)) return;
    this.drawn = parts;
    this.showInstances();
    this.isDeformed = this.bindDeformation(renderer, camera, mesh);
    this.bindPart(renderer, camera, mesh, parts[0]);
  };

  override readonly onAfterRender = (renderer: WebGLRenderer, scene: Scene, camera: Camera): void => {
    const { drawn, geometry, material, mesh } = this;
    for (let i = 0; i < drawn.length && mesh; i++) {
      if (i > 0) {
        this.showInstances();
        this.bindPart(renderer, camera, mesh, drawn[i]);
        renderer.renderBufferDirect(camera, scene, geometry, material, this, null!);
      }
      this.drawHidden(renderer, scene, camera, drawn[i]);
      this.endSurface();
    }
    this.hideInstances();
    if (drawn.length > 0) drawMovingLines(this, renderer, scene, camera);
    this.drawn = NO_PARTS;
    this.moveToCentre();
  };

  /** Makes the next draw show one part of the outlines. */
  private bindPart(renderer: WebGLRenderer, camera: Camera, mesh: Mesh, part: OutlinePart): void {
    const { material } = this;
    const { uniforms, weights } = material;
    const { data, surface } = part;
    this.beginSurface(surface);
    if (isClipped(surface)) forgetClipping(renderer, material);
    uniforms.outlinePoints.value = data.points;
    uniforms.outlinePrimitives.value = data.primitives;
    uniforms.isCutOut.value = isCutOut(surface);
    uniforms.showsBack.value = showsBack(surface);
    // Storing a number allocates it, so an equal one is not stored.
    if (uniforms.radius.value !== (data.radius || 1)) uniforms.radius.value = data.radius || 1;
    this.bindCamera(renderer, camera, mesh);
    // Suggestive contours may be anywhere on surfaces that face the eye.
    const isAnywhere = this.isDeformed || weights.suggestiveContours > 0;
    const list = isAnywhere ? null : this.listFor(camera, part, mesh, uniforms.eye.value);
    if (list && 'places' in list) {
      // The list holds the instance of each primitive, so three.js draws a single instance.
      this.count = 1;
      uniforms.instancePlaces.value = list.places;
    }
    uniforms.isListed.value = list !== null;
    uniforms.candidates.value = list?.texture ?? data.primitives;
    this.setCount(list ? list.count : data.triangleCount + data.edgeCount);
  }

  /**
   * Draws the hidden outlines of a part that has just been drawn. All primitives are tested, because lists leave out those that cannot
   * be seen.
   */
  private drawHidden(renderer: WebGLRenderer, scene: Scene, camera: Camera, { data }: OutlinePart): void {
    const { geometry, material } = this;
    if (geometry.drawRange.count <= 0 || (material.hidden ?? 'none') === 'none' || isDrawnBefore(material)) return;
    this.showInstances();
    material.uniforms.isListed.value = false;
    material.uniforms.candidates.value = data.primitives;
    this.setCount(data.triangleCount + data.edgeCount);
    this.hiddenPass ??= new HiddenPass();
    this.hiddenPass.draw(this, renderer, scene, camera);
  }

  /** Updates the pre-pass of a deforming mesh. Returns whether there is one. */
  private bindDeformation(renderer: WebGLRenderer, camera: Camera, mesh: Mesh): boolean {
    const deformations = fetchedDeformations();
    const deformation = deformations && this.deformationBy(deformations, hasFloatTargets, renderer, camera, mesh);
    if (!deformation) return false;
    const { uniforms } = this.material;
    uniforms.deformedPositions.value = deformation.positions;
    uniforms.deformedNormals.value = deformation.normals;
    uniforms.deformedTurns.value = deformation.turns;
    return true;
  }

  private bindCamera(renderer: WebGLRenderer, camera: Camera, mesh: Mesh): void {
    const { uniforms } = this.material;
    this.writeEye(uniforms.eye.value as Vector4, camera, mesh);
    const objectScale = meanScale(mesh.matrixWorld);
    if (objectScale !== uniforms.objectScale.value) uniforms.objectScale.value = objectScale;
    // Each camera of an ArrayCamera draws into a part of the render target.
    const { viewport } = camera as Camera & { viewport?: Vector4 };
    if (viewport) drawnInto.copy(viewport);
    else renderer.getCurrentViewport(drawnInto);
    this.material.writeDraw(renderer, camera, mesh, drawnInto, fadingLookOf(mesh), this.isDeformed);
    this.bindSceneDepth(renderer, camera);
  }

  private bindSceneDepth(renderer: WebGLRenderer, camera: Camera): void {
    const { uniforms } = this.material;
    const depth = sceneDepthOf(renderer);
    this.depths.add(depth);
    uniforms.sceneDepth.value = depth.read(camera, uniforms.viewport.value as Vector4);
    uniforms.hasSceneDepth.value = uniforms.sceneDepth.value !== null;
  }
}
