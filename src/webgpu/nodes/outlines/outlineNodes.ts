import type { Node } from 'three/webgpu';
import { threeNodes } from '../base/values.js';
import { logarithmicDepth } from './depth.js';
import { fragments, spinePosition } from './fragments.js';
import type { OutlineDefines } from './OutlineDefines.js';
import { vertices } from './vertices.js';

/** The nodes that a material of outlines consists of. */
export interface OutlineNodes {
  /** What chose them. */
  key: string;
  vertex: Node<'vec4'>;
  color: Node<'vec4'>;
  outgoing: Node<'vec3'>;
  /** The z in view space by which there is fog. */
  viewZ: Node<'float'>;
  /** The depth of fragments where that is logarithmic. */
  logarithmicDepth: Node<'float'>;
}

const known = new Map<string, OutlineNodes>();

/** The nodes of all materials with these defines. */
export function outlineNodes(defines: OutlineDefines): OutlineNodes {
  const key = JSON.stringify(defines);
  let nodes = known.get(key);
  if (!nodes) {
    nodes = {
      key,
      vertex: vertices(defines) as unknown as Node<'vec4'>,
      color: fragments(defines) as unknown as Node<'vec4'>,
      outgoing: threeNodes.diffuseColor.rgb,
      viewZ: spinePosition.z as unknown as Node<'float'>,
      logarithmicDepth: logarithmicDepth(defines) as unknown as Node<'float'>,
    };
    known.set(key, nodes);
  }
  return nodes;
}
