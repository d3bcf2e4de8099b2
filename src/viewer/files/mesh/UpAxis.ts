/** The up axis of a model. */
export type UpAxis = 'x' | 'y' | 'z' | '-x' | '-y' | '-z';
