/**
 * The attribute that gives strokes their frame, in every layout: the unit normal at the scale of a stroke, in object space.
 * x, y, z are normalised 16-bit integers; a fourth one, 0, aligns entries to eight bytes.
 */
export const hatchNormal = { name: 'hatchNormal', itemSize: 4 } as const;
