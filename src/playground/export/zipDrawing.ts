import { BUNDLE, describeBundle } from '../../viewer/files/archives/bundle.js';
import { baseName } from '../../viewer/files/common/fileName.js';
import type { ModelFile } from '../../viewer/files/readModel.js';
import { ZipWriter } from '../print/BlobWriter.js';

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
