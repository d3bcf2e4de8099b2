import { Zip, ZipPassThrough } from 'three/addons/libs/fflate.module.js';
import { BUNDLE, describeBundle } from '../../viewer/files/bundle.js';
import { baseName } from '../../viewer/files/common/ModelFile.js';
import type { ModelFile } from '../../viewer/files/readModel.js';

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

/** The parts of a drawing with the user's own model. */
export interface DrawingFiles {
  model: readonly ModelFile[];
  /** The images of the user's own map, if there is one. */
  strokes: readonly ModelFile[];
  /** Settings, camera and views, as the text of a link. */
  link: string;
}

/** Packs a model and its look into one archive, which the page opens like a model. */
export async function zipDrawing({ model, strokes, link }: DrawingFiles): Promise<Blob> {
  const zip = new ZipWriter();
  await zip.add(BUNDLE.description, new Blob([describeBundle(link)]));
  for (const [folder, files] of [
    [BUNDLE.model, model],
    [BUNDLE.strokes, strokes],
  ] as const) {
    // If several files have the same name, a model finds only the first.
    const names = new Set<string>();
    for (const { name, content } of files) {
      const plain = baseName(name);
      if (!names.has(plain.toLowerCase())) await zip.add(folder + plain, content);
      names.add(plain.toLowerCase());
    }
  }
  return zip.end();
}
