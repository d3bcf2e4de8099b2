import {
  Box3,
  type Camera,
  Frustum,
  type InstancedMesh,
  Layers,
  type Material,
  Matrix4,
  type Mesh,
  Object3D,
  Sphere,
  Vector3,
  type Vector4,
  type WebGLRenderer,
} from 'three';
import { deforms, morphsEachInstance } from '../deformation/canDeform.js';
import type { Deformation } from '../deformation/Deformation.js';
import type { Deformations } from '../deformation/Deformations.js';
import { describeObject } from '../diagnostics/describeObject.js';
import { warn } from '../diagnostics/warn.js';
import { FrameStamp } from '../FrameStamp.js';
import type { FadingLook } from '../fading/fading.js';
import { outlineDataOf } from '../geometry/OutlineData.js';
import { pulledVerticesOf } from '../geometry/pulledVerticesOf.js';
import { NO_VERTICES, SpriteLike } from '../three/posing.js';
import type { ContourList } from './ContourList.js';
import type { InstanceList } from './InstanceList.js';
import { fetchedLists } from './laterLists.js';
import { drawnParts, forgetIntersections } from './loadIntersections.js';
import { type OutlinePart, OutlineParts, unlistedPart } from './OutlineParts.js';
import { copyDrawState, type DrawState, isScaledToNothing, takeDrawState } from './surfaceRules.js';

/** The layers of outlines: those of their mesh, at any time, unless the outlines have been given layers of their own. */
class MeshLayers extends Layers {
  declare mask: number;
  /** The layers that were set on the outlines themselves; null while they follow the mesh. */
  private own: number | null = null;

  constructor(private readonly outlines: { readonly mesh: Mesh | null }) {
    super();
    const standard = this.mask;
    const followed = (): number => this.outlines.mesh?.layers.mask ?? standard;
    Object.defineProperty(this, 'mask', {
      get: () => this.own ?? followed(),
      set: (mask: number) => {
        // Code that moves all objects of a scene to a layer moves the mesh too.
        this.own = mask === followed() ? null : mask;
      },
      enumerable: true,
    });
  }

  /** Copies whether the layers follow a mesh, or are the outlines' own. */
  copy(source: MeshLayers): void {
    this.own = source.own;
  }
}

/** The frustum of the camera in `frustumFrame`. */
const frustum = /* @__PURE__ */ new Frustum();
const frustumFrame = /* @__PURE__ */ new FrameStamp();
const matrix = /* @__PURE__ */ new Matrix4();
const sphere = /* @__PURE__ */ new Sphere();
const place = /* @__PURE__ */ new Vector3();
/** The parts of outlines that are not drawn. */
export const NO_PARTS: readonly OutlinePart[] = [];
/** Vertices per primitive. */
const VERTICES = 3;

/**
 * The object that draws the outlines of a mesh, with a material for any renderer: its place in the scene, and the search for primitives
 * that may hold an outline.
 */
export abstract class MeshOutlines<Look extends Material = Material> extends SpriteLike {
  material: Look;

  private ownMesh: Mesh | null;
  private ownsMaterial: boolean;
  private readonly parts = new OutlineParts();
  /** The `renderOrder` that was set on the outlines themselves; null while they follow the mesh. */
  private ownOrder: number | null = null;
  /** The draw state of the material before it took over that of a surface. */
  private readonly ownState: Partial<DrawState> = {};
  private hasTaken = false;
  private hasReported = false;

  /** @param look a material, or the parameters of a new one of this kind */
  constructor(mesh: Mesh | null | undefined, look: Look | object, Kind: new (parameters: object) => Look) {
    super();
    this.ownMesh = mesh ?? null;
    this.ownsMaterial = !(look instanceof Kind);
    this.material = look instanceof Kind ? look : new Kind(look);
    this.frustumCulled = false;
    this.layers = new MeshLayers(this);
    const followed = (): number => this.mesh?.renderOrder ?? 0;
    Object.defineProperty(this, 'renderOrder', {
      get: () => this.ownOrder ?? followed(),
      set: (order: number) => {
        this.ownOrder = order === followed() ? null : order;
      },
      enumerable: true,
    });
    this.geometry.boundingBox = new Box3();
    this.geometry.boundingSphere = new Sphere(new Vector3(), -1);
  }

