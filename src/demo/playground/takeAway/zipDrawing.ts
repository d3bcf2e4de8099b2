import { BUNDLE, describeBundle } from '../../files/archives/bundle.js';
import { baseName } from '../../files/common/fileName.js';
import type { ModelFile } from '../../files/readModel.js';
import { ZipWriter } from '../../print/ZipWriter.js';

/** What a drawing of the user's own model is made of. */
export interface DrawingFiles {
  model: readonly ModelFile[];
  /** Of a map of the user's own. */
  strokes: readonly ModelFile[];
  /** Settings, camera and views, as a link has them. */
  link: string;
}

/** A model and how it is drawn in one archive, which the page opens as it opens a model. */
export async function zipDrawing({ model, strokes, link }: DrawingFiles): Promise<Blob> {
  const zip = new ZipWriter();
  await zip.add(BUNDLE.description, new Blob([describeBundle(link)]));
  for (const [folder, files] of [
    [BUNDLE.model, model],
    [BUNDLE.strokes, strokes],
  ] as const) {
    // Of several files of one name, only the first is found by a model.
    const names = new Set<string>();
    for (const { name, content } of files) {
      const plain = baseName(name);
      if (!names.has(plain.toLowerCase())) await zip.add(folder + plain, content);
      names.add(plain.toLowerCase());
    }
  }
  return zip.end();
}
