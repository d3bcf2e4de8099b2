import { compareStipple } from './compareStipple.js';
import { referencePage } from './referencePage.js';

compareStipple(referencePage);
