import type { Mesh } from 'three';
import { FIELD_FRAME } from '../material/fieldFrameName.js';
import { identityOf } from '../material/geometry/identityOf.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingOutlines } from '../material/outlines/HatchingOutlines.js';
import type { MeshLook } from './geometryPlans.js';
import type { LaterForms } from './LaterForms.js';
import type { MaterialFollower } from './MaterialReplacer.js';
import { claimMeshes, isHatching, materialsOf } from './surfaceMeshes.js';

/** A mesh that was left unchanged, or hatched without the outlines that were requested. */
export interface SkippedMesh {
  mesh: Mesh;
  /** The reason, in a sentence that names the mesh. */
  reason: string;
  /** The cause, if the mesh should have been hatched and could not be. */
  error?: Error | undefined;
}

/** New looks of meshes that are ready to be shown. */
export interface MadeLooks {
  looks: readonly MeshLook[];
  /** All new materials. */
  materials: readonly HatchingMaterial[];
  /** The outlines of all meshes, if requested. */
  outlines: readonly HatchingOutlines[];
  /** Meshes that were left alone, or have no outlines. */
  skipped: readonly SkippedMesh[];
  /** Copy changes from the materials that were replaced. */
  followers: readonly MaterialFollower[];
  /** Everything that `dispose()` frees. */
  disposables: { dispose(): void }[];
  /** Bakes form fields from now on, if lines follow the form anywhere. */
  forms: LaterForms | null;
  /** Starts to draw levels of detail; the returned function ends it. */
  showDetail: (() => () => void) | undefined;
}

/** A scene hatched by `applyHatching`, which can be restored. */
export class HatchedScene {
  /** @internal */
  readonly isHatchedScene = true;
  /** All new materials; you may change them. */
  readonly materials: readonly HatchingMaterial[];
  /** The outlines of all meshes, if requested; you may change their materials. */
  readonly outlines: readonly HatchingOutlines[];
  /** Meshes that were left alone, or have no outlines. */
  readonly skipped: readonly SkippedMesh[];
  /** What each mesh looked like, and looks like; empty once it is restored. */
  private changes: readonly LookChange[];
  /** The identities of the hatched meshes. */
  private held: ReadonlySet<object>;
  private readonly releaseMeshes: () => void;
  private readonly hideDetail: (() => void) | undefined;

  /** Gives the meshes their new looks, all at once. @internal */
  constructor(private readonly made: MadeLooks) {
    const { looks, outlines, forms } = made;
    this.materials = made.materials;
    this.outlines = outlines;
    this.skipped = made.skipped;
    const meshes = looks.map(({ mesh }) => mesh);
    this.releaseMeshes = claimMeshes(meshes);
    this.hideDetail = made.showDetail?.();
    this.changes = looks.map((after) => ({ before: lookOf(after.mesh), after }));
    this.held = new Set(meshes.map(identityOf));
    for (const { before, after } of this.changes) exchangeLook(before, after);
    for (const child of outlines) child.mesh?.add(child);
    forms?.start(looks);
    for (const mesh of meshes) {
      for (const material of materialsOf(mesh)) if (isHatching(material)) material.announce?.(mesh);
    }
  }

  /**
   * Resolves with the meshes that were given another geometry, when all lines lie as their materials ask. Meshes of more than 200,000
   * triangles whose lines are to follow the form follow the light at first, so that the first picture does not wait; and after the
   * `crossAngle` of a material has changed, lines cross at the new angle only when their field is baked again. If there is nothing to
   * wait for, it resolves at once. It never rejects: if a form could not be baked, the console says why. `restore()` stops the bake.
   */
  get formReady(): Promise<readonly Mesh[]> {
    return Promise.resolve(this.made.forms?.ready).then(() => this.formed);
  }

  /** The meshes that were given another geometry so far. @internal */
  get formed(): readonly Mesh[] {
    return this.made.forms?.meshes ?? [];
  }

  /**
   * Gives every mesh back its former geometry and material, and removes its outlines. A geometry or material that you have set since
   * stays. A second call does nothing. The new geometries and materials stay usable until `dispose()`.
   */
  restore(): void {
    this.made.forms?.stop();
    for (const child of this.outlines) child.removeFromParent();
    for (const { before, after } of this.changes) exchangeLook(after, before);
    this.changes = [];
    this.held = new Set();
    this.hideDetail?.();
    this.releaseMeshes();
  }

  /** Restores the meshes, and frees all new geometries, materials and outlines, and a map that was generated for this call. */
  dispose(): void {
    this.restore();
    for (const disposable of this.made.disposables.splice(0)) disposable.dispose();
  }

  /**
   * Copies changes from the materials that were replaced: colour, opacity, maps, emission, visibility, sides, wireframe, fog, clipping,
   * depth and stencil. Parameters that you passed, and values that you have set on the new material, stay. A mesh whose former material
   * or geometry was set back, as by helpers that swap materials for a moment, gets its new look again.
   *
   * Call it before a frame if your code changes the former materials; `<Hatched>` does so. It costs a comparison per property.
   */
  follow(): void {
    for (const follower of this.made.followers) follower.follow();
    for (const { before, after } of this.changes) {
      const { mesh, geometry, material } = after;
      if (mesh.geometry !== geometry || mesh.material !== material) exchangeLook(before, after);
    }
  }

  /** Whether `mesh` is among the hatched meshes. @internal */
  holds(mesh: Mesh): boolean {
    return this.held.has(identityOf(mesh));
  }

  /** Runs a function while the meshes have their former geometries and materials. @internal */
  suspended<Result>(work: () => Result): Result {
    for (const { before, after } of this.changes) exchangeLook(after, before);
    try {
      return work();
    } finally {
      for (const { before, after } of this.changes) exchangeLook(before, after);
    }
  }
}

interface LookChange {
  readonly before: MeshLook;
  readonly after: MeshLook;
}

const lookOf = (mesh: Mesh): MeshLook => ({
  mesh,
  geometry: mesh.geometry,
  material: mesh.material,
  fieldFrame: mesh.userData[FIELD_FRAME],
});

/** Replaces the geometry and material of `from` by those of `to`. Others that were set in the meantime stay. */
function exchangeLook(from: MeshLook, to: MeshLook): void {
  const { mesh } = from;
  if (isSame(mesh.geometry, from.geometry)) mesh.geometry = to.geometry;
  if (isSame(mesh.material, from.material)) mesh.material = to.material;
  if (to.fieldFrame === undefined) delete mesh.userData[FIELD_FRAME];
  else mesh.userData[FIELD_FRAME] = to.fieldFrame;
}

/** Whether two objects are the same, or proxies of the same object. */
const isSame = (a: object, b: object): boolean => a === b || identityOf(a) === identityOf(b);
