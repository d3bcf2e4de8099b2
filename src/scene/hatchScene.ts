import type { Object3D } from 'three';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import { resolveOptions } from './applyOptions.js';
import { beginCall, type CallUnderWay } from './beginCall.js';
import type { HatchedScene } from './HatchedScene.js';
import type { LookMakers } from './HatchingCall.js';

export type { LookMakers };

/** The implementation of `applyHatching` for any renderer. The meshes are claimed before it returns. */
export function hatchScene(root: Object3D, given: ApplyHatchingOptions, makers: LookMakers): Promise<HatchedScene> {
  try {
    const call = beginCall(root, resolveOptions(given));
    return call.promised(hatch(call, given, makers));
  } catch (error) {
    return Promise.reject(error);
  }
}

async function hatch(call: CallUnderWay, given: ApplyHatchingOptions, makers: LookMakers): Promise<HatchedScene> {
  try {
    const { HatchedScene } = await import('./HatchedScene.js');
    call.signal.throwIfAborted();
    const hatched = new HatchedScene(call.root, given, makers);
    await hatched.begin(call);
    return hatched;
  } finally {
    call.end();
  }
}
