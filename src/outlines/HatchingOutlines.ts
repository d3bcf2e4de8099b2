import {
  Box3,
  BufferGeometry,
  type Camera,
  Frustum,
  type InstancedMesh,
  type Material,
  Matrix4,
  type Mesh,
  Object3D,
  type Scene,
  Sphere,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { type OutlineData, outlineDataOf } from '../geometry/OutlineData.js';
import { pulledVerticesOf } from '../geometry/pulledVerticesOf.js';
import { canDeform, deforms } from '../material/deformation/canDeform.js';
import { deformationOf } from '../material/deformation/deformationOf.js';
import type { EmphasisLook } from '../material/emphasis/emphasis.js';
import { FrameStamp } from '../material/FrameStamp.js';
import { tellOfRenderer } from '../material/tellOfRenderer.js';
import { describeObject } from '../mistakes/describeObject.js';
import { tell } from '../mistakes/tell.js';
import { ContourList } from './ContourList.js';
import { HatchingOutlineMaterial, type HatchingOutlineParameters } from './HatchingOutlineMaterial.js';
import { HiddenPass } from './HiddenPass.js';
import { InstanceList } from './InstanceList.js';
import { type SceneDepth, sceneDepthOf } from './SceneDepth.js';

/** What the camera of `frustumFrame` sees in that frame. */
const frustum = /* @__PURE__ */ new Frustum();
const frustumFrame = /* @__PURE__ */ new FrameStamp();
const matrix = /* @__PURE__ */ new Matrix4();
const sphere = /* @__PURE__ */ new Sphere();
const place = /* @__PURE__ */ new Vector3();
const drawnInto = /* @__PURE__ */ new Vector4();
/** A draw count for which three.js draws nothing. With 0 it would make a draw call, and read textures that do not exist. */
const NOTHING = -1;
/** The largest number of lists that are kept, one per camera: more than the six cameras of a CubeCamera and two eyes. */
const MAX_LISTS = 12;
/** The number of vertices that each primitive is drawn with. */
const VERTICES = 3;

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
export class HatchingOutlines extends Object3D {
  readonly isHatchingOutlines = true;
  /** @internal This is left out of the declarations, because three.js 0.170 declares an accessor and other versions a property. */
  override readonly type: string = 'HatchingOutlines';
  /**
   * Makes three.js draw the outlines as it draws a sprite: from triangles, in the order of transparent objects. A mesh would be
   * exported, would cast shadows, and would be found by code that looks for surfaces.
   *
   * @internal
   */
  readonly isSprite = true;
  /** True while instances are drawn; three.js reads it. @internal */
  isInstancedMesh = false;
  /** @internal */
  instanceMatrix: InstancedMesh['instanceMatrix'] | null = null;
  /** Instances have neither colours nor morph targets here; an override material asks for both. @internal */
  readonly instanceColor = null;
  /** @internal */
  readonly morphTexture = null;
  /** @internal */
  override count = 0;
  /** A geometry without attributes: vertices read their data from textures, and other materials draw nothing. @internal */
  readonly geometry = new BufferGeometry();
  material: HatchingOutlineMaterial;

  private ownMesh: Mesh | null;
  private ownsMaterial: boolean;
  /** The list of each camera. */
  private readonly lists = new Map<Camera, ContourList | InstanceList>();
  /** What has copied the depth of the scene for these outlines. */
  private readonly depths = new Set<SceneDepth>();
  private hasReported = false;
  private hiddenPass: HiddenPass | null = null;

  /**
   * @param mesh the mesh whose outlines are drawn. Default: the parent, if that is a mesh.
   * @param look a material, or the parameters of a new one. A material that you pass is not disposed of with the outlines.
   */
  constructor(
    mesh: Mesh | null | undefined = undefined,
    look: HatchingOutlineMaterial | HatchingOutlineParameters = {},
  ) {
    super();
    this.ownMesh = mesh ?? null;
    this.ownsMaterial = !(look instanceof HatchingOutlineMaterial);
    this.material = look instanceof HatchingOutlineMaterial ? look : new HatchingOutlineMaterial(look);
    this.frustumCulled = false;
    this.geometry.boundingBox = new Box3();
    this.geometry.boundingSphere = new Sphere(new Vector3(), -1);
  }

  /** The mesh whose outlines are drawn: the one that was set, or else the parent, if that is a mesh. */
  get mesh(): Mesh | null {
    if (this.ownMesh) return this.ownMesh;
    return this.parent !== null && 'isMesh' in this.parent ? (this.parent as Mesh) : null;
  }

  set mesh(mesh: Mesh | null) {
    this.ownMesh = mesh;
  }

  override copy(source: this, recursive?: boolean): this {
    super.copy(source, recursive);
    if (this.ownsMaterial) this.material.dispose();
    this.material = source.material;
    this.ownsMaterial = false;
    // A clone of the mesh draws its own outlines.
    this.ownMesh = source.ownMesh === source.parent ? null : source.ownMesh;
    return this;
  }

  /** Does nothing: rays do not hit outlines. */
  override raycast(): void {}

  /** Writes an empty object instead of the outlines: loaders do not know them, and they can be made again from the geometry. */
  override toJSON(meta?: Parameters<Object3D['toJSON']>[0]): ReturnType<Object3D['toJSON']> {
    const empty = new Object3D().copy(this);
    empty.uuid = this.uuid;
    return empty.toJSON(meta);
  }

  /** Frees the GPU memory of the outlines and of their own material. The data of the geometry is freed with the geometry. */
  override dispose(): void {
    // In older versions of three.js, Object3D has no dispose().
    super.dispose?.();
    this.geometry.dispose();
    if (this.ownsMaterial) this.material.dispose();
    this.hiddenPass?.dispose();
    for (const list of this.lists.values()) list.dispose();
    this.lists.clear();
    for (const depth of this.depths) depth.dispose();
    this.depths.clear();
  }

  /**
   * three.js sorts sprites by their position and meshes by the centre of their bounding sphere. Between draws the outlines are placed
   * at that centre, so that outlines on a transparent surface are drawn right after it.
   */
  override updateMatrixWorld(force?: boolean): void {
    super.updateMatrixWorld(force);
    this.moveToCentre();
  }

  override updateWorldMatrix(updateParents: boolean, updateChildren: boolean): void {
    super.updateWorldMatrix(updateParents, updateChildren);
    this.moveToCentre();
  }

  private moveToCentre(): void {
    const mesh = this.mesh;
    if (!mesh) return;
    this.matrixWorld.copy(mesh.matrixWorld);
    const bounds = boundsOf(mesh);
    if (!bounds) return;
    // These are exactly the steps of the renderer, so that both compute the same number.
    place.copy(bounds.center).applyMatrix4(mesh.matrixWorld);
    this.matrixWorld.setPosition(place);
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
    const list = isDeformed ? null : this.listFor(camera, data, mesh);
    const { uniforms } = this.material;
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

  private report(mesh: Mesh, problem: string): void {
    if (this.hasReported) return;
    this.hasReported = true;
    tell(`HatchingOutlines: the ${describeObject(mesh)} ${problem}`, 'error');
  }

  /** Has three.js see the instances of the mesh until the end of the draw, since they choose another program. @internal */
  showInstances(): void {
    const { mesh } = this;
    if (!mesh || !('isInstancedMesh' in mesh)) return;
    const { instanceMatrix, count } = mesh as InstancedMesh;
    this.isInstancedMesh = true;
    this.instanceMatrix = instanceMatrix;
    this.count = count;
  }

  /** Ends what `showInstances` began. @internal */
  hideInstances(): void {
    this.isInstancedMesh = false;
    this.instanceMatrix = null;
  }

  /** Updates the pre-pass of a mesh that deforms. Returns whether there is one. */
  private bindDeformation(renderer: WebGLRenderer, camera: Camera, mesh: Mesh): boolean {
    const { geometry } = mesh;
    if (!deforms(geometry, mesh) || geometry.userData.hatching.layout === 'corner') return false;
    if (!canDeform(renderer, mesh)) {
      this.report(
        mesh,
        'has its outlines as at rest: this device cannot draw into float textures, or its instances have morph targets each of their own.',
      );
      return false;
    }
    const vertices = pulledVerticesOf(geometry) ?? null;
    const deformation = deformationOf(renderer, camera, mesh, geometry, vertices, this.material);
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
    const eye = uniforms.eye.value as Vector4;
    matrix.copy(mesh.matrixWorld).invert();
    // Virtual reality has cameras of its own classes, so the projection decides: its last row ends in 1 if it is orthographic.
    if (camera.projectionMatrix.elements[15] === 1) {
      place.setFromMatrixColumn(camera.matrixWorld, 2).transformDirection(matrix);
      eye.set(place.x, place.y, place.z, 0);
    } else {
      place.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(matrix);
      eye.set(place.x, place.y, place.z, 1);
    }
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

  private listFor(camera: Camera, data: OutlineData, mesh: Mesh): ContourList | InstanceList | null {
    // Suggestive contours may lie anywhere on surfaces that face the eye.
    if (this.material.suggestiveContours > 0) return null;
    const { boundingSphere } = mesh.geometry;
    if (!boundingSphere) return null;
    const eye = this.material.uniforms.eye.value as Vector4;
    const known = this.lists.get(camera);
    if (this.isInstancedMesh) {
      const list = known instanceof InstanceList ? known : this.addList(camera, new InstanceList());
      return list.update(data, mesh as InstancedMesh, eye) ? list : null;
    }
    const list = known instanceof ContourList ? known : this.addList(camera, new ContourList());
    return list.update(data, eye, boundingSphere) ? list : null;
  }

  /** Adds the list of a camera. If there are too many, the oldest one is removed, since its camera may be gone. */
  private addList<List extends ContourList | InstanceList>(camera: Camera, list: List): List {
    this.lists.get(camera)?.dispose();
    const [oldest] = this.lists;
    if (this.lists.size >= MAX_LISTS && !this.lists.has(camera)) {
      oldest[1].dispose();
      this.lists.delete(oldest[0]);
    }
    this.lists.set(camera, list);
    return list;
  }
}

/** How many times longer a matrix makes lengths, in the mean over directions; 1 if it flattens. `determinant()` would leave garbage in every frame. */
function meanScale({ elements: m }: Matrix4): number {
  const determinant =
    m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
  return Math.cbrt(Math.abs(determinant)) || 1;
}

/** What says how much weight the drawing of a mesh has where: its first hatching material. Its outlines have the same. */
function emphasisOf({ material }: Mesh): (Material & EmphasisLook) | null {
  const isHatching = (one: Material): boolean => 'isHatchingMaterial' in one;
  const found = Array.isArray(material) ? material.find(isHatching) : isHatching(material) && material;
  return found ? (found as Material & EmphasisLook) : null;
}

/** Whether the surface is not drawn, since no material of the mesh is visible: neither are its outlines then. */
const isUnseen = ({ material }: Mesh): boolean =>
  Array.isArray(material) ? !material.some((one) => one?.visible) : material?.visible === false;

/** The bounding sphere by which three.js sorts and culls a mesh; null before it has been computed. */
function boundsOf(mesh: Mesh): Sphere | null {
  const own = (mesh as Mesh & { boundingSphere?: Sphere | null }).boundingSphere;
  return (own === undefined ? mesh.geometry.boundingSphere : own) ?? null;
}

function isInFrustum(mesh: Mesh, renderer: WebGLRenderer, camera: Camera): boolean {
  const bounds = boundsOf(mesh);
  if (!bounds) return true;
  if (!frustumFrame.isOf(renderer, camera)) {
    frustumFrame.note(renderer, camera);
    matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const { coordinateSystem, reversedDepth } = camera as Camera & { reversedDepth?: boolean };
    frustum.setFromProjectionMatrix(matrix, coordinateSystem, reversedDepth);
  }
  return frustum.intersectsSphere(sphere.copy(bounds).applyMatrix4(mesh.matrixWorld));
}
