import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import {
  HatchingMaterial,
  HatchingOutlines,
  type HatchingTechnique,
  type PrepareHatchingGeometryOptions,
  prepareHatchingGeometry,
} from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { Stage } from '../Stage.js';
import { torusMesh } from '../torusMesh.js';

const SIZE = 128;

/** Frames that are drawn before the first one that is measured. They compile programs and fill caches. */
const WARM_UP = 100;

export interface MemoryPlan {
  triangles: number;
  technique: HatchingTechnique;
  layout: PrepareHatchingGeometryOptions['layout'];
  outlines?: boolean;
  /** Whether the form's field is baked too. */
  form?: boolean;
}

let stage: Stage | undefined;
let mesh: Mesh | undefined;

/** Bakes and draws a torus once. Returns the bytes of the result and of its source, and the longest task of the main thread in ms. */
export async function measureMemory({ triangles, technique, layout, outlines = false, form = false }: MemoryPlan) {
  let longestTask = 0;
  const tasks = new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) longestTask = Math.max(longestTask, duration);
  });
  const source = geometryOf(torusMesh(triangles));
  // The time to generate the torus does not count.
  await pause();
  tasks.observe({ entryTypes: ['longtask'] });
  const start = performance.now();
  const geometry = await prepareHatchingGeometry(source, { layout, outlines, form });
  const seconds = (performance.now() - start) / 1000;
  await pause();
  tasks.disconnect();
  stage = new Stage(SIZE);
  mesh = new Mesh(geometry, new HatchingMaterial(plainLook({ technique })));
  if (outlines) mesh.add(new HatchingOutlines(mesh));
  await stage.timeFrame(mesh);
  const sourceBytes = source.attributes.position!.array.byteLength + source.index!.array.byteLength;
  return {
    triangles: source.index!.count / 3,
    seconds,
    longestTask,
    bytes: geometry.userData.hatching.bytes as number,
    sourceBytes,
  };
}

/** Draws frames while the camera turns, of what `measureMemory` has prepared. */
export async function drawFrames(count = WARM_UP): Promise<void> {
  for (let frame = 0; frame < count; frame++) {
    stage!.turnCamera(1);
    await stage!.timeFrame(mesh!);
  }
}

/** The browser reports a long task a little after it has ended. */
const pause = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 200));

function geometryOf({ positions, indices }: ReturnType<typeof torusMesh>): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return geometry.setIndex(new BufferAttribute(indices, 1));
}
