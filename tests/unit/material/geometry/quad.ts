import { BufferGeometry, Float32BufferAttribute, type TypedArray } from 'three';

//  2 ── 3
//  │ ╲  │
//  0 ── 1
export const quadPositions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];

export const quadIndices = [0, 1, 2, 2, 1, 3];

export function quad(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(quadPositions, 3));
  geometry.setIndex(quadIndices);
  return geometry;
}

/** All parts of a geometry whose change a caller could observe. */
export function snapshot(geometry: BufferGeometry) {
  // A value that is no attribute may be in place of one.
  const bytes = (attribute: { array: TypedArray } | null | undefined) => {
    const array = attribute?.array;
    if (!array) return [String(attribute)];
    // The values of a buffer that was transferred cannot be read.
    return [array.constructor.name, array.byteLength, ...(array.byteLength > 0 ? array : [])];
  };
  return structuredClone({
    index: geometry.index && bytes(geometry.index),
    attributes: Object.entries(geometry.attributes ?? {}).map(([name, attribute]) => [name, ...bytes(attribute)]),
    morphs: Object.values(geometry.morphAttributes ?? {}).flatMap((targets) => [targets ?? []].flat().map(bytes)),
    groups: geometry.groups,
    drawRange: geometry.drawRange,
    userData: geometry.userData,
    bounds: [geometry.boundingBox, geometry.boundingSphere],
  });
}
