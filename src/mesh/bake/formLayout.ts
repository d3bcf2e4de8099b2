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
