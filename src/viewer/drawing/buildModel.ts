import { ModelError, toModelError } from '../files/common/ModelError.js';
import { movedExtras } from '../files/common/ModelExtras.js';
import type { ModelScene } from '../files/gltf/parseGltf.js';
import { triangleCount } from '../files/mesh/PlainMesh.js';
import type { ReadModel } from '../files/readModel.js';
import type { HatchedModel } from './HatchedModel.js';
import type { ChooseHidden } from './ModelParts.js';

/** Reports progress: the current step and, if known, how far it is in [0, 1]. */
export type Report = (stage: string, progress?: number) => void;

/** A built-in model that is made by code as a scene, instead of read from a file. */
export interface BuiltInScene {
  kind: 'scene';
  name: string;
  upAxis: 'y';
  scene: ModelScene;
}

/**
 * Builds a hatched model from a file that was read. `notes` are sentences for the caption about what was left out.
 *
 * @param adjacency whether techniques that need triangle adjacency are drawn (`bakeFurther` adds it later)
 * @param hidden chooses the parts that are hidden, if the model has several
 * @throws ModelError with one sentence for the user, also if no triangle is visible
 */
export async function buildModel(
  read: ReadModel | BuiltInScene,
  report: Report,
  signal: AbortSignal,
  adjacency = false,
  hidden?: ChooseHidden,
): Promise<{ model: HatchedModel; notes: string[] }> {
  const hatched = await hatch(read, report, { signal, adjacency, hidden });
  const { model: made } = hatched;
  if ('extras' in read && read.extras) {
    // A scene is scaled to radius 1 here; a mesh was when it was read.
    made.extras = read.kind === 'parts' ? movedExtras(read.extras, made.root.matrix) : read.extras;
  }
  const { triangles, degenerateTriangles } = hatched.model.statistics;
  const isAllHidden = triangles === 0 && (made.parts?.hidden.length ?? 0) > 0;
  if (degenerateTriangles < triangles || isAllHidden) return hatched;
  hatched.model.dispose();
  throw new ModelError('There is nothing to draw: none of the triangles has an area.');
}

async function hatch(
  read: ReadModel | BuiltInScene,
  report: Report,
  options: { signal: AbortSignal; adjacency: boolean; hidden: ChooseHidden | undefined },
): Promise<{ model: HatchedModel; notes: string[] }> {
  const { signal } = options;
  if (read.kind === 'mesh') {
    const count = triangleCount(read.mesh).toLocaleString('en');
    const onProgress = (progress: number): void => report(`joining ${count} triangles`, progress);
    try {
      const { modelOfMesh } = await import('./modelOfMesh.js');
      const model = await modelOfMesh(read.mesh, { ...options, onProgress }, read);
      return { model, notes: read.notes };
    } catch (error) {
      signal.throwIfAborted();
      throw toModelError(read.name, error, 'its mesh');
    }
  }
  report('putting the parts together');
  try {
    const { modelOfScene } = await import('./modelOfScene.js');
    const scene =
      read.kind === 'scene'
        ? read.scene
        : await (await import('../files/gltf/parseGltf.js')).parseGltf(read.parts, signal);
    signal.throwIfAborted();
    const usual = read.kind === 'parts' ? read.usual : undefined;
    let stage = 'joining triangles';
    const onProgress = (progress: number): void => report(stage, progress);
    const onGeometry = (done: number, total: number): void => {
      if (total > 1) stage = `joining triangles, ${done} of ${total} meshes are done`;
    };
    const { model, notes } = await modelOfScene(scene, {
      ...options,
      usual,
      isOfFile: read.kind === 'parts',
      onProgress,
      onGeometry,
    });
    return { model, notes: [...('notes' in read ? read.notes : []), ...notes] };
  } catch (error) {
    signal.throwIfAborted();
    throw toModelError(read.name, error);
  }
}
