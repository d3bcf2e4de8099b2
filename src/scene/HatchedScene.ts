import type { BufferGeometry, Material, Mesh } from 'three';
import { identityOf } from '../geometry/identityOf.js';
import type { HatchingLines } from '../lines/HatchingLines.js';
import { FIELD_FRAME } from '../material/fieldFrame.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';

/** A mesh that was left as it was, and why. */
export interface SkippedMesh {
  mesh: Mesh;
  error: Error;
}

/** The geometry and material of a mesh, and the frame of its lines. */
export interface MeshLook {
  mesh: Mesh;
  geometry: BufferGeometry;
  material: Material | Material[];
  /** The matrix from its object space to the frame that its lines are cut in, if it shares one with others. */
  fieldFrame: number[] | undefined;
}

/** A scene hatched by `applyHatching`, which can be restored. */
export class HatchedScene {
  private changes: readonly LookChange[];
  /** The identities of the meshes. */
  private held: ReadonlySet<object>;

  /**
   * Gives the meshes their new looks, all at once.
   *
   * @param materials every material made; change them freely
   * @param lines the lines of every mesh, if asked for; change their materials freely
   * @param skipped meshes that could not be hatched
   * @param disposables everything that `dispose()` frees
   * @param releaseMeshes called once the meshes are restored
   */
  constructor(
    looks: readonly MeshLook[],
    readonly materials: readonly HatchingMaterial[],
    readonly lines: readonly HatchingLines[],
    readonly skipped: readonly SkippedMesh[],
    private readonly disposables: { dispose(): void }[],
    private readonly releaseMeshes: () => void,
  ) {
    this.changes = looks.map((after) => ({ before: lookOf(after.mesh), after }));
    this.held = new Set(looks.map(({ mesh }) => identityOf(mesh)));
    for (const { before, after } of this.changes) exchangeLook(before, after);
    for (const one of lines) one.mesh?.add(one);
  }

  /**
   * Gives every mesh back the geometry and material it had, and takes its lines. What a mesh was given since stays. A second call does
   * nothing. The new geometries and materials stay usable until `dispose()`.
   */
  restore(): void {
    for (const one of this.lines) one.removeFromParent();
    for (const { before, after } of this.changes) exchangeLook(after, before);
    this.changes = [];
    this.held = new Set();
    this.releaseMeshes();
  }

  /** Restores, and frees everything that was made: geometries, materials, lines and, unless one was given, the map. */
  dispose(): void {
    this.restore();
    for (const disposable of this.disposables.splice(0)) disposable.dispose();
  }

  /** Whether a mesh has its look from here. @internal */
  holds(mesh: Mesh): boolean {
    return this.held.has(identityOf(mesh));
  }

  /** Does something with the meshes as they were before; afterwards they look hatched again. @internal */
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

/** Gives a mesh the geometry and material of `to` in the place of those of `from`. Others were given by somebody else, and stay. */
function exchangeLook(from: MeshLook, to: MeshLook): void {
  const { mesh } = from;
  if (isSame(mesh.geometry, from.geometry)) mesh.geometry = to.geometry;
  if (isSame(mesh.material, from.material)) mesh.material = to.material;
  if (to.fieldFrame === undefined) delete mesh.userData[FIELD_FRAME];
  else mesh.userData[FIELD_FRAME] = to.fieldFrame;
}

/** Whether two are one, be it by a proxy. */
const isSame = (one: object, other: object): boolean => one === other || identityOf(one) === identityOf(other);
