import { threeNodes, type Value } from './values.js';

const { materialReference } = threeNodes;

type UniformType = 'float' | 'int' | 'vec2' | 'vec3' | 'vec4' | 'color' | 'mat3' | 'mat4';

const known = new Map<string, Value>();

/**
 * A node for a uniform of the material that is being drawn, read from its `uniforms`. All materials share the node, and so share programs.
 *
 * @param type `float` for a flag: three.js evaluates one of type `bool` where it is used first, even inside a branch
 */
export function hatchingUniform(name: string, type: UniformType): Value {
  const key = `${name} ${type}`;
  let uniform = known.get(key);
  if (!uniform) {
    uniform = materialReference(`uniforms.${name}.value`, type) as unknown as Value;
    known.set(key, uniform);
  }
  return uniform;
}

/** An element of an array uniform. */
export const hatchingElement = (name: string, index: number): Value =>
  materialReference(`uniforms.${name}.value.${index}`, 'float') as unknown as Value;
