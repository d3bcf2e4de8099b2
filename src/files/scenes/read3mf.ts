import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';
import { errorMessage } from '../common/errorMessage.js';
import { ModelError } from '../common/ModelError.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';
import { withStandIns } from './standIns.js';

/** Reads a 3MF file. @throws ModelError if it is damaged; Error as the loader has it */
export function read3mf(bytes: Uint8Array, name: string): LoadedScene {
  try {
    return sceneOf(
      withStandIns(() => new ThreeMFLoader().parse(bytes.slice().buffer)),
      name,
    );
  } catch (error) {
    // The loader says so, too, when it could not unpack the file.
    if (!errorMessage(error).includes('relationship file')) throw error;
    throw new ModelError(`${name} is damaged or cut short: its list of parts is missing.`);
  }
}
