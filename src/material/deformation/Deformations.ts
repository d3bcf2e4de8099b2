import type { BufferGeometry, Camera, Material, Mesh } from 'three';
import { identityOf } from '../geometry/identityOf.js';
import type { PulledVertices } from '../geometry/PulledVertices.js';
import type { Deformation, PosePass } from './Deformation.js';
import { DeformationPool, type Held } from './DeformationPool.js';

/** The deformations on one graphics context. */
interface OfContext {
  /** The pool of each geometry, keyed by its identity. */
  readonly pools: WeakMap<object, DeformationPool>;
  /** The deformation in use by each mesh, keyed by its identity. */
  readonly held: WeakMap<object, Held>;
}

/** Releases a deformation when its mesh is garbage-collected, because meshes have no `dispose()`. */
const releaseWithMesh = /* @__PURE__ */ new FinalizationRegistry<Held>((held) => held.pool.release(held));

/** The deformations of one kind of renderer. */
export class Deformations<Renderer extends { readonly domElement: EventTarget }> {
  private readonly contexts = new WeakMap<object, OfContext>();

  /**
   * @param contextOf returns the object that identifies the graphics context of a renderer
   * @param makePass makes the pass of a geometry. `vertices` are the textures of the `pull` layout; null if the geometry has an index,
   * whose vertices are then deformed
   */
  constructor(
    private readonly contextOf: (renderer: Renderer) => object,
    private readonly makePass: (
      renderer: Renderer,
      geometry: BufferGeometry,
      vertices: PulledVertices | null,
    ) => PosePass,
  ) {}

  /**
   * The deformation of a mesh in its present pose, while the renderer draws it with `material` for `camera`. Meshes with the same
   * geometry in the same pose share it.
   *
   * @param vertices the textures of the `pull` layout; null if the geometry has an index
   */
  of(
    renderer: Renderer,
    camera: Camera,
    mesh: Mesh,
    geometry: BufferGeometry,
    vertices: PulledVertices | null,
    material: Material,
  ): Deformation {
    const context = this.ofContext(renderer);
    const pool = this.poolOf(context, renderer, geometry, vertices);
    const identity = identityOf(mesh);
    let held = context.held.get(identity);
    if (held?.pool !== pool) {
      if (held) {
        held.pool.release(held);
        releaseWithMesh.unregister(held);
      }
      held = { pool, deformation: undefined };
      context.held.set(identity, held);
      releaseWithMesh.register(identity, held, held);
    }
    return pool.present(held, camera, mesh, material);
  }

  /** Builds the program that {@link of} will need for a mesh. */
  compile(renderer: Renderer, mesh: Mesh, geometry: BufferGeometry, vertices: PulledVertices | null): void {
    this.poolOf(this.ofContext(renderer), renderer, geometry, vertices).compile(mesh);
  }

  private ofContext(renderer: Renderer): OfContext {
    const key = this.contextOf(renderer);
    let context = this.contexts.get(key);
    if (!context) {
      context = { pools: new WeakMap(), held: new WeakMap() };
      this.contexts.set(key, context);
    }
    return context;
  }

  private poolOf(
    { pools }: OfContext,
    renderer: Renderer,
    geometry: BufferGeometry,
    vertices: PulledVertices | null,
  ): DeformationPool {
    const identity = identityOf(geometry);
    let pool = pools.get(identity);
    if (!pool || pool.isDisposed) {
      pool = new DeformationPool(this.makePass(renderer, geometry, vertices), geometry, renderer.domElement);
      pools.set(identity, pool);
    }
    return pool;
  }
}
