import type { BufferGeometry } from 'three';

/** The number of corners of a geometry, whatever its draw range. */
export const cornerCount = ({ index, attributes }: BufferGeometry): number =>
  (index ?? attributes.position)?.count ?? 0;
