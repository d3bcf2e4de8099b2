/**
 * The key in a mesh's `userData` for the matrix, as an array, from its object space to the coordinate frame that its lines share with
 * other meshes.
 */
export const FIELD_FRAME = 'hatchingField';
