/** A file that was dropped or picked, or that holds a built-in model. */
export interface ModelFile {
  name: string;
  content: Blob;
}
