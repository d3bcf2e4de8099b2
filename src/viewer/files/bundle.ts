import { ModelError } from './common/ModelError.js';
import { baseName, extensionOf, type ModelFile } from './common/ModelFile.js';

/** The paths in a bundle, a ZIP archive of a model and its look: the description, the folder of the model, and that of the map's images. */
export const BUNDLE = { description: 'three-hatching.json', model: 'model/', strokes: 'strokes/' } as const;

/** The format and version in the description. A higher version was written by a later page, and cannot be read. */
const FORMAT = 'three-hatching drawing';
const VERSION = 1;
const MAX_DESCRIPTION_BYTES = 64 * 1024;

/** The look of a bundled model. Unchecked: it may contain anything, as a link may. */
export interface BundledDrawing {
  /** Settings, camera and views in the form of a link. */
  link: string;
  /** The images of the user's own tonal art map. */
  strokes: ModelFile[];
}

/** The JSON description of a bundle. */
export const describeBundle = (link: string): string =>
  JSON.stringify({ format: FORMAT, version: VERSION, drawing: link }, undefined, 2);

/**
 * The folder of an archive that contains a bundle, with its slash; undefined if the archive is no bundle. Some programs add a top folder
 * when they pack.
 */
export function bundleFolder(entries: readonly { path: string }[]): string | undefined {
  const { description } = BUNDLE;
  return entries
    .filter(({ path }) => baseName(path) === description)
    .map(({ path }) => path.slice(0, -description.length))
    .sort((a, b) => a.length - b.length)[0];
}

/** Whether a file of an archive belongs to the bundle in the given folder. */
export function isOfBundle({ path }: { path: string }, folder: string): boolean {
  if (path === folder + BUNDLE.description) return true;
  if (baseName(path).startsWith('.')) return false;
  if (path.startsWith(folder + BUNDLE.model)) return true;
  return path.startsWith(folder + BUNDLE.strokes) && ['png', 'json'].includes(extensionOf(path) ?? '');
}

/**
 * Reads the model and the look of a bundle.
 *
 * @param unpacked its files, by path
 * @throws ModelError if it has no model, or its description is damaged or of a later version
 */
export function readBundle(
  unpacked: ReadonlyMap<string, Uint8Array>,
  folder: string,
  name: string,
): { files: ModelFile[]; drawing: BundledDrawing } {
  const filesIn = (part: string): ModelFile[] =>
    [...unpacked]
      .filter(([path]) => path.startsWith(folder + part))
      .map(([path, content]) => ({
        name: baseName(path),
        content: new Blob([content as Uint8Array<ArrayBuffer>]),
      }));
  const files = filesIn(BUNDLE.model);
  if (files.length === 0) throw new ModelError(`${name} says how a model is drawn, but holds no model.`);
  const link = readDescription(unpacked.get(folder + BUNDLE.description), name);
  return { files, drawing: { link, strokes: filesIn(BUNDLE.strokes) } };
}

function readDescription(bytes: Uint8Array | undefined, name: string): string {
  let description: Partial<Record<'format' | 'version' | 'drawing', unknown>> | null | undefined;
  try {
    if (bytes && bytes.length <= MAX_DESCRIPTION_BYTES) description = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    // A damaged or overlong description is refused below.
  }
  const { format, version, drawing } = description ?? {};
  if (format === FORMAT && typeof version === 'number' && version > VERSION) {
    throw new ModelError(`${name} was saved by a later version of this page, which this one cannot read.`);
  }
  if (format !== FORMAT || version !== VERSION || typeof drawing !== 'string') {
    throw new ModelError(
      `${name} could not be read; what says how its model is drawn (${BUNDLE.description}) is damaged.`,
    );
  }
  return drawing;
}
