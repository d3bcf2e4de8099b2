/** A file that was dropped or picked, or that holds a built-in model. */
export interface ModelFile {
  name: string;
  content: Blob;
  /** What its format is if its content does not tell, as an extension; left out, that of its name. */
  format?: string | undefined;
}
