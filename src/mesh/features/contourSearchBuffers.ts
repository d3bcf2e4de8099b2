import type { ContourSearch } from './contourCandidates.js';

/** The buffers of a search, which are transferred to the worker and back. */
export const contourSearchBuffers = ({ search }: { search: ContourSearch }): ArrayBuffer[] => [
  search.positions.buffer,
  search.normals.buffer,
  search.primitives.buffer,
  search.sides.buffer,
  search.list.buffer,
];
