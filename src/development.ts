/**
 * The library with the checks of first draws, which warn of mistakes in a scene: what `three-hatching` means where a page is developed, by
 * the condition `development` in package.json. Production builds have no trace of them.
 */
import { addChecks } from './material/firstDraw/loadChecks.js';

addChecks(() => import('./material/firstDraw/checkDraws.js'));

export * from './index.js';
