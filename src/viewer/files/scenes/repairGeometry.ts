import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute, Mesh, Object3D } from 'three';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** NaN vertex colours become white, so that strokes are drawn on bare paper as elsewhere. */
const WHITE = 1;

/**
 * Repairs non-finite values in place: colours, texture coordinates, tangents, skin weights and morph targets. Colours become white, all
 * others zero; morph targets with absolute positions or normals take the unmorphed vertex's value. Normals that are zero or not finite
 * become zero: the library computes them from the surface, with its creases.
 *
 * @returns whether anything was repaired
 */
export function repairGeometry({ attributes, morphAttributes, morphTargetsRelative }: BufferGeometry): boolean {
  let repaired = 0;
  for (const [name, attribute] of Object.entries(attributes) as [string, Attribute][]) {
    if (name === 'position' || !canHoldBadValues(attribute)) continue;
    repaired +=
      name === 'normal' ? zeroBadVectors(attribute) : replaceBadValues(attribute, () => (name === 'color' ? WHITE : 0));
  }
  for (const [name, targets] of Object.entries(morphAttributes)) {
    const base = morphTargetsRelative ? undefined : (attributes[name] as Attribute | undefined);
    for (const target of targets) {
      if (!canHoldBadValues(target)) continue;
      repaired += replaceBadValues(target, (vertex, component) => base?.getComponent(vertex, component) ?? 0);
    }
  }
  return repaired > 0;
}

/** Repairs each geometry at or below an object once, and non-finite morph target influences. */
export function repairScene(root: Object3D): void {
  const seen = new Set<BufferGeometry>();
  root.traverse((object) => {
    const { isMesh, geometry, morphTargetInfluences } = object as Partial<Mesh>;
    if (!isMesh || !geometry) return;
    morphTargetInfluences?.forEach((weight, i) => {
      if (!Number.isFinite(weight)) morphTargetInfluences[i] = 0;
    });
    if (seen.has(geometry)) return;
    seen.add(geometry);
    repairGeometry(geometry);
  });
}

/** Whether an attribute can hold non-finite values; integers cannot. */
function canHoldBadValues(attribute: Attribute): boolean {
  return attribute.array instanceof Float32Array || attribute.array instanceof Float64Array;
}

/** Sets vectors with a non-finite component to zero. @returns how many */
function zeroBadVectors(attribute: Attribute): number {
  let zeroed = 0;
  for (let vertex = 0; vertex < attribute.count; vertex++) {
    const sum = attribute.getX(vertex) + attribute.getY(vertex) + attribute.getZ(vertex);
    if (sum - sum === 0) continue;
    attribute.setXYZ(vertex, 0, 0, 0);
    zeroed++;
  }
  return zeroed;
}

function replaceBadValues(attribute: Attribute, valueFor: (vertex: number, component: number) => number): number {
  const { count, itemSize } = attribute;
  let replaced = 0;
  for (let vertex = 0; vertex < count; vertex++) {
    for (let component = 0; component < itemSize; component++) {
      // Faster than Number.isFinite on millions of values.
      const value = attribute.getComponent(vertex, component);
      if (value - value === 0) continue;
      const instead = valueFor(vertex, component);
      attribute.setComponent(vertex, component, instead - instead === 0 ? instead : 0);
      replaced++;
    }
  }
  return replaced;
}
