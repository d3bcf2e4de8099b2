import { runToEnd } from '../../mesh/phases.js';
import type { FileChangeKind } from '../../viewer/files/common/fileChanges.js';
import { toModelError } from '../../viewer/files/common/ModelError.js';
import type { FileCamera } from '../../viewer/files/common/ModelExtras.js';
import { type OnStage, reportStage } from '../../viewer/files/common/stages.js';
import { checkTriangleCount, meshBuffers, triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
import { needsCoarse } from '../../viewer/files/mesh/plainNormals.js';
import type { UpAxis } from '../../viewer/files/mesh/UpAxis.js';
import { withPictures } from '../../viewer/files/pictures/decodePictures.js';
import { type ModelFile, type ReadMesh, type ReadModel, readModel } from '../../viewer/files/readModel.js';
import { type CameraSight, cameraSights } from '../../viewer/views/cameraSights.js';
import { type ChosenView, chooseViews } from '../../viewer/views/chooseViews.js';
import type { ViewTriangles } from '../../viewer/views/viewSurface.js';
import { withViews } from '../../viewer/views/withViews.js';
import { PAGE_SURROUNDINGS } from './pageSurroundings.js';
import { coarseModel, isTooFine, simplified, withoutHeavyPictures } from './readLarge.js';

/** Options for reading a model in another way than by default. */
export interface FineRequest {
  files: readonly ModelFile[];
  /** The maximum number of triangles; undefined for as many as a sheet shows. */
  most: number | undefined;
  /** Index of the material variant. */
  variant: number | undefined;
  /** Kinds of changes that are switched from what is usual. */
  switched: readonly FileChangeKind[] | undefined;
  /** The up axis for which views are wanted, or `file` for that of the file; undefined if none are. */
  viewsFor: UpAxis | 'file' | undefined;
}

/** A request for the views that show the triangles of a scene best, and for what cameras see of them. */
export interface ViewRequest {
  triangles: ViewTriangles;
  up: UpAxis;
  cameras: readonly FileCamera[];
}

/** The views that show the triangles of a scene best, and what each camera sees of them. */
export interface FoundViews {
  views: readonly ChosenView[];
  sights: readonly CameraSight[];
}

/** A message from the worker: progress, result, or an error's sentence. */
export type ModelWorkerMessage =
  | { kind: 'stage'; stage: string; bytes: number | undefined }
  | { kind: 'coarse'; model: ReadModel }
  | { kind: 'done'; model: ReadModel }
  | ({ kind: 'views' } & FoundViews)
  | { kind: 'failed'; sentence: string };

const post = (message: ModelWorkerMessage, transfer: Transferable[] = []): void => postMessage(message, { transfer });

/** The buffers and bitmaps to transfer. Several pictures may share a bitmap. */
function transferables(model: ReadModel): Transferable[] {
  if (model.kind === 'mesh') {
    const bitmaps = model.pictures.flatMap((picture) => (picture ? [picture.bitmap] : []));
    // The placeholder may share the mesh's normals.
    const buffers = new Set([...meshBuffers(model.mesh), ...(model.plainNormals ? [model.plainNormals.buffer] : [])]);
    return [...buffers, ...new Set(bitmaps)] as Transferable[];
  }
  const { arrays, bitmaps } = model.parts;
  return [...arrays, ...(bitmaps.filter((bitmap) => bitmap !== undefined) as Transferable[])];
}

/** Posts a coarse copy of a model, to be drawn at once. */
function postCoarse(model: ReadMesh): void {
  const coarse = coarseModel(model);
  post({ kind: 'coarse', model: coarse }, transferables(coarse));
}

/** Simplifies a model. If that fails, the full model is used if it can be drawn. */
async function lessOf(model: ReadMesh, onStage: OnStage, most?: number): Promise<ReadMesh> {
  const stage = `simplifying ${triangleCount(model.mesh).toLocaleString('en')} triangles`;
  try {
    return await simplified(model, reportStage(stage, onStage), most);
  } catch (error) {
    console.warn(`The model is drawn with all its triangles, because it could not be simplified. ${error}`);
    return model;
  }
}

addEventListener('message', async ({ data }: MessageEvent<readonly ModelFile[] | FineRequest | ViewRequest>) => {
  try {
    if ('triangles' in data) {
      const { triangles, up, cameras } = data;
      const views = runToEnd(chooseViews(triangles, up));
      post({ kind: 'views', views, sights: cameraSights(triangles, cameras) });
      return;
    }
    const { files, most, variant, switched, viewsFor }: Partial<FineRequest> & Pick<FineRequest, 'files'> =
      'files' in data ? data : { files: data };
    const onStage: OnStage = (stage, bytes) => post({ kind: 'stage', stage, bytes });
    const read = withoutHeavyPictures(await readModel(files, onStage, PAGE_SURROUNDINGS, { variant, switched }));
    const seen = viewsFor ? withViews(read, viewsFor === 'file' ? read.upAxis : viewsFor, onStage) : read;
    const model = await withPictures(seen, onStage, PAGE_SURROUNDINGS);
    const isLessDrawn = isTooFine(model, most);
    if (most === undefined && model.kind === 'mesh' && needsCoarse(model.mesh)) postCoarse(model);
    const drawn = isLessDrawn ? await lessOf(model, onStage, most) : model;
    if (drawn.kind === 'mesh') checkTriangleCount(triangleCount(drawn.mesh));
    post({ kind: 'done', model: drawn }, transferables(drawn));
  } catch (error) {
    post({ kind: 'failed', sentence: toModelError('The file', error).message });
  }
});
