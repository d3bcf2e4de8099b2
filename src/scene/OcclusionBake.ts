import type { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { hatchNormal } from '../bake/hatchNormal.js';
import { disposeSharingClone, sharingClone } from '../geometry/sharingClone.js';
import type { SkippedMesh } from './HatchedScene.js';

/** A mesh that gets occlusion. */
interface OccludedMesh {
  mesh: Mesh;
  /** What it was drawn with when the bake began. */
  source: BufferGeometry;
  /** The same, or one that shares everything with it but the occlusion. */
  own: BufferGeometry;
}

/** Which bake wrote into an attribute last: what one takes back must not be another's. */
const writers = new WeakMap<object, OcclusionBake>();

/** Whether a geometry has room for occlusion. */
export function hasRoom({ attributes }: BufferGeometry): boolean {
  const attribute = attributes[hatchNormal.name];
  return (
    attribute?.itemSize === hatchNormal.itemSize && attribute.array instanceof Int16Array && !('data' in attribute)
  );
}

/** Ambient occlusion that `bakeOcclusion` has given to the meshes of a scene. */
export class OcclusionBake {
  /** How many directions each vertex has been asked in so far. */
  directions = 0;
  private occluded: readonly OccludedMesh[];

  /**
   * @param meshes with prepared geometries
   * @param skipped meshes that could not be read, and count as if they were not there
   */
  constructor(
    meshes: readonly Mesh[],
    readonly skipped: readonly SkippedMesh[],
  ) {
    const users = new Map<BufferGeometry, number>();
    for (const { geometry } of meshes) users.set(geometry, (users.get(geometry) ?? 0) + 1);
    this.occluded = meshes.map((mesh) => {
      const source = mesh.geometry;
      return { mesh, source, own: users.get(source) === 1 ? source : withOcclusionOfItsOwn(source) };
    });
  }

  /** The meshes that have occlusion. */
  get meshes(): readonly Mesh[] {
    return this.occluded.map(({ mesh }) => mesh);
  }

  /**
   * Gives each mesh its occlusion, but those that have another geometry by now.
   *
   * @param occlusions for each mesh, and for each of its vertices from 0, open, to 32767, closed
   * @internal
   */
  write(occlusions: readonly Int16Array[], directions: number): void {
    this.directions = directions;
    for (const [i, { mesh, source, own }] of this.occluded.entries()) {
      if (mesh.geometry === source) mesh.geometry = own;
      if (mesh.geometry !== own || !hasRoom(own)) continue;
      writers.set(own.attributes[hatchNormal.name], this);
      writeOcclusion(own, occlusions[i]);
    }
  }

  /** Takes the occlusion from the meshes, and gives back the geometries of those that shared theirs. A second call does nothing. */
  dispose(): void {
    for (const { mesh, source, own } of this.occluded) {
      if (own !== source) {
        if (mesh.geometry === own) mesh.geometry = source;
        disposeSharingClone(own, source);
      } else if (hasRoom(own) && writers.get(own.attributes[hatchNormal.name]) === this) {
        writeOcclusion(own, null);
      }
    }
    this.occluded = [];
  }
}

function withOcclusionOfItsOwn(source: BufferGeometry): BufferGeometry {
  const clone = sharingClone(source);
  return clone.setAttribute(hatchNormal.name, source.attributes[hatchNormal.name].clone());
}

function writeOcclusion({ attributes }: BufferGeometry, occlusion: Int16Array | null): void {
  const attribute = attributes[hatchNormal.name] as BufferAttribute;
  const { array } = attribute;
  // Negative, because WebGL reads 1 where there is no such attribute, and that must be open too.
  for (let i = 3, vertex = 0; i < array.length; i += 4, vertex++) array[i] = occlusion ? -occlusion[vertex] : 0;
  attribute.needsUpdate = true;
}
