/** The name in `userData` of a mesh for the elements of a matrix from its object space to a frame that it shares with other meshes. */
export const FIELD_FRAME = 'hatchingField';
