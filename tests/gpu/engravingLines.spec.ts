import { compareEngraving } from './compareEngraving.js';
import { referencePage } from './referencePage.js';

compareEngraving(referencePage);
