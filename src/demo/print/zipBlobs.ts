import { Zip, ZipPassThrough } from 'three/addons/libs/fflate.module.js';
import { BlobWriter } from './BlobWriter.js';

/** Packs files into an archive one after the other, as they are: PNG is compressed already. */
export async function zipBlobs(files: readonly { name: string; content: Blob }[]): Promise<Blob> {
  const blob = new BlobWriter();
  const zip = new Zip((error, part) => {
    if (error) throw error;
    blob.write(part as Uint8Array<ArrayBuffer>);
  });
  for (const { name, content } of files) {
    const entry = new ZipPassThrough(name);
    zip.add(entry);
    const reader = content.stream().getReader();
    for (let part = await reader.read(); !part.done; part = await reader.read()) entry.push(part.value.slice());
    entry.push(new Uint8Array(), true);
  }
  zip.end();
  return blob.end('application/zip');
}
