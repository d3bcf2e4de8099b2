import type { BufferGeometry, Camera, Material, Mesh, WebGLRenderer } from 'three';
import { identityOf } from '../../geometry/identityOf.js';
import type { PulledVertices } from '../../geometry/PulledVertices.js';
import type { Deformation } from './Deformation.js';
import { DeformationPool, type Held } from './DeformationPool.js';

/** The deformations on one graphics context. */
interface OfContext {
  /** By the identity of the geometry. */
  readonly pools: WeakMap<object, DeformationPool>;
  /** By the identity of the mesh. */
  readonly held: WeakMap<object, Held>;
}

/** Per `renderer.properties`: three.js makes a new one when a lost context is restored. */
const contexts = new WeakMap<object, OfContext>();
/** Releases a deformation when its mesh is garbage-collected, because meshes have no `dispose()`. */
const releaseWithMesh = /* @__PURE__ */ new FinalizationRegistry<Held>((held) => held.pool.release(held));

/**
 * The deformation of a mesh in its present pose, while the renderer draws it with `material` for `camera`. Meshes with the same
 * geometry in the same pose share it.
 *
 * @param vertices the textures of the `pull` layout; null if the geometry has an index, whose vertices are then deformed
 */
export function deformationOf(
  renderer: WebGLRenderer,
  camera: Camera,
  mesh: Mesh,
  geometry: BufferGeometry,
  vertices: PulledVertices | null,
  material: Material,
): Deformation {
  const context = contextOf(renderer);
  const pool = poolOf(context, renderer, geometry, vertices);
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

/** Builds the program that {@link deformationOf} will need for a mesh. */
export function compileDeformation(
  renderer: WebGLRenderer,
  mesh: Mesh,
  geometry: BufferGeometry,
  vertices: PulledVertices | null,
): void {
  poolOf(contextOf(renderer), renderer, geometry, vertices).compile(mesh);
}

function contextOf({ properties }: WebGLRenderer): OfContext {
  let context = contexts.get(properties);
  if (!context) {
    context = { pools: new WeakMap(), held: new WeakMap() };
    contexts.set(properties, context);
  }
  return context;
}

function poolOf(
  { pools }: OfContext,
  renderer: WebGLRenderer,
  geometry: BufferGeometry,
  vertices: PulledVertices | null,
): DeformationPool {
  const identity = identityOf(geometry);
  let pool = pools.get(identity);
  if (!pool || pool.isDisposed) {
    pool = new DeformationPool(renderer, geometry, vertices);
    pools.set(identity, pool);
  }
  return pool;
}
