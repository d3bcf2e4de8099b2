import type { PropertyRow } from '../PropertyRow.js';

/** The properties that only the techniques of the paper by Suarez et al. read: those of `HatchingMaterial.perTriangle`. */
export const PER_TRIANGLE = {
  strokeOffset: {
    kind: 'vector2',
    group: 'Per triangle',
    owner: 'perTriangle',
    default: [0, 0],
    measure: 'tiles',
    uniform: false,
    techniques: ['triangle', 'adjacency'],
    sentence: 'Shift of the strokes along T and B.',
  },
  sharpInk: {
    kind: 'switch',
    group: 'Per triangle',
    owner: 'perTriangle',
    default: false,
    techniques: ['triangle', 'adjacency'],
    sentence:
      'Blends thresholds of ink instead of the greys of strokes, so that strokes stay black and white. `false` is the way of the paper by Suarez et al.',
  },
  levelRule: {
    kind: 'choice',
    group: 'Per triangle',
    owner: 'perTriangle',
    type: 'LevelRule',
    typeSentence: 'What chooses the level of the tonal art map.',
    choices: {
      derivatives:
        'how fast texture coordinates change on the screen, foreshortening included. Strokes are never finer than drawn, and wider where the surface is seen at a slant.',
      depth:
        'the depth of the fragment alone (section 3.4). Strokes are as wide as drawn where the surface is seen face on, and foreshortened like the surface elsewhere.',
    },
    default: 'derivatives',
    techniques: ['triangle', 'adjacency'],
    sentence: 'What chooses the level of the map. `hatching` and `dryMedia` always go by depth.',
  },
  blendAngle: {
    kind: 'number',
    group: 'Per triangle',
    owner: 'perTriangle',
    default: Math.PI / 2,
    defaultSource: 'Math.PI / 2',
    measure: 'radians',
    range: { from: 0, to: Math.PI },
    uniform: false,
    techniques: ['adjacency'],
    sentence:
      'The angle between the normals of two triangles at which the blend of their strokes has faded out; at 0 nothing blends. The default is the rule of the paper by Suarez et al.',
  },
} as const satisfies Record<string, PropertyRow>;
