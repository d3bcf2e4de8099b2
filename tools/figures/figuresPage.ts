import { findElement } from '../../src/playground/page/elements.js';

/** The elements of figures/index.html that the script works on. */
export const figuresPage = {
  figures: findElement('figures'),
  turn: findElement('turn') as HTMLInputElement,
  turnValue: findElement('turn-value'),
  technique: findElement('technique'),
  status: findElement('status'),
};
