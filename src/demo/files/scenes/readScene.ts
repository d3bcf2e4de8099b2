import type { Mesh, Object3D } from 'three';
import { errorMessage } from '../common/errorMessage.js';
import { ModelError } from '../common/ModelError.js';
import { check3ds } from './check3ds.js';
import type { LoadedScene } from './LoadedScene.js';
import { withStandIns } from './standIns.js';
import { withoutBackground } from './withoutBackground.js';

/** Formats that loaders of three's read whose result is a scene. */
export type SceneFormat = 'fbx' | '3ds' | 'usd' | 'wrl' | 'dae' | '3mf';

/** Where the version of an FBX file is looked for. */
const HEAD_BYTES = 65536;
/** FBX before these is laid out differently. */
const MIN_FBX = { ascii: 7000, binary: 6400 };

/**
 * Reads a file with the loader that three has for it, which is fetched only now.
 *
 * @returns the scene, with its clips
 * @throws Error as the loader has it
 */
export async function readScene(format: SceneFormat, bytes: Uint8Array, name: string): Promise<LoadedScene> {
  const root = await load(format, bytes, name);
  if (format === '3ds') root?.traverse(withoutNormals);
  if (!root) throw new ModelError(`${name} could not be read; its outline seems to be damaged.`);
  return {
    root: withoutBackground(root),
    upAxis: format === '3ds' || format === '3mf' ? 'z' : 'y',
  };
}

/** The loader's normals are smooth across every edge. Without them, they are computed later, with edges kept. */
function withoutNormals(object: Object3D): void {
  (object as Partial<Mesh>).geometry?.deleteAttribute('normal');
}

async function load(format: SceneFormat, bytes: Uint8Array, name: string): Promise<Object3D | undefined> {
  // Exactly these bytes: the loaders take whole buffers only.
  const buffer = bytes.slice().buffer;
  const text = (): string => new TextDecoder().decode(bytes);
  switch (format) {
    case 'fbx': {
      checkFbx(bytes, name);
      const { FBXLoader } = await import('three/addons/loaders/FBXLoader.js');
      return withStandIns(() => new FBXLoader().parse(buffer, ''));
    }
    case '3ds': {
      check3ds(bytes, name);
      const { TDSLoader } = await import('three/addons/loaders/TDSLoader.js');
      return withStandIns(() => new TDSLoader().parse(buffer, ''));
    }
    case 'usd': {
      const { USDLoader } = await import('three/addons/loaders/USDLoader.js');
      return withStandIns(() => new USDLoader().parse(buffer));
    }
    case 'wrl': {
      const { VRMLLoader } = await import('three/addons/loaders/VRMLLoader.js');
      return withStandIns(() => new VRMLLoader().parse(text(), ''));
    }
    case 'dae': {
      const { ColladaLoader } = await import('three/addons/loaders/ColladaLoader.js');
      return withStandIns(() => new ColladaLoader().parse(text(), '')?.scene);
    }
    default: {
      const { ThreeMFLoader } = await import('three/addons/loaders/3MFLoader.js');
      try {
        return withStandIns(() => new ThreeMFLoader().parse(buffer));
      } catch (error) {
        // What the loader says when it could not unpack the file, too.
        if (!errorMessage(error).includes('relationship file')) throw error;
        throw new ModelError(`${name} is damaged or cut short: its list of parts is missing.`);
      }
    }
  }
}

/** @throws ModelError if the file is older than what three's loader reads */
function checkFbx(bytes: Uint8Array, name: string): void {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, HEAD_BYTES));
  const isBinary = head.startsWith('Kaydara FBX Binary');
  const version = isBinary
    ? new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength).getUint32(23, true)
    : Number(/FBXVersion:\s*(\d+)/.exec(head)?.[1]);
  if (Number.isNaN(version)) throw new ModelError(`${name} is damaged: it does not say its version.`);
  if (version < (isBinary ? MIN_FBX.binary : MIN_FBX.ascii)) {
    throw new ModelError(`${name} is FBX version ${version / 1000}; this page reads version 7 and newer.`);
  }
}
