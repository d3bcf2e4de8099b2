import { Box3, BufferAttribute, BufferGeometry, DoubleSide, type Side, Vector3 } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { prepareHatchingGeometry } from 'three-hatching';
import { BUILT_IN_MODELS, type BuiltInModel } from '../../src/playground/models/models.js';
import { bakeMesh } from '../../src/viewer/drawing/bakeMesh.js';
import type { BuiltInScene } from '../../src/viewer/drawing/buildModel.js';
import { ModelError } from '../../src/viewer/files/common/ModelError.js';
import type { PlainMesh } from '../../src/viewer/files/mesh/PlainMesh.js';
import type { ReadModel } from '../../src/viewer/files/readModel.js';
import { shellChair } from '../pictures/shellChair.js';
import { FOUR_TRIANGLES, FOUR_TRIANGLES_POSITIONS } from './fourTriangles.js';
import { memoize } from './memoize.js';

/** A model of a figure, with a radius of about 1 around the origin, in parts that may have different materials. */
export interface FigureModel {
  parts: Record<string, BufferGeometry>;
  side: Side;
  /** The points that must lie in the picture, as xyz. */
  framedPoints: ArrayLike<number>;
}

type Neighbour = Exclude<keyof typeof FOUR_TRIANGLES, 'c'>;

/** The models of the figures. Some are those of the playground. */
const models = {
  dragon: builtIn('dragon3'),
  bunny: builtIn('bunny'),
  suzanne: builtIn('suzanne'),
  hand,
  teapot: builtIn('teapot'),
  chair,
  fourTriangles: () => triangles('alpha', 'beta', 'gamma'),
  cAndAlpha: () => triangles('alpha'),
  cAndBeta: () => triangles('beta'),
  cAndGamma: () => triangles('gamma'),
};

export type FigureModelName = keyof typeof models;

/** Loads a model and bakes it, with the data of its lines; a second call returns the same. @throws ModelError with one sentence for the user */
export const figureModel = memoize((name: FigureModelName): Promise<FigureModel> => models[name]());

const LOADING = { signal: new AbortController().signal, onStage: () => {} };

/** The mesh of a model. @throws ModelError if it is a scene */
function meshIn(read: ReadModel | BuiltInScene): PlainMesh {
  if (read.kind !== 'mesh') throw new ModelError(`${read.name} has parts that move; a figure takes one mesh.`);
  return read.mesh;
}

function builtIn(name: BuiltInModel): () => Promise<FigureModel> {
  return async () => {
    const mesh = meshIn(await BUILT_IN_MODELS[name].load(LOADING));
    const { geometry, side } = await bakeMesh(mesh, { outlines: true });
    return { parts: { all: geometry }, side, framedPoints: mesh.positions };
  };
}

async function hand(): Promise<FigureModel> {
  const { loadHand } = await import('../../src/playground/models/loadHand.js');
  const mesh = await loadHand();
  // Lines of some presets follow the form.
  const { geometry } = await bakeMesh(mesh, { outlines: true, form: true });
  return { parts: { all: geometry }, side: DoubleSide, framedPoints: mesh.positions };
}

async function chair(): Promise<FigureModel> {
  const { shell, legs, cushion } = shellChair();
  const sources = { shell, legs: mergeGeometries(legs), cushion };
  const framedPoints = Object.values(sources).flatMap((source) => [...source.getAttribute('position').array]);
  const bounds = new Box3().setFromArray(framedPoints);
  const { x, y, z } = bounds.getCenter(new Vector3()).negate();
  const parts: FigureModel['parts'] = {};
  for (const [name, source] of Object.entries(sources))
    parts[name] = await prepareHatchingGeometry(source.translate(x, y, z), { adjacency: true });
  return {
    parts,
    side: DoubleSide,
    framedPoints: Object.values(sources).flatMap((s) => [...s.getAttribute('position').array]),
  };
}

/** Triangle c and some of its neighbours, baked together, as the parts `centre` and `others`. */
async function triangles(...neighbours: Neighbour[]): Promise<FigureModel> {
  const source = new BufferGeometry();
  source.setAttribute('position', new BufferAttribute(new Float32Array(FOUR_TRIANGLES_POSITIONS), 3));
  source.setIndex([...FOUR_TRIANGLES.c, ...neighbours.flatMap((name) => FOUR_TRIANGLES[name])]);
  const baked = await prepareHatchingGeometry(source, { layout: 'corner' });
  const parts = { centre: range(baked, 0, 3), others: range(baked, 3, 3 * neighbours.length) };
  // The points of all four triangles, so that they stay in the same place in every panel.
  return { parts, side: DoubleSide, framedPoints: FOUR_TRIANGLES_POSITIONS };
}

/** A range of a geometry's corners, as a geometry that shares its attributes. */
function range(geometry: BufferGeometry, start: number, count: number): BufferGeometry {
  const part = new BufferGeometry();
  for (const [name, attribute] of Object.entries(geometry.attributes)) part.setAttribute(name, attribute);
  part.setDrawRange(start, count);
  return part;
}
