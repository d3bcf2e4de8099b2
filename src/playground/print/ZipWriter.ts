import { Zip, ZipPassThrough } from 'three/addons/libs/fflate.module.js';
import { BlobWriter } from './BlobWriter.js';

/** Packs files into an archive one at a time and without compression, since PNG is compressed already. */
export class ZipWriter {
  private readonly blob = new BlobWriter();
  private readonly zip = new Zip((error, part) => {
    if (error) throw error;
    this.blob.write(part as Uint8Array<ArrayBuffer>);
  });

  async add(name: string, content: Blob): Promise<void> {
    const entry = new ZipPassThrough(name);
    this.zip.add(entry);
    const reader = content.stream().getReader();
    for (let part = await reader.read(); !part.done; part = await reader.read()) entry.push(part.value.slice());
    entry.push(new Uint8Array(), true);
  }

  end(): Blob {
    this.zip.end();
    return this.blob.end('application/zip');
  }
}
