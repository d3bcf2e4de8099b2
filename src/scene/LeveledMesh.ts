import {
  BufferAttribute,
  type BufferGeometry,
  type Camera,
  type Material,
  type Mesh,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { chooseLevel } from '../mesh/detail/chooseLevel.js';
import type { DetailLevel, DetailLevels } from '../mesh/detail/makeLevels.js';

/**
 * The levels of detail of one geometry, in one index buffer on the GPU, one after another over the same vertices. The geometry has that
 * index only while a level is drawn. To raycasts, clones, exporters and other code it is always the whole mesh.
 */
export class LeveledGeometry {
  readonly levels: readonly DetailLevel[];
  private readonly whole: BufferAttribute;
  private readonly all: BufferAttribute;

  /** @param detail the levels of the geometry, which must be indexed */
  constructor(
    readonly geometry: BufferGeometry,
    detail: DetailLevels,
  ) {
    this.levels = detail.levels;
    this.all = new BufferAttribute(detail.indices, 1);
    // The first level is the whole mesh: its memory is shared.
    this.whole = new BufferAttribute(detail.indices.subarray(0, detail.levels[0].count), 1);
    geometry.setIndex(this.whole);
    // This listener runs before three's own, which frees the index that the geometry has at that moment.
    geometry.addEventListener('dispose', () => {
      geometry.setIndex(this.all);
      queueMicrotask(() => this.showWhole());
    });
  }

  /** Whether the geometry is unchanged since the levels were made: other code may have set another index or draw range. */
  get isWhole(): boolean {
    const { index, drawRange } = this.geometry;
    return index === this.whole && drawRange.start === 0 && drawRange.count === Infinity;
  }

  /** Makes the next draws show a level. */
  show(level: number): void {
    const { start, count } = this.levels[level];
    this.geometry.setIndex(this.all);
    this.geometry.setDrawRange(start, count);
  }

  /** Ends what `show` began. */
  showWhole(): void {
    if (this.geometry.index !== this.all) return;
    this.geometry.setIndex(this.whole);
    this.geometry.setDrawRange(0, Infinity);
  }
}

const centre = /* @__PURE__ */ new Vector3();
const forward = /* @__PURE__ */ new Vector3();

/**
 * The number of pixels per unit of a mesh's object space at its point nearest to the camera. Tiles of a large picture count as parts of
 * it, since the projection of a camera with a view offset is that of its tile.
 *
 * @param viewport the viewport in pixels; z and w are its width and height
 */
function pixelsPerUnit({ geometry, matrixWorld }: Mesh, camera: Camera, viewport: Vector4): number {
  const sphere = geometry.boundingSphere!;
  const scale = matrixWorld.getMaxScaleOnAxis();
  const { elements } = camera.projectionMatrix;
  const pixels = (scale / 2) * Math.max(Math.abs(elements[0]) * viewport.z, Math.abs(elements[5]) * viewport.w);
  if (elements[15] === 1) return pixels;
  centre.copy(sphere.center).applyMatrix4(matrixWorld);
  centre.sub(forward.setFromMatrixPosition(camera.matrixWorld));
  const depth = -centre.dot(forward.setFromMatrixColumn(camera.matrixWorld, 2).normalize());
  const { near = 0 } = camera as Camera & { near?: number };
  return pixels / Math.max(depth - scale * sphere.radius, near, Number.MIN_VALUE);
}

/** The previous level before the first choice: finer than any, so that the choice is not simpler than needed. */
const FINEST = Infinity;

const viewport = /* @__PURE__ */ new Vector4();

type Hooks = Pick<Mesh, 'onBeforeRender' | 'onAfterRender' | 'onBeforeShadow' | 'onAfterShadow'>;

/** Draws a mesh at the level that each camera's view needs. */
export class LeveledMesh {
  /** The last level that each camera has seen. */
  private readonly seen = new WeakMap<Camera, number>();
  private readonly before: Hooks;
  private readonly hooks: Hooks;

  constructor(
    private readonly mesh: Mesh,
    private readonly leveled: LeveledGeometry,
  ) {
    const { onBeforeRender, onAfterRender, onBeforeShadow, onAfterShadow } = mesh;
    const before = { onBeforeRender, onAfterRender, onBeforeShadow, onAfterShadow };
    this.before = before;
    this.hooks = {
      onBeforeRender: (...all) => {
        before.onBeforeRender.apply(mesh, all);
        const [renderer, , camera, , material, group] = all;
        this.show(renderer as WebGLRenderer, camera, material, group);
      },
      onAfterRender: (...all) => {
        leveled.showWhole();
        before.onAfterRender.apply(mesh, all);
      },
      onBeforeShadow: (...all) => {
        before.onBeforeShadow.apply(mesh, all);
        const [, , camera, , , material, group] = all;
        // A shadow uses the level that the camera sees; a mismatch would draw patches of shadow on the surface.
        if (this.canShow(material, group)) leveled.show(this.seen.get(camera) ?? 0);
      },
      onAfterShadow: (...all) => {
        leveled.showWhole();
        before.onAfterShadow.apply(mesh, all);
      },
    };
    Object.assign(mesh, this.hooks);
  }

  /** Draws the whole mesh from now on. Hooks that other code has set since stay. */
  remove(): void {
    for (const name of Object.keys(this.hooks) as (keyof Hooks)[]) {
      if (this.mesh[name] === this.hooks[name]) Object.assign(this.mesh, { [name]: this.before[name] });
    }
  }

  private show(renderer: WebGLRenderer, camera: Camera, material: Material, group: unknown): void {
    if (!this.canShow(material, group)) return;
    // Each camera of an ArrayCamera draws into a part of the render target.
    const { viewport: own } = camera as Camera & { viewport?: Vector4 };
    if (own) viewport.copy(own);
    else renderer.getCurrentViewport(viewport);
    const { mesh, leveled, seen } = this;
    const size = pixelsPerUnit(mesh, camera, viewport);
    const level = chooseLevel(leveled.levels, size, seen.get(camera) ?? FINEST);
    seen.set(camera, level);
    leveled.show(level);
  }

  /** Whether the mesh is unchanged since the levels were made, and is not a wireframe, whose lines are made from the whole index. */
  private canShow(material: Material, group: unknown): boolean {
    if (this.mesh.geometry !== this.leveled.geometry || !this.leveled.isWhole || group) return false;
    return (material as Material & { wireframe?: boolean }).wireframe !== true;
  }
}
