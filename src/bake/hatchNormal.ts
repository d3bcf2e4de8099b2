/**
 * The attribute that gives strokes their frame, in every layout: the unit normal at the scale of a stroke, in object space.
 * x, y, z are normalised 16-bit integers. The fourth is 0; `bakeOcclusion` writes minus the ambient occlusion there.
 */
export const hatchNormal = { name: 'hatchNormal', itemSize: 4 } as const;
