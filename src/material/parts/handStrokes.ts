import { HAND_STROKE_CONSTANTS, HAND_TEXTURE, MOST_ROWS } from '../../strokes/handConstants.js';
import { definesOf } from '../shaders/shaderText.js';
import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

const {
  './chunks/handStrokes.glsl': rows,
  './chunks/handShadowStrokes.glsl': inShadows,
  ...shadows
} = import.meta.glob<string>('./chunks/{handStrokes,handShadowStrokes,strokeShadows}.glsl', {
  base: '../../../shaders',
  query: '?raw',
  import: 'default',
  eager: true,
});

/** The files of the technique `pen` with a hand, beyond those of lines. */
export const part: MaterialPart = {
  surface,
  files: {
    ...shadows,
    './chunks/shadowStrokes.glsl': inShadows,
    // Strokes have the unsteadiness of the hand, and lie along steady lines.
    './techniques/lines/steadiness.glsl': '#define STEADY',
    // Rows of strokes are drawn in the place of lines.
    './techniques/lines/ruledLines.glsl': [
      definesOf({ ...HAND_STROKE_CONSTANTS, ...HAND_TEXTURE }),
      definesOf({ MOST_ROWS }, ''),
      rows,
    ].join('\n'),
  },
};