  /** The mesh whose outlines are drawn: the one that was set, or else the parent, if it is a mesh. */
  get mesh(): Mesh | null {
    if (this.ownMesh) return this.ownMesh;
    return this.parent !== null && 'isMesh' in this.parent ? (this.parent as Mesh) : null;
  }

  set mesh(mesh: Mesh | null) {
    this.ownMesh = mesh;
  }

  override copy(source: this, recursive?: boolean): this {
    super.copy(source, recursive);
    (this.layers as MeshLayers).copy(source.layers as MeshLayers);
    this.ownOrder = source.ownOrder;
    if (this.ownsMaterial) this.material.dispose();
    this.material = source.material;
    this.ownsMaterial = false;
    // A clone of the mesh draws its own outlines.
    this.ownMesh = source.ownMesh === source.parent ? null : source.ownMesh;
    return this;
  }

  /** Does nothing: rays pass through outlines. */
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
    this.parts.dispose();
    forgetIntersections(this);
    if (this.ownsMaterial) this.material.dispose();
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

  protected moveToCentre(): void {
    const mesh = this.mesh;
    if (!mesh) return;
    this.matrixWorld.copy(mesh.matrixWorld);
    const bounds = boundsOf(mesh);
    if (!bounds) return;
    // These are exactly the renderer's own steps, so that both compute the same number.
    place.copy(bounds.center).applyMatrix4(mesh.matrixWorld);
    this.matrixWorld.setPosition(place);
  }

  /** Reports once that something is not drawn, or not as it should be. */
  protected report(mesh: Mesh, problem: string): void {
    if (this.hasReported) return;
    this.hasReported = true;
    warn(`HatchingOutlines: the ${describeObject(mesh)} ${problem}`, 'error');
  }

  /** Writes the position of the camera in the object space of the mesh. Allocates nothing. */
  protected writeEye(eye: Vector4, camera: Camera, mesh: Mesh): void {
    matrix.copy(mesh.matrixWorld).invert();
    // WebXR has camera classes of its own, so the projection decides: its last row ends in 1 if it is orthographic.
    if (camera.projectionMatrix.elements[15] === 1) {
      place.setFromMatrixColumn(camera.matrixWorld, 2).transformDirection(matrix);
      eye.set(place.x, place.y, place.z, 0);
    } else {
      place.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(matrix);
      eye.set(place.x, place.y, place.z, 1);
    }
  }

  /**
   * The deformed vertices of a mesh in its present pose; null if it does not deform, or if they cannot be computed, which is reported
   * once.
   *
   * @param hasFloatTargets whether the device can draw into float textures
   * @internal
   */
  protected deformationBy<Renderer extends { readonly domElement: EventTarget }>(
    deformations: Deformations<Renderer>,
    hasFloatTargets: (renderer: Renderer) => boolean,
    renderer: Renderer,
    camera: Camera,
    mesh: Mesh,
  ): Deformation | null {
    const { geometry } = mesh;
    if (!deforms(geometry, mesh) || geometry.userData.hatching.layout === 'corner') return null;
    if (!hasFloatTargets(renderer) || morphsEachInstance(mesh)) {
      this.report(
        mesh,
        'has its outlines in the rest pose: this device cannot draw into float textures, or its instances have morph targets of their own.',
      );
      return null;
    }
    return deformations.of(renderer, camera, mesh, geometry, pulledVerticesOf(geometry) ?? null, this.material);
  }

  /**
   * Whether three.js reaches the mesh when it draws the scene. For outlines elsewhere than below their mesh this does not follow from
   * their own visibility.
   */
  protected isMeshReached(scene: Object3D): boolean {
    const { mesh, parent } = this;
    if (mesh === null || isScaledToNothing(mesh.matrixWorld)) return false;
    if (parent === mesh) return true;
    let object: Object3D = mesh;
    for (;;) {
      if (!object.visible) return false;
      if (object === scene) return true;
      if (object.parent === null) return object === rootOf(this);
      object = object.parent;
    }
  }

