/**
 * Names and sizes of the vertex attributes that the bakes write, for geometry, shaders and tests.
 */

/**
 * The attribute that orients strokes, in every layout: the unit normal at the scale of a stroke, in object space. x, y, z are normalised
 * 16-bit integers. w is 0, or the ambient occlusion once `bakeOcclusion` has written it (`occlusionSides.ts`).
 */
export const hatchNormal = { name: 'hatchNormal', itemSize: 4 } as const;

/**
 * The attributes of lines that follow the form, in every layout, 24 bytes a vertex. `formValue` holds φ and φ₂, the functions whose
 * level sets are the lines and those that cross them, as floats. `formSlope` and `formCrossing` hold their gradients in object
 * space as normalised 16-bit integers: x, y, z times 2^w, with w as the integer itself, so that objects of any size fit.
 */
export const formLayout = {
  value: { name: 'formValue', itemSize: 2 },
  slope: { name: 'formSlope', itemSize: 4 },
  crossing: { name: 'formCrossing', itemSize: 4 },
} as const;

/** Integers a vertex of the buffer that `formSlope` and `formCrossing` share. */
export const GRADIENTS_STRIDE = formLayout.slope.itemSize + formLayout.crossing.itemSize;

/**
 * The `corner` vertex layout: every triangle has three vertices of its own, and each carries the positions of all six
 * adjacency vertices V0, V1, V2, Vα, Vβ, Vγ of its triangle (Suarez et al., figure 5).
 *
 * The triangle's own vertices are stored in the order own, next, previous, so that `position` stays what three.js expects.
 * With the corner id the shader restores the order V0, V1, V2, so all three corners compute bit-identical frames.
 *
 * The bake, the geometry, the assembly of the shaders and the tests read this table. Its attributes are interleaved, in this
 * order, in one Float32Array of `CORNER_STRIDE` floats per corner. `position` and `hatchNormal` have buffers of their own.
 */
export const cornerLayout = [
  /** xyz: position of the next corner of the triangle; w: the corner id k ∈ {0, 1, 2}. */
  { name: 'cornerNext', itemSize: 4 },
  /** Position of the previous corner of the triangle. */
  { name: 'cornerPrevious', itemSize: 3 },
  /**
   * Vα, Vβ, Vγ: the vertex opposite to edge 0, 1, 2 in the neighbour across that edge. Where there is no neighbour (border,
   * degenerate, or cut by the crease angle) it is the triangle's own opposite vertex. The neighbour then folds back onto
   * the triangle: its normal is −N_c and its blend factor −1 everywhere, which means "no contribution".
   */
  { name: 'oppositeAlpha', itemSize: 3 },
  { name: 'oppositeBeta', itemSize: 3 },
  { name: 'oppositeGamma', itemSize: 3 },
] as const;

/** Floats per corner in the interleaved buffer. */
export const CORNER_STRIDE = 16;
