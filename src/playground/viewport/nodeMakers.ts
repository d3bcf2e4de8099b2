import { type Color, Material, type Vector2 } from 'three';
import type { HatchingMaterial, HatchingPropertyName } from 'three-hatching';
import { HATCHING_PROPERTIES } from 'three-hatching/facts';
import { HatchingNodeMaterial, HatchingOutlineNodeMaterial, HatchingOutlines } from 'three-hatching/webgpu';
import type { NodeMakers } from '../../viewer/drawing/NodeMakers.js';

const NAMES = Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];

/** A material of nodes with the properties of another one. What equals a default of the technique stays one, and changes with the technique. */
function nodesLike(drawn: HatchingMaterial): HatchingNodeMaterial {
  const nodes = new HatchingNodeMaterial();
  Material.prototype.copy.call(nodes, drawn);
  nodes.technique = drawn.technique;
  for (const name of NAMES) {
    const { kind } = HATCHING_PROPERTIES[name];
    if (kind === 'color') (nodes[name] as Color).copy(drawn[name] as Color);
    else if (kind === 'vector2') (nodes[name] as Vector2).copy(drawn[name] as Vector2);
    else if (nodes[name] !== drawn[name]) Object.assign(nodes, { [name]: drawn[name] });
  }
  nodes.extent = drawn.extent;
  return nodes;
}

export const nodeMakers: NodeMakers = {
  material: nodesLike,
  outlineMaterial: () => new HatchingOutlineNodeMaterial(),
  outlines: (mesh, material) => new HatchingOutlines(mesh, material),
};
