import type { Camera, Mesh, Object3D } from 'three';
import { drawsHand } from '../../look/queries.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { fetchPart } from '../../material/parts/parts.js';
import { runSliced } from '../../mesh/runSliced.js';
import { runTaskOf } from '../../worker/runTask.js';
import type { TaskSet } from '../../worker/TaskSet.js';
import type { DrawnScene } from '../DrawnScene.js';
import type { lineTasks } from '../drawLines.js';
import type { SurfaceLines } from '../streamlines/SurfaceLines.js';
import { type DrawSVGOptions, planOf } from './DrawSVGOptions.js';
import type { LeftOut } from './leftOut.js';
import { readScene } from './readScene.js';

/** The task of drawing lines, for `runTaskOf`. */
const lineDrawing: TaskSet<typeof lineTasks> = {
  fetchTasks: async () => (await import('../drawLines.js')).lineTasks,
  requestBuffers: { drawLines: ({ scene }) => buffersOf(scene) },
  fetchWorker: async () => (await import('./inlineSvgWorker.js')).createInlineSvgWorker,
};

/** The large arrays of a scene, which may be transferred. */
function buffersOf({ corners, sides, surfaces, stippled, outlines }: DrawnScene): ArrayBuffer[] {
  const arrays = [
    ...[corners, sides],
    ...[...surfaces, ...stippled].flatMap(({ surface: { vertices, placeOf, triangles, parents } }) => [
      ...[vertices, placeOf, triangles, parents],
    ]),
    ...outlines.flatMap(({ mesh: { positions, normals, anchors, curvatures, triangles, placeOf } }) => [
      ...[positions, normals, anchors, curvatures, triangles, placeOf],
    ]),
  ];
  return [...new Set(arrays.map(({ buffer }) => buffer as ArrayBuffer))];
}

/** Fetches the code that prepares the strokes of hands, if materials of a scene draw with one. */
async function fetchHands(scene: Object3D): Promise<void> {
  let isDrawn = false;
  scene.traverse((object) => {
    for (const material of [(object as Mesh).material ?? []].flat())
      isDrawn ||= 'isHatchingMaterial' in material && drawsHand(material as HatchingMaterial);
  });
  if (isDrawn) await fetchPart('handStrokes');
}

/** The share of reading the scene in the progress. */
const READING = 0.12;

/** A layer of a drawing. Lengths are in millimetres. */
export interface SVGDrawingLayer {
  /** As in the file, without its number. */
  name: string;
  /** Such as `#1c1a17`. */
  ink: string;
  /** The width of the pen; null for a print. */
  pen: number | null;
  /** Number of paths, each of which takes a lift of a pen, and of points of their middle lines. */
  paths: number;
  points: number;
  /** Total length of its paths, and travel of the lifted pen before and after ordering. */
  drawn: number;
  travelBefore: number;
  travelAfter: number;
  /** The estimated time of plotting, seconds; null for a print. */
  plotSeconds: number | null;
  /** The time from the beginning of the layer at which each path is drawn, in the order of the file, seconds; null for a print. */
  pathSeconds: Float64Array | null;
}

/** A drawing as lines. Lengths are in millimetres. */
export interface SVGDrawing {
  /** The document. */
  svg: string;
  /** Number of paths, and of points of their middle lines. */
  paths: number;
  points: number;
  /** Traced pieces of lines, before hidden ones were removed. */
  segments: number;
  /** Travel of the lifted pen: in the order in which paths were found, and as they are ordered. */
  travelBefore: number;
  travelAfter: number;
  /** Total length of all paths. */
  drawn: number;
  /** The layers of the file with their counts, in the order in which they are drawn. */
  layers: readonly SVGDrawingLayer[];
  /** The estimated time of plotting in seconds, without changes of pens; null for a print. */
  plotSeconds: number | null;
  /** With `split: 'pen'`, a file for each pen: the name of its layer, or of its ink and width. */
  files: readonly { name: string; svg: string }[];
  /** With `dxf: true`, the drawing as a DXF file of release 12; otherwise null. */
  dxf: string | null;
  /** With `before`, the even lines on their surfaces, for the next frame; otherwise null. */
  surfaceLines: readonly SurfaceLines[] | null;
  /** Duration of the drawing, seconds. */
  seconds: number;
  /** What the drawing does not show as the canvas does. */
  leftOut: readonly LeftOut[];
}

/**
 * Draws a hatched scene as lines of a vector file, as a camera sees it: engraved lines and outlines are curves on the surfaces, and become
 * paths. It needs neither a renderer nor a page, and gives the same bytes with and without them. The scene is read in slices, and drawn in
 * a worker, or in slices without one.
 *
 * It draws meshes with a `HatchingMaterial` of the techniques `engraving`, `pen`, `woodcut` and `stipple`, and `HatchingOutlines`.
 * What cannot be drawn as lines is listed in `leftOut`.
 *
 *     await applyHatching(scene, 'engraving');
 *     const { svg } = await drawSVG(scene, camera, { sheet: 'A4', margin: 12 });
 *
 * @throws TypeError or RangeError, as the reason of the rejected promise, for wrong options
 */
export async function drawSVG(scene: Object3D, camera: Camera, options: DrawSVGOptions = {}): Promise<SVGDrawing> {
  if (!scene?.isObject3D) throw new TypeError('drawSVG: scene must be an Object3D, such as a Scene.');
  if (!('isCamera' in (camera ?? {})))
    throw new TypeError('drawSVG: camera must be a PerspectiveCamera or an OrthographicCamera.');
  const { elements } = camera.projectionMatrix;
  const plan = planOf(options, elements[5] > elements[0]);
  const { signal, onProgress, createWorker, shadows = true, clippingPlanes = [] } = options;
  const start = performance.now();
  await fetchHands(scene);
  const read = async (onRead?: (progress: number) => void) => {
    const found = await runSliced(readScene(scene, camera, shadows, clippingPlanes, plan.pens), {
      signal,
      onProgress: onRead,
    });
    for (const { look } of found.drawn.outlines) look.hidden = options.hidden ?? look.hidden;
    return found;
  };
  const { drawn, leftOut } = await read((progress) => onProgress?.(READING * progress));
  const drawing = await runTaskOf(
    lineDrawing,
    'drawLines',
    { scene: drawn, plan },
    { signal, createWorker, onProgress: (progress) => onProgress?.(READING + (1 - READING) * progress) },
    async () => ({ scene: (await read()).drawn, plan }),
  );
  return { ...drawing, leftOut, seconds: (performance.now() - start) / 1000 };
}
