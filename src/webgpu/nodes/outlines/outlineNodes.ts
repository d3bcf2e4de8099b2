import type { Node } from 'three/webgpu';
import { threeNodes } from '../base/values.js';
import { logarithmicDepth } from './depth.js';
import { fragments, spinePosition } from './fragments.js';
import type { OutlineDefines } from './OutlineDefines.js';
import { vertices } from './vertices.js';

/** The nodes of an outline material. */
export interface OutlineNodes {
  /** The defines that they are built for. */
  key: string;
  vertex: Node<'vec4'>;
  color: Node<'vec4'>;
  outgoing: Node<'vec3'>;
  /** The z in view space that fog is computed from. */
  viewZ: Node<'float'>;
  /** The depth of fragments for a logarithmic depth buffer. */
  logarithmicDepth: Node<'float'>;
}

const known = new Map<string, OutlineNodes>();

/** The nodes for these defines, shared by all materials. */
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
