import type { BufferGeometry, Camera, Material, Mesh } from 'three';
import { Deformation } from './Deformation.js';
import { hashOf } from './Pose.js';
import type { PosePass } from './PosePass.js';

/** The deformation that a mesh draws with at present. */
export interface Held {
  readonly pool: DeformationPool;
  deformation: Deformation | undefined;
}

/** The deformations that were drawn with a material, and a function that stops listening for its disposal. */
interface MaterialUse {
  readonly deformations: Set<Deformation>;
  release(): void;
}

/**
 * The deformations of one geometry on one graphics context. Each pose is drawn once, however many meshes are in it and however many
 * materials, cameras and frames draw them. Meshes with a skin have a deformation each, since no two are in the same pose.
 */
export class DeformationPool {
  isDisposed = false;
  private readonly all = new Set<Deformation>();
  /** The deformations that meshes without a skin share, by the hash of their pose. */
  private readonly byPose = new Map<number, Deformation>();
  /** A deformation that no mesh holds: meshes that move together exchange theirs for another in every frame. */
  private spare: Deformation | undefined;
  private readonly materials = new Map<Material, MaterialUse>();
  private readonly compiled = new Set<boolean>();

  /** @param canvas is told when its context is lost */
  constructor(
    private readonly pass: PosePass,
    private readonly geometry: BufferGeometry,
    private readonly canvas: EventTarget,
  ) {
    geometry.addEventListener('dispose', this.dispose);
    canvas.addEventListener('webglcontextlost', this.dispose);
  }

  /**
   * The deformation of a mesh in its present pose, while the renderer draws it with `material` for `camera`. Draws the pose if no other mesh
   * has it. Allocates nothing once every pose has its textures.
   */
  present(held: Held, camera: Camera, mesh: Mesh, material: Material): Deformation {
    const isShared = mesh.morphTargetInfluences !== undefined && !('isSkinnedMesh' in mesh);
    const deformation = isShared
      ? this.presentShared(held, camera, mesh, mesh.morphTargetInfluences!)
      : this.presentOwn(held, camera, mesh);
    if (!deformation.users.has(material)) this.addUser(deformation, material);
    return deformation;
  }

  /** Builds the program that a mesh needs, and draws nothing. */
  compile(mesh: Mesh): void {
    const isSkinned = 'isSkinnedMesh' in mesh;
    if (this.compiled.has(isSkinned)) return;
    this.compiled.add(isSkinned);
    this.spare ??= this.make();
    this.pass.compile?.(this.spare.target, mesh);
  }

  /** A mesh is gone, or draws another geometry. */
  release(held: Held): void {
    const { deformation } = held;
    held.deformation = undefined;
    if (!deformation || deformation.isDisposed) return;
    deformation.holders--;
    if (deformation.holders === 0) this.drop(deformation);
  }

  /**
   * Frees the graphics memory. Called when the geometry is disposed of, and when the context is lost: in a restored
   * context the old names of its textures may stand for others. When a material is disposed of, so are the deformations drawn with it.
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
    // Other meshes may still be in the pose that this one leaves.
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
