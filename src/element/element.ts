/**
 * Importing it makes browsers know `<hatched-model>`. On a server it does nothing.
 *
 * @module three-hatching/element
 */
import { HatchedModelElement } from './HatchedModelElement.js';

export { HatchedModelElement };

const NAME = 'hatched-model';

declare global {
  interface HTMLElementTagNameMap {
    'hatched-model': HatchedModelElement;
  }
}

// Two copies of the library on one page would define it twice, which is an error.
if (globalThis.customElements && !customElements.get(NAME)) customElements.define(NAME, HatchedModelElement);
