import { type BufferGeometry, Group, MathUtils, Mesh } from 'three';
import { bakeMesh } from '../../viewer/drawing/bakeMesh.js';
import type { Report } from '../../viewer/drawing/buildModel.js';
import { withoutParts } from '../../viewer/drawing/ModelParts.js';
import { meshesOf } from '../../viewer/drawing/meshes.js';
import { triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
import type { ModelFile, ReadMesh } from '../../viewer/files/readModel.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { drawsWithAdjacency, formDrawn } from '../../viewer/settings/settingValues.js';
import { type LoadOptions, loadModelFiles } from '../reading/loadModelFiles.js';
import type { Viewport } from '../viewport/Viewport.js';

/** The maximum number of triangles for a picture, besides those that the page already holds. */
const MOST_TRIANGLES = 4_000_000;

/** How the files of a model are read. */
export type HowRead = Pick<LoadOptions, 'variant' | 'switched'>;

/** A model that was read again for a picture. */
export interface FinerModel extends Pick<ReadMesh, 'simplified'> {
  /** The baked geometry, with everything the settings ask for. */
  geometry: BufferGeometry;
  triangles: number;
}

/**
 * Reads a simplified model again with as many triangles as memory allows, and bakes it for the settings.
 *
 * @param choice how the files are read
 * @throws ModelError with one sentence for the user
 */
export async function finerModel(
  files: readonly ModelFile[],
  viewport: Viewport,
  settings: Settings,
  report: Report,
  signal: AbortSignal,
  { variant, switched }: HowRead = {},
): Promise<FinerModel> {
  const { mesh: whole, simplified } = (await loadModelFiles(files, {
    signal,
    onStage: report,
    most: MOST_TRIANGLES,
    variant,
    switched,
  })) as ReadMesh;
  const mesh = withoutParts(whole, viewport.model?.parts?.hidden ?? []);
  const triangles = triangleCount(mesh);
  const joining = `joining ${triangles.toLocaleString('en')} triangles`;
  const onProgress = (progress: number): void => report(joining, progress);
  const { geometry } = await bakeMesh(mesh, {
    adjacency: drawsWithAdjacency(settings),
    signal,
    onProgress,
    outlines: true,
  });
  const [shown] = meshesOf(viewport.model!.root);
  const drawn = new Mesh(geometry, shown.material);
  try {
    await bakeLook(drawn, settings, report, signal);
  } catch (error) {
    drawn.geometry.dispose();
    throw error;
  }
  return { geometry: drawn.geometry, triangles, simplified };
}

/** Bakes form lines and occlusion for a mesh, if the settings ask for them. */
async function bakeLook(drawn: Mesh, settings: Settings, report: Report, signal: AbortSignal): Promise<void> {
  const root = new Group().add(drawn);
  root.rotation.set(...lookOf(settings).upright);
  const form = formDrawn(settings);
  if (form) {
    const { bakeFurther } = await import('../../viewer/drawing/bakeFurther.js');
    const onProgress = (progress: number): void => report('laying lines along the form', progress);
    const crossAngle = MathUtils.degToRad(settings.crossAngle);
    await bakeFurther(root, { form: { crossAngle, auto: form.auto } }, { signal, onProgress }, (former, made) => {
      if (made !== former) former.dispose();
    });
  }
  if (settings.occlusion === 0) return;
  const { bakeOcclusion } = await import('../../viewer/drawing/bakeOcclusion.js');
  const onProgress = (progress: number): void => report('darkening hollows', progress);
  await bakeOcclusion(root, { signal, onProgress });
}
