/** Corners of the triangles of figures 4 and 8, as xyz. */
// biome-ignore format: one vertex per line
export const FOUR_TRIANGLES_POSITIONS = [
  -0.5, -0.29,  0.35,
   0.5, -0.29,  0.25,
   0.0,  0.58,  0.3,
  -1.0,  0.58, -0.15,
   1.0,  0.58,  0.0,
   0.0, -1.15, -0.2,
];

/**
 * Figures 4 and 8 of the paper by Suarez et al.: a triangle c in the middle and its three neighbours, all with
 * different normals.
 *
 *        3-------2-------4
 *         \  γ  / \  β  /
 *          \   / c \   /
 *           \ /     \ /
 *            0-------1
 *             \  α  /
 *              \   /
 *                5
 */
export const FOUR_TRIANGLES = { c: [0, 1, 2], alpha: [0, 5, 1], beta: [1, 4, 2], gamma: [2, 3, 0] } as const;
