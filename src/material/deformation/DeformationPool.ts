import type { BufferGeometry, Camera, Material, Mesh } from 'three';
import { Deformation, type PosePass } from './Deformation.js';
import { hashOf } from './Pose.js';

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
export class DeformationPool {
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
