/** A mesh that can be simplified: vertices stay as they are, and fewer triangles are drawn between some of them. */
export interface SimplifiableMesh {
  /** xyz of every vertex. */
  positions: Float32Array;
  /** Values that a simpler mesh shall have in the same places, `weights.length` per vertex. */
  attributes: Float32Array;
  /** How far, in object units, a vertex may move for a difference of 1 in each of them. */
  weights: number[];
}

/** Triangles of a mesh, and how far they lie from those of the whole mesh. */
export interface Simplified {
  indices: Uint32Array<ArrayBuffer>;
  /** In object units. */
  error: number;
}
