/** What is fetched where lines follow the form, besides `LaterForms`. */
export { bakeGroups } from './bakeGroups.js';
export { formGroups } from './formGroups.js';
