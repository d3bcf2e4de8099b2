import { USDLoader } from 'three/addons/loaders/USDLoader.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { mendFans } from './mendFans.js';
import { mendUsd, plainUsda, type UsdComposer } from './mendUsd.js';
import { withoutDocument } from './withoutDocument.js';

const SIGNATURE = '#usda';

/** Reads a USD file: text, binary or package (USDZ). @throws Error of the loader */
export async function readUsd(bytes: Uint8Array, name: string): Promise<LoadedScene> {
  const notes = new Set<string>();
  const restore = await mendComposer(notes);
  try {
    const isText = new TextDecoder('latin1').decode(bytes.subarray(0, SIGNATURE.length)) === SIGNATURE;
    const content = isText ? plainUsda(new TextDecoder().decode(bytes)) : bytes.slice().buffer;
    const root = withoutDocument(() => new USDLoader().parse(content));
    if (root) mendFans(root);
    return { ...sceneOf(root, name), notes: [...notes] };
  } finally {
    restore();
  }
}

/** Versions of three.js without this composer module are left unpatched. */
async function mendComposer(notes: Set<string>): Promise<() => void> {
  try {
    const { USDComposer } = await import('three/addons/loaders/usd/USDComposer.js');
    return mendUsd(USDComposer.prototype as UsdComposer, notes);
  } catch {
    return () => {};
  }
}
