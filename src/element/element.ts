import type { PresetName } from 'three-hatching';
import { HatchedModelElement } from './HatchedModelElement.js';

/** The attributes of `<hatched-model>`, as JSX and templates write them (docs/element.md). */
export interface HatchedModelAttributes {
  /** URL of a glTF or GLB file. */
  src?: string | undefined;
  /** The name of a preset. Default: `pen`. */
  preset?: PresetName | undefined;
  /** URL of a `hand.json`, whose strokes are drawn. The preset must draw with a pen. */
  hand?: string | undefined;
  /** How much of the model's own colours is printed under the ink, from 0 to 1. Default: 0. */
  'color-fill'?: number | string | undefined;
  /** How much the darkness of these colours is hatched, from 0 to 1. Default: 0.8. */
  'color-hatching'?: number | string | undefined;
  /** A factor on the brightness of the drawing, above 0. Default: 1. */
  exposure?: number | string | undefined;
  /** How much strokes fade towards the rim, from 0 to 1. Default: 0. */
  vignette?: number | string | undefined;
  /**
   * Azimuth and elevation of the light in degrees. Default: those of the file's light or, without one, of a light that suits the first
   * view.
   */
  light?: string | undefined;
  /** The camera of the file for the first view: its name, or its number from 1 on. */
  camera?: number | string | undefined;
  /** The material variant of the file: its name, or its number from 1 on. */
  variant?: number | string | undefined;
  /** Whether visitors may turn the model and its light; with `light` only the light. Default: false. */
  controls?: boolean | 'light' | undefined;
  /** Describes the picture in words; empty if it is decoration. Default: "Drawing of a model". */
  alt?: string | undefined;
  /** URL of a picture that is shown until the model is drawn. */
  poster?: string | undefined;
  /** URL of a folder with three.js's Draco decoder, for models compressed with Draco. */
  'draco-path'?: string | undefined;
  /** URL of a folder with three.js's KTX2 decoder, for models with KTX2 textures. */
  'ktx2-path'?: string | undefined;
}

/**
 * Importing this module defines the custom element `<hatched-model>`. On a server it does nothing.
 *
 * @module three-hatching/element
 */

export { HatchedModelElement };

const NAME = 'hatched-model';

declare global {
  interface HTMLElementTagNameMap {
    'hatched-model': HatchedModelElement;
  }
}

// It would be an error if a second copy of the library on the same page defined the element again.
if (globalThis.customElements && !customElements.get(NAME)) customElements.define(NAME, HatchedModelElement);
