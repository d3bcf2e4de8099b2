import { Box3, BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Group, Mesh, Vector3 } from 'three';
import { HatchingMaterial } from 'three-hatching';
import type { BuiltInScene } from '../../viewer/drawing/buildModel.js';
import { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { outlineOf } from '../../viewer/drawing/outlineOf.js';
import { boundsOf } from '../../viewer/files/mesh/boundsOf.js';
import { triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
import type { ReadModel } from '../../viewer/files/readModel.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { drawsWithAdjacency } from '../../viewer/settings/settingValues.js';

/**
 * A placeholder that is drawn while `read` is baked: with plain normals and without outlines. Undefined if the bake is short, or the
 * settings cannot be drawn without it.
 */
export function placeholderOf(read: ReadModel | BuiltInScene, settings: Settings): HatchedModel | undefined {
  if (read.kind !== 'mesh' || !read.plainNormals) return undefined;
  if (drawsWithAdjacency(settings)) return undefined;
  const { mesh, plainNormals, isClosed } = read;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(plainNormals, 3));
  if (mesh.colors) geometry.setAttribute('color', new BufferAttribute(mesh.colors, 3));
  if (mesh.indices) geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  // Faster than three's measuring, which calls a function per number.
  const { low, high } = boundsOf(mesh.positions);
  geometry.boundingBox = new Box3(new Vector3(...low), new Vector3(...high));
  const material = new HatchingMaterial({
    tilesPerUnit: 1,
    vertexColors: mesh.colors !== null,
    side: isClosed ? FrontSide : DoubleSide,
  });
  const drawn = new Mesh(geometry, material);
  // Measuring whether the only object is in view would gain nothing.
  drawn.frustumCulled = false;
  const statistics = {
    triangles: triangleCount(mesh),
    borderEdges: 0,
    nonManifoldEdges: 0,
    unpairedEdges: 0,
    inconsistentEdges: 0,
    degenerateTriangles: 0,
  };
  return new HatchedModel(
    new Group().add(drawn),
    geometry.boundingBox,
    outlineOf(mesh.positions),
    undefined,
    statistics,
    undefined,
    [material],
    [],
    () => {
      geometry.dispose();
      material.dispose();
    },
  );
}
