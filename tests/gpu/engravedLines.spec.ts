import { compareEngraved } from './compareEngraved.js';
import { referencePage } from './referencePage.js';

compareEngraved(referencePage);
