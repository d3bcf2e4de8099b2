import type { Object3D } from 'three';
import type { PresetName } from '../look/presetMaterials.js';
import type { ApplyHatchingOptions, HatchingPreset } from './ApplyHatchingOptions.js';
import { lookOptions, resolveOptions } from './applyOptions.js';
import { beginCall, type CallUnderWay } from './beginCall.js';
import type { HatchedScene } from './HatchedScene.js';
import type { LookMakers } from './HatchingCall.js';

export type { LookMakers };

/** The implementation of `applyHatching` for any renderer. The meshes are claimed before it returns. */
export function hatchScene(
  makers: LookMakers,
  root: Object3D,
  look: PresetName | HatchingPreset | ApplyHatchingOptions,
  options: ApplyHatchingOptions,
): Promise<HatchedScene> {
  try {
    const given = lookOptions(look, options);
    const resolved = resolveOptions(given);
    const call = beginCall(root, resolved);
    // What the meshes are going to need is fetched beside the code that hatches them. Failures are left to who needs it.
    if (call.choice.chosen.length > 0) makers.fetchAhead(resolved).catch(() => {});
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
