import type { BufferGeometry, Material, Mesh } from 'three';
import type { HatchingMaterial } from './HatchingMaterial.js';

/** A mesh that was left as it was, and why. */
export interface SkippedMesh {
  mesh: Mesh;
  error: Error;
}

/** What a mesh is to wear. */
export interface Dress {
  mesh: Mesh;
  geometry: BufferGeometry;
  material: Material | Material[];
}

/** A scene that `applyHatching` has hatched, and the way back. */
export class HatchedScene {
  private before: readonly Dress[];

  /**
   * Dresses the meshes, all at once.
   *
   * @param materials every material made; change them freely
   * @param skipped meshes that could not be hatched
   * @param made everything that `dispose()` frees
   * @param release called when the meshes are as they were
   */
  constructor(
    dresses: readonly Dress[],
    readonly materials: readonly HatchingMaterial[],
    readonly skipped: readonly SkippedMesh[],
    private readonly made: { dispose(): void }[],
    private readonly release: () => void,
  ) {
    this.before = dresses.map(({ mesh }) => ({ mesh, geometry: mesh.geometry, material: mesh.material }));
    putOn(dresses);
  }

  /**
   * Gives every mesh back the very geometry and material it had; again, it does nothing. What was made is kept for you to
   * use until `dispose()`.
   */
  restore(): void {
    putOn(this.before);
    this.before = [];
    this.release();
  }

  /** Restores, and frees everything that was made: geometries, materials and, where none was given, the map. */
  dispose(): void {
    this.restore();
    for (const thing of this.made.splice(0)) thing.dispose();
  }
}

function putOn(dresses: readonly Dress[]): void {
  for (const { mesh, geometry, material } of dresses) Object.assign(mesh, { geometry, material });
}
