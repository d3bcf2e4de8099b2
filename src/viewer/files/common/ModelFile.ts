/** A file that was dropped or picked, or the file of a built-in model. */
export interface ModelFile {
  name: string;
  content: Blob;
  /** The format as a file extension, used if the content does not tell it; by default that of the name. */
  format?: string | undefined;
}

/** The maximum size of all files of a model together, also unpacked, in bytes. Reading holds several copies of a model in memory. */
export const MAX_BYTES = 512 * 2 ** 20;
