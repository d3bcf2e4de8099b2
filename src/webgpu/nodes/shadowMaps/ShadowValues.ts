import type { LightShadow } from 'three';
import { threeNodes, type Value } from '../base/values.js';

const { reference, renderGroup } = threeNodes;

/** Uniforms of a shadow, shared by all programs. */
export interface ShadowValues {
  bias: Value;
  intensity: Value;
  /** Texels per side. */
  mapSize: Value;
  normalBias: Value;
  /** Texels. */
  radius: Value;
  /** Of the shadow camera. */
  near: Value;
  far: Value;
}

const valuesOf = /* @__PURE__ */ new WeakMap<LightShadow, ShadowValues>();

export function shadowValuesFor(shadow: LightShadow): ShadowValues {
  const known = valuesOf.get(shadow);
  if (known) return known;
  const read = (name: string, type: 'float' | 'vec2', object: object = shadow): Value =>
    reference(name, type, object).setGroup(renderGroup) as unknown as Value;
  const made: ShadowValues = {
    bias: read('bias', 'float'),
    intensity: read('intensity', 'float'),
    mapSize: read('mapSize', 'vec2'),
    normalBias: read('normalBias', 'float'),
    radius: read('radius', 'float'),
    near: read('near', 'float', shadow.camera),
    far: read('far', 'float', shadow.camera),
  };
  valuesOf.set(shadow, made);
  return made;
}
