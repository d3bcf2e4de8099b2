import type { BufferGeometry, Material, Mesh } from 'three';
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
  private originals: readonly MeshLook[];

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
    this.originals = looks.map(({ mesh }) => ({
      mesh,
      geometry: mesh.geometry,
      material: mesh.material,
      fieldFrame: mesh.userData[FIELD_FRAME],
    }));
    applyLooks(looks);
    for (const one of lines) one.mesh?.add(one);
  }

  /**
   * Gives every mesh back the geometry and material it had, and takes its lines. A second call does nothing. The new geometries and materials stay
   * usable until `dispose()`.
   */
  restore(): void {
    for (const one of this.lines) one.removeFromParent();
    applyLooks(this.originals);
    this.originals = [];
    this.releaseMeshes();
  }

  /** Restores, and frees everything that was made: geometries, materials, lines and, unless one was given, the map. */
  dispose(): void {
    this.restore();
    for (const disposable of this.disposables.splice(0)) disposable.dispose();
  }
}

function applyLooks(looks: readonly MeshLook[]): void {
  for (const { mesh, geometry, material, fieldFrame } of looks) {
    Object.assign(mesh, { geometry, material });
    if (fieldFrame === undefined) delete mesh.userData[FIELD_FRAME];
    else mesh.userData[FIELD_FRAME] = fieldFrame;
  }
}
