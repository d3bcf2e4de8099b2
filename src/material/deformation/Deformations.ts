import type { BufferGeometry, Camera, Material, Mesh } from 'three';
import { identityOf } from '../geometry/identityOf.js';
import type { PulledVertices } from '../geometry/PulledVertices.js';
import { Deformation, hashOf, type PosePass } from './Deformation.js';

/** The deformation in use by one mesh. */
export interface Held {
  readonly pool: DeformationPool;
  deformation: Deformation | undefined;
}

/** The deformations that a material has drawn with, and a function that removes the listener for its disposal. */
interface MaterialUse {
  readonly deformations: Set<Deformation>;
  release(): void;
}

/**
 * The deformations of one geometry on one graphics context. Each pose is drawn once, whatever number of meshes, materials, cameras and
 * frames use it. Every skinned mesh has a deformation of its own, since no two are in the same pose.
 */
class DeformationPool {
  isDisposed = false;
  private readonly all = new Set<Deformation>();
  /** The deformations that meshes without a skin share, keyed by the hash of their pose. */
  private readonly byPose = new Map<number, Deformation>();
  /** An unused deformation, kept because meshes that move together exchange theirs in every frame. */
  private spare: Deformation | undefined;
  private readonly materials = new Map<Material, MaterialUse>();
  private readonly compiled = new Set<boolean>();

  /** @param canvas fires an event when its context is lost */
  constructor(
    private readonly pass: PosePass,
    private readonly geometry: BufferGeometry,
    private readonly canvas: EventTarget,
  ) {
    geometry.addEventListener('dispose', this.dispose);
    canvas.addEventListener('webglcontextlost', this.dispose);
  }

  /**
   * The deformation of a mesh in its present pose, while the renderer draws it with `material` for `camera`. Draws the pose if no other
   * mesh has it. Allocates nothing once every pose has textures.
   */
  present(held: Held, camera: Camera, mesh: Mesh, material: Material): Deformation {
    const isShared = mesh.morphTargetInfluences !== undefined && !('isSkinnedMesh' in mesh);
    const deformation = isShared
      ? this.presentShared(held, camera, mesh, mesh.morphTargetInfluences!)
      : this.presentOwn(held, camera, mesh);
    if (!deformation.users.has(material)) this.addUser(deformation, material);
    return deformation;
  }

  /** Builds the program that a mesh needs, without drawing. */
  compile(mesh: Mesh): void {
    const isSkinned = 'isSkinnedMesh' in mesh;
    if (this.compiled.has(isSkinned)) return;
    this.compiled.add(isSkinned);
    this.spare ??= this.make();
    this.pass.compile?.(this.spare.target, mesh);
  }

  /** Releases the deformation of a mesh that was collected or has another geometry. */
  release(held: Held): void {
    const { deformation } = held;
    held.deformation = undefined;
    if (!deformation || deformation.isDisposed) return;
    deformation.holders--;
    if (deformation.holders === 0) this.drop(deformation);
  }

  /**
   * Frees the GPU memory. Called when the geometry is disposed of, and when the context is lost: in a restored context the old names of
   * its textures may stand for others. When a material is disposed of, the deformations drawn with it are freed too.
   */
  readonly dispose = (): void => {
    if (this.isDisposed) return;
    this.isDisposed = true;
    for (const deformation of this.all) deformation.dispose();
    this.all.clear();
    this.byPose.clear();
    for (const { release } of this.materials.values()) release();
    this.materials.clear();
    this.pass.dispose();
    this.geometry.removeEventListener('dispose', this.dispose);
    this.canvas.removeEventListener('webglcontextlost', this.dispose);
  };

  private presentOwn(held: Held, camera: Camera, mesh: Mesh): Deformation {
    const deformation = this.heldBy(held) ?? this.give(held, this.spare ?? this.make());
    if (deformation.pose.update(mesh)) this.pass.draw(deformation.target, camera, mesh);
    return deformation;
  }

  private presentShared(held: Held, camera: Camera, mesh: Mesh, influences: readonly number[]): Deformation {
    const before = this.heldBy(held);
    if (before?.pose.isOf(influences)) return before;
    const hash = hashOf(influences);
    const twin = this.byPose.get(hash);
    if (twin?.pose.isOf(influences)) return this.give(held, twin);
    // Other meshes may still use the pose that this mesh leaves.
    const deformation = before?.holders === 1 ? before : this.give(held, this.spare ?? this.make());
    this.forgetPose(deformation);
    deformation.pose.update(mesh);
    this.byPose.set(hash, deformation);
    this.pass.draw(deformation.target, camera, mesh);
    return deformation;
  }

  private heldBy({ deformation }: Held): Deformation | undefined {
    return deformation?.isDisposed ? undefined : deformation;
  }

  private make(): Deformation {
    const deformation = new Deformation(this.pass.makeTarget());
    this.all.add(deformation);
    return deformation;
  }

  private give(held: Held, deformation: Deformation): Deformation {
    const before = this.heldBy(held);
    held.deformation = deformation;
    deformation.holders++;
    if (this.spare === deformation) this.spare = undefined;
    if (before) {
      before.holders--;
      if (before.holders === 0) this.putAside(before);
    }
    return deformation;
  }

  private putAside(deformation: Deformation): void {
    if (this.spare) this.drop(deformation);
    else this.spare = deformation;
  }

  private drop(deformation: Deformation): void {
    deformation.dispose();
    this.all.delete(deformation);
    this.forgetPose(deformation);
    if (this.spare === deformation) this.spare = undefined;
    for (const material of deformation.users) this.materials.get(material)?.deformations.delete(deformation);
    if (this.all.size === 0 || (this.all.size === 1 && this.spare)) this.dispose();
  }

  private forgetPose(deformation: Deformation): void {
    const hash = deformation.pose.influenceHash;
    if (this.byPose.get(hash) === deformation) this.byPose.delete(hash);
  }

  private addUser(deformation: Deformation, material: Material): void {
    deformation.users.add(material);
    const known = this.materials.get(material);
    if (known) {
      known.deformations.add(deformation);
      return;
    }
    const deformations = new Set([deformation]);
    const onDispose = (): void => {
      release();
      this.materials.delete(material);
      for (const deformation of deformations) this.drop(deformation);
    };
    const release = (): void => material.removeEventListener('dispose', onDispose);
    material.addEventListener('dispose', onDispose);
    this.materials.set(material, { deformations, release });
  }
}

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