  /**
   * The parts to draw, one after another, as the camera sees the scene; none if the mesh is not drawn. Places the outlines at the mesh.
   *
   * @param isSupported whether the renderer draws these outlines; it is asked only if there is something to draw
   * @internal
   */
  protected visibleParts<Renderer>(
    renderer: Renderer,
    scene: Object3D,
    camera: Camera,
    isSupported: (renderer: Renderer) => boolean,
  ): readonly OutlinePart[] {
    const { mesh } = this;
    if (!mesh || !this.isMeshReached(scene)) return NO_PARTS;
    const data = outlineDataOf(mesh.geometry);
    const parts = data ? this.parts.of(mesh, data) : NO_PARTS;
    if ((data && parts.length === 0) || !isSupported(renderer)) return NO_PARTS;
    this.matrixWorld.copy(mesh.matrixWorld);
    if (!data) {
      this.report(
        mesh,
        'has no outlines to draw. Give it the result of await prepareHatchingGeometry(geometry, { outlines: true }).',
      );
      return NO_PARTS;
    }
    // The test uses only what all renderers have.
    const isOutside = mesh.frustumCulled && !isInFrustum(mesh, renderer as WebGLRenderer, camera);
    if (isOutside) return NO_PARTS;
    return drawnParts(this, parts, unlistedPart);
  }

  /** Sets the number of primitives of the next draw. */
  protected setCount(primitives: number): void {
    this.geometry.setDrawRange(0, primitives > 0 ? VERTICES * primitives : NO_VERTICES);
  }

  /** Takes over the opacity and the tests of a surface, until `endSurface`. */
  protected beginSurface(surface: Material): void {
    this.endSurface();
    this.hasTaken = takeDrawState(this.material, surface, this.mesh?.geometry ?? null, this.ownState);
  }

  protected endSurface(): void {
    if (this.hasTaken) copyDrawState(this.ownState as DrawState, this.material);
    this.hasTaken = false;
  }

  /**
   * The list of primitives of a part that may hold an outline as the camera sees the mesh; null if it is not known.
   *
   * @param eye the position of the camera, in the space of the mesh
   * @internal
   */
  protected listFor(camera: Camera, part: OutlinePart, mesh: Mesh, eye: Vector4): ContourList | InstanceList | null {
    const { boundingSphere } = mesh.geometry;
    if (!boundingSphere || part.isNew) return null;
    const kinds = fetchedLists();
    if (!kinds) return null;
    const { data, lists } = part;
    if ('isInstancedMesh' in mesh) {
      const list = lists.of(camera, kinds.InstanceList);
      return list.update(data, mesh as InstancedMesh, eye) ? list : null;
    }
    const list = lists.of(camera, kinds.ContourList);
    return list.update(data, eye, boundingSphere) ? list : null;
  }
}

function rootOf(object: Object3D): Object3D {
  let root = object;
  while (root.parent !== null) root = root.parent;
  return root;
}

/**
 * The mean factor, over directions, by which a matrix lengthens vectors; 1 if it is singular. `determinant()` would leave garbage in
 * every frame.
 */
export function meanScale({ elements: m }: Matrix4): number {
  const determinant =
    m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
  return Math.cbrt(Math.abs(determinant)) || 1;
}

/** A separate function: an inner one would be allocated at every call. An array of materials may have empty places. */
const isHatching = (material: Material | null | undefined): boolean =>
  material !== null &&
  material !== undefined &&
  ('isHatchingMaterial' in material || 'isHatchingNodeMaterial' in material);

/** The first hatching material of a mesh, which decides where its lines and outlines fade. */
export function fadingLookOf({ material }: Mesh): (Material & FadingLook) | null {
  const found = Array.isArray(material) ? material.find(isHatching) : isHatching(material) && material;
  return found ? (found as Material & FadingLook) : null;
}

/** The bounding sphere by which three.js sorts and culls a mesh; null until it is computed. */
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
