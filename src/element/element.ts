/**
 * Importing this module defines the custom element `<hatched-model>`. On a server it does nothing.
 *
 * @module three-hatching/element
 */
import { HatchedModelElement } from './HatchedModelElement.js';

export type { HatchedModelAttributes } from './HatchedModelAttributes.js';

export { HatchedModelElement };

const NAME = 'hatched-model';

declare global {
  interface HTMLElementTagNameMap {
    'hatched-model': HatchedModelElement;
  }
}

// It would be an error if a second copy of the library on the same page defined the element again.
if (globalThis.customElements && !customElements.get(NAME)) customElements.define(NAME, HatchedModelElement);
