/** A file that was dropped or picked, or the file of a built-in model. */
export interface ModelFile {
  name: string;
  content: Blob;
  /** The format as a file extension, used if the content does not tell it; by default that of the name. */
  format?: string | undefined;
}
