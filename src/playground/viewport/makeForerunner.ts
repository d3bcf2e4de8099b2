import { Box3, BufferAttribute, BufferGeometry, FrontSide, Group, Mesh } from 'three';
import { HatchingMaterial } from 'three-hatching';
import { HatchedModel } from '../../viewer/drawing/HatchedModel.js';

/**
 * A degenerate triangle with the attributes and the material of a closed scan. It is drawn while the first model loads, so that its
 * programs are ready by then: browsers compile a part of a program in the first frame that uses it.
 */
export function makeForerunner(): HatchedModel {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(9), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(9), 3));
  geometry.setAttribute('hatchNormal', new BufferAttribute(new Int16Array(12), 4, true));
  const material = new HatchingMaterial({ tilesPerUnit: 1, side: FrontSide });
  const drawn = new Mesh(geometry, material);
  drawn.frustumCulled = false;
  const statistics = {
    triangles: 1,
    borderEdges: 0,
    nonManifoldEdges: 0,
    unpairedEdges: 0,
    inconsistentEdges: 0,
    degenerateTriangles: 1,
  };
  return new HatchedModel(
    new Group().add(drawn),
    new Box3(),
    new Float32Array(0),
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
