/** The code, beside `LaterForms`, that is fetched if lines follow the form. */
export { bakeGroups } from './bakeGroups.js';
export { formGroups } from './formGroups.js';
