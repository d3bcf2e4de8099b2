/** The lists of primitives that may hold an outline. Outlines without a list look the same, and take longer to draw. */
export { ContourList } from './ContourList.js';
export { InstanceList } from './InstanceList.js';
