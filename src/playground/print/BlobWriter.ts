/** Bytes are collected to parts of this size and handed to the browser, which may store them on disk. */
const PART_BYTES = 4 << 20;

/** Collects a file in parts. The script itself holds a few megabytes at most. */
export class BlobWriter {
  private readonly whole: Blob[] = [];
  private parts: Uint8Array<ArrayBuffer>[] = [];
  private length = 0;

  readonly write = (part: Uint8Array<ArrayBuffer>): void => {
    this.parts.push(part);
    this.length += part.length;
    if (this.length < PART_BYTES) return;
    this.whole.push(new Blob(this.parts));
    this.parts = [];
    this.length = 0;
  };

  end(type: string): Blob {
    return new Blob([...this.whole, ...this.parts], { type });
  }
}
