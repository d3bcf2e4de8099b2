/** Corners of the paper's figure 4, xyz each. */
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
 * The paper's figures 4 and 8: a triangle c in the middle and one across each of its edges, every one with another
 * normal. Drawn in this order, c comes first.
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
