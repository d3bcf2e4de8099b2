import { type BufferAttribute, BufferGeometry, type Mesh } from 'three';
import { hatchNormal } from '../mesh/bake/attributeLayouts.js';
import type { SkippedMesh } from './SkippedMesh.js';

/** A mesh that receives occlusion. */
interface OccludedMesh {
  mesh: Mesh;
  /** The geometry of the mesh when the bake began. */
  source: BufferGeometry;
  /** The geometry that the occlusion is written to: `source`, or a clone that shares everything but the occlusion. */
  own: BufferGeometry;
}

/** For each attribute, the bake that has last written to it: no bake may remove the occlusion of another. */
const writers = new WeakMap<object, OcclusionBake>();

/** Whether a geometry has an attribute that occlusion can be written to. */
export function hasRoom({ attributes }: BufferGeometry): boolean {
  const attribute = attributes[hatchNormal.name];
  return (
    attribute?.itemSize === hatchNormal.itemSize && attribute.array instanceof Int16Array && !('data' in attribute)
  );
}

/** The ambient occlusion that `bakeOcclusion` has given to the meshes of a scene. */
export class OcclusionBake {
  /** The number of directions measured so far. */
  directions = 0;
  private occluded: readonly OccludedMesh[];

  /**
   * @param meshes meshes with prepared geometries
   * @param skipped meshes that could not be read; they neither occlude nor receive occlusion
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
   * Writes the occlusion of each mesh, except meshes that have another geometry by now.
   *
   * @param occlusions for each mesh, the component of `hatchNormal` of each vertex
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

  /** Removes the occlusion, and restores the shared geometry of meshes that shared one. A second call does nothing. */
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
  for (let i = 3, vertex = 0; i < array.length; i += 4, vertex++) array[i] = occlusion ? occlusion[vertex] : 0;
  attribute.needsUpdate = true;
}

/** Creates a geometry that shares all data of a prepared one. Single attributes of the clone can be replaced. */
function sharingClone(source: BufferGeometry): BufferGeometry {
  const clone = new BufferGeometry();
  clone.name = source.name;
  clone.userData = source.userData;
  clone.index = source.index;
  Object.assign(clone.attributes, source.attributes);
  Object.assign(clone.morphAttributes, source.morphAttributes);
  clone.morphTargetsRelative = source.morphTargetsRelative;
  clone.groups = source.groups;
  clone.drawRange = source.drawRange;
  clone.boundingBox = source.boundingBox;
  clone.boundingSphere = source.boundingSphere;
  return clone;
}

/** Frees only the attributes that the clone does not share; `dispose()` would free the shared buffers too. */
function disposeSharingClone(clone: BufferGeometry, source: BufferGeometry): void {
  clone.index = null;
  for (const name of Object.keys(clone.attributes)) {
    if (clone.attributes[name] === source.attributes[name]) clone.deleteAttribute(name);
  }
  clone.dispose();
}
