/**
 * The most bytes that all files of a model may have together, also once they are unpacked. A model is held in memory several times while it
 * is read.
 */
export const MAX_BYTES = 512 * 2 ** 20;
