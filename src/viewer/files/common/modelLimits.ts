/** The maximum size of all files of a model together, also unpacked, in bytes. Reading holds several copies of a model in memory. */
export const MAX_BYTES = 512 * 2 ** 20;
