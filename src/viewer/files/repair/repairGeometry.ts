import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute, Mesh, Object3D } from 'three';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Vertex colours that are not numbers become white: the paper shows, and strokes are drawn as anywhere else. */
const WHITE = 1;

/**
 * Repairs what a file holds but no picture can be drawn from, in place: colours, texture coordinates, tangents, skin weights and
 * morph targets that are not numbers. Colours become white, all others zero; morph targets that hold whole positions or
 * normals take the value of the unmorphed vertex. Normals that are zero or not numbers become zero: the library computes
 * these from the surface, with its creases.
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

/** Repairs the geometry of every mesh at or below an object, each once, and morph target influences that are not numbers. */
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

/** Whether an attribute may hold values that are not finite: integers always are. */
function canHoldBadValues(attribute: Attribute): boolean {
  return attribute.array instanceof Float32Array || attribute.array instanceof Float64Array;
}

/** Sets vectors to zero that have a component which is not a number: they have no direction. @returns how many */
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
      // Faster than Number.isFinite, on millions of values.
      const value = attribute.getComponent(vertex, component);
      if (value - value === 0) continue;
      const instead = valueFor(vertex, component);
      attribute.setComponent(vertex, component, instead - instead === 0 ? instead : 0);
      replaced++;
    }
  }
  return replaced;
}
