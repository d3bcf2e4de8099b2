/**
 * The attribute that orients strokes, in every layout: the unit normal at the scale of a stroke, in object space. x, y, z are
 * normalised 16-bit integers. w is 0, unless `bakeOcclusion` has written minus the ambient occlusion to it.
 */
export const hatchNormal = { name: 'hatchNormal', itemSize: 4 } as const;
