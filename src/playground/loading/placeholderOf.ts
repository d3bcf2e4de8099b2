import { Box3, BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Group, Mesh, Vector3 } from 'three';
import { HatchingMaterial, type HatchingMaterialParameters } from 'three-hatching';
import type { BuiltInScene } from '../../viewer/drawing/buildModel.js';
import { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { someVertices } from '../../viewer/drawing/meshes.js';
import { boundsOf, triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
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
  const { mesh, plainNormals, hidesBacks } = read;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(plainNormals, 3));
  if (mesh.colors) geometry.setAttribute('color', new BufferAttribute(mesh.colors, 3));
  if (mesh.indices) geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  // Faster than three's measuring, which calls a function per number.
  const { low, high } = boundsOf(mesh.positions);
  geometry.boundingBox = new Box3(new Vector3(...low), new Vector3(...high));
  const side = hidesBacks ? FrontSide : DoubleSide;
  const vertexColors = mesh.colors !== null;
  return unbaked(
    geometry,
    geometry.boundingBox,
    { side, vertexColors },
    triangleCount(mesh),
    someVertices(mesh.positions),
  );
}

/**
 * A degenerate triangle with the attributes and the material of a closed scan. It is drawn while the first model loads, so that its
 * programs are ready by then: browsers compile a part of a program in the first frame that uses it.
 */
export function warmUpModel(): HatchedModel {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(9), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(9), 3));
  geometry.setAttribute('hatchNormal', new BufferAttribute(new Int16Array(12), 4, true));
  return unbaked(geometry, new Box3(), { side: FrontSide }, 1, new Float32Array(0));
}

/** A model of a geometry that was not baked, without outlines. */
function unbaked(
  geometry: BufferGeometry,
  bounds: Box3,
  parameters: HatchingMaterialParameters,
  triangles: number,
  framedPoints: Float32Array,
): HatchedModel {
  const material = new HatchingMaterial({ tilesPerObjectUnit: 1, ...parameters });
  const drawn = new Mesh(geometry, material);
  // Measuring whether the only object is in view would gain nothing.
  drawn.frustumCulled = false;
  const none = { borderEdges: 0, nonManifoldEdges: 0, unpairedEdges: 0, inconsistentEdges: 0, degenerateTriangles: 0 };
  const free = (): void => {
    geometry.dispose();
    material.dispose();
  };
  const root = new Group().add(drawn);
  const counts = { triangles, ...none };
  return new HatchedModel(root, bounds, framedPoints, undefined, counts, undefined, [material], [], free);
}
