/** What three's exporter of glTF reads blobs with where there is no `FileReader`, as in Node. */
export class BlobReader {
  result: ArrayBuffer | null = null;
  onloadend: (() => void) | null = null;

  async readAsArrayBuffer(blob: Blob): Promise<void> {
    this.result = await blob.arrayBuffer();
    this.onloadend?.();
  }
}
