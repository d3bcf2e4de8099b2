import { compareAnchored } from './compareAnchored.js';
import { referencePage } from './referencePage.js';

compareAnchored(referencePage);
