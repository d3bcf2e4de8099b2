import { FBXLoader } from 'three/addons/loaders/FBXLoader.js';
import { ModelError } from '../common/ModelError.js';
import { withFakeDocument } from './fakeDocument.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';

/** The number of bytes that are searched for the version. */
const HEAD_BYTES = 65536;
/** The oldest versions that three's loader reads. */
const MIN_VERSION = { ascii: 7000, binary: 6400 };

/** Reads an FBX file, with its clips. @throws ModelError if it is older than what three's loader reads; Error of the loader */
export function readFbx(bytes: Uint8Array, name: string): LoadedScene {
  checkVersion(bytes, name);
  return sceneOf(
    withFakeDocument(() => new FBXLoader().parse(bytes.slice().buffer, '')),
    name,
  );
}

function checkVersion(bytes: Uint8Array, name: string): void {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, HEAD_BYTES));
  const isBinary = head.startsWith('Kaydara FBX Binary');
  const version = isBinary
    ? new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength).getUint32(23, true)
    : Number(/FBXVersion:\s*(\d+)/.exec(head)?.[1]);
  if (Number.isNaN(version)) throw new ModelError(`${name} is damaged: it does not say its version.`);
  if (version < (isBinary ? MIN_VERSION.binary : MIN_VERSION.ascii)) {
    throw new ModelError(`${name} is FBX version ${version / 1000}; this page reads version 7 and newer.`);
  }
}
