import { writeFit } from '../exposure/writeFit.js';
import { hatchingShaders } from '../shaders/hatchingShaders.js';
import { bindEnvironment, blurredEnvironment, environmentAround } from '../three/environments.js';
import { sceneExposure } from './exposure.js';
import { fetchPlans, fetchPlansOf } from './laterPlans.js';

/** What every part needs: the shader files that all materials share, environments, and the fit of exposures. */
export const surface = {
  ...{ hatchingShaders, bindEnvironment, blurredEnvironment, environmentAround },
  ...{ sceneExposure, writeFit, fetchPlans, fetchPlansOf },
};

export type Surface = typeof surface;
