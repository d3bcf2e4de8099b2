import { type Camera, type Mesh, type Scene, Vector4, type WebGLRenderer } from 'three';
import { type OutlineData, outlineDataOf } from '../geometry/OutlineData.js';
import { hasFloatTargets } from '../material/deformation/canDeform.js';
import { glslDeformations } from '../material/deformation/glslDeformations.js';
import { tellOfRenderer } from '../material/tellOfRenderer.js';
import { HatchingOutlineMaterial, type HatchingOutlineParameters } from './HatchingOutlineMaterial.js';
import { HiddenPass } from './HiddenPass.js';
import { InstanceList } from './InstanceList.js';
import { emphasisOf, isInFrustum, isUnseen, MeshOutlines, meanScale, NOTHING, VERTICES } from './MeshOutlines.js';
import { type SceneDepth, sceneDepthOf } from './SceneDepth.js';

const drawnInto = /* @__PURE__ */ new Vector4();

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
  /** @internal This is left out of the declarations, because three.js 0.170 declares an accessor and other versions a property. */
  override readonly type: string = 'HatchingOutlines';

  /** What has copied the depth of the scene for these outlines. */
  private readonly depths = new Set<SceneDepth>();
  private hiddenPass: HiddenPass | null = null;

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

  override readonly onBeforeRender = (renderer: WebGLRenderer, _scene: Scene, camera: Camera): void => {
    const { geometry, mesh } = this;
    geometry.setDrawRange(0, NOTHING);
    // Helpers that light a scene step by step give every object another material for a moment.
    if (!mesh || !(this.material instanceof HatchingOutlineMaterial) || isUnseen(mesh)) return;
    if ('isWebGPURenderer' in renderer) {
      tellOfRenderer('HatchingOutlines');
      return;
    }
    this.matrixWorld.copy(mesh.matrixWorld);
    const data = outlineDataOf(mesh.geometry);
    if (!data) {
      this.report(
        mesh,
        'has no outlines to draw. Give it the result of await prepareHatchingGeometry(geometry, { outlines: true }).',
      );
      return;
    }
    if (mesh.frustumCulled && !isInFrustum(mesh, renderer, camera)) return;
    this.showInstances();
    const isDeformed = this.bindDeformation(renderer, camera, mesh);
    this.bindData(data);
    this.bindCamera(renderer, camera, mesh, isDeformed);
    const { suggestiveContours, uniforms } = this.material;
    // Suggestive contours may lie anywhere on surfaces that face the eye.
    const isAnywhere = isDeformed || suggestiveContours > 0;
    const list = isAnywhere ? null : this.listFor(camera, data, mesh, uniforms.eye.value);
    if (list instanceof InstanceList) {
      // The list holds the instance of each primitive, so three.js draws a single instance.
      this.count = 1;
      uniforms.instancePlaces.value = list.places;
    }
    uniforms.isListed.value = list !== null;
    uniforms.candidates.value = list?.texture ?? data.primitives;
    geometry.setDrawRange(0, VERTICES * (list ? list.count : data.triangleCount + data.edgeCount));
  };

  override readonly onAfterRender = (renderer: WebGLRenderer, scene: Scene, camera: Camera): void => {
    this.drawHidden(renderer, scene, camera);
    this.hideInstances();
    this.moveToCentre();
  };

  /** Draws what is hidden of what has just been drawn. Lists leave out what cannot be seen, so it is looked for among all primitives. */
  private drawHidden(renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
    const { geometry, mesh, material } = this;
    const data = mesh && outlineDataOf(mesh.geometry);
    if (!data || geometry.drawRange.count <= 0 || (material.hidden ?? 'none') === 'none') return;
    this.showInstances();
    material.uniforms.isListed.value = false;
    material.uniforms.candidates.value = data.primitives;
    geometry.setDrawRange(0, VERTICES * (data.triangleCount + data.edgeCount));
    this.hiddenPass ??= new HiddenPass();
    this.hiddenPass.draw(this, renderer, scene, camera);
  }

  /** Updates the pre-pass of a mesh that deforms. Returns whether there is one. */
  private bindDeformation(renderer: WebGLRenderer, camera: Camera, mesh: Mesh): boolean {
    const deformation = this.deformationBy(glslDeformations, hasFloatTargets, renderer, camera, mesh);
    if (!deformation) return false;
    const { uniforms } = this.material;
    uniforms.deformedPositions.value = deformation.positions;
    uniforms.deformedNormals.value = deformation.normals;
    uniforms.deformedTurns.value = deformation.turns;
    return true;
  }

  private bindData({ points, primitives, radius }: OutlineData): void {
    const { uniforms } = this.material;
    uniforms.outlinePoints.value = points;
    uniforms.outlinePrimitives.value = primitives;
    // A number that is stored is allocated.
    if (uniforms.radius.value !== (radius || 1)) uniforms.radius.value = radius || 1;
  }

  private bindCamera(renderer: WebGLRenderer, camera: Camera, mesh: Mesh, isDeformed: boolean): void {
    const { uniforms } = this.material;
    this.writeEye(uniforms.eye.value as Vector4, camera, mesh);
    const objectScale = meanScale(mesh.matrixWorld);
    if (objectScale !== uniforms.objectScale.value) uniforms.objectScale.value = objectScale;
    // Each camera of an ArrayCamera draws into a part of the target.
    const { viewport } = camera as Camera & { viewport?: Vector4 };
    if (viewport) drawnInto.copy(viewport);
    else renderer.getCurrentViewport(drawnInto);
    this.material.writeDraw(renderer, camera, mesh, drawnInto, emphasisOf(mesh), isDeformed);
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
