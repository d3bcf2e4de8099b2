import type { PropertyRow } from '../PropertyRow.js';

/** The properties of colour. */
export const COLOUR = {
  ink: {
    kind: 'color',
    group: 'Colour',
    default: 0x000000,
    defaultWords: 'black',
    sentence: 'Colour of the strokes.',
  },
  paper: {
    kind: 'color',
    group: 'Colour',
    default: 0xffffff,
    defaultWords: 'white',
    sentence: 'Colour of the ground between strokes, multiplied by the surface colour as far as `colorFill` says.',
  },
  color: {
    kind: 'color',
    group: 'Colour',
    default: 0xffffff,
    defaultWords: 'white',
    uniform: 'diffuse',
    sentence: 'Surface colour.',
  },
  colorFill: {
    kind: 'number',
    group: 'Colour',
    default: 1,
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      "How much of the surface's own colour (`color`, `map` and vertices) is printed on the paper: nothing at 0, and in between a tint of it, on which strokes are easier to read.",
  },
  inkBlend: {
    kind: 'choice',
    group: 'Colour',
    type: 'InkBlend',
    typeSentence: 'What ink does to the colour below it.',
    choices: {
      cover: "hides it, as gouache or a printer's black.",
      multiply: 'tints it, as transparent ink.',
    },
    default: 'cover',
    sentence: 'What ink does to the colour below it.',
  },
  paperOpacity: {
    kind: 'number',
    group: 'Colour',
    default: 1,
    measure: 'share',
    range: { from: 0, to: 1 },
    sentence:
      'Opacity of the paper between strokes: below 1 what is behind shows through, at 0 only strokes are drawn. Needs `transparent`, `alphaTest` or `alphaHash`: a material that is drawn opaque keeps its paper.',
  },
  map: {
    kind: 'texture',
    group: 'Colour',
    default: null,
    sentence: 'Surface colour map, multiplied by `color`.',
  },
  alphaMap: {
    kind: 'texture',
    group: 'Colour',
    default: null,
    sentence: "Opacity map (green channel), as in three's own materials.",
  },
} as const satisfies Record<string, PropertyRow>;
