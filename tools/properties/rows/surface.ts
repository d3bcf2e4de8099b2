import type { PropertyRow } from '../PropertyRow.js';

/** The properties of the surface under the strokes: its maps and normals. */
export const SURFACE = {
  normalMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    when: { toneNormal: ['smooth'] },
    sentence:
      "Normal map, as in three's own materials (`normalMapType` says of which space). Turns the smooth tone normal; face normals stay those of the triangles.",
  },
  normalScale: {
    kind: 'vector2',
    group: 'Surface',
    default: [1, 1],
    measure: 'factor',
    when: { toneNormal: ['smooth'], normalMap: { not: null } },
    sentence: 'How far the normal map turns the normal, along x and y.',
  },
  bumpMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    when: { toneNormal: ['smooth'], normalMap: [null] },
    sentence:
      'Heights that turn the smooth tone normal, where there is no normal map; face normals stay those of the triangles.',
  },
  bumpScale: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    measure: 'factor',
    when: { toneNormal: ['smooth'], normalMap: [null], bumpMap: { not: null } },
    sentence: 'How far the bump map turns the normal.',
  },
  flatShading: {
    kind: 'switch',
    group: 'Surface',
    default: false,
    when: { toneNormal: ['smooth'] },
    sentence: 'Makes the smooth tone normal that of the flat triangle, before a normal or bump map turns it.',
  },
  aoMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence: 'Ambient occlusion (red channel): dims light without a direction, the environment and the light map.',
  },
  aoMapIntensity: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    measure: 'factor',
    range: { from: 0 },
    when: { aoMap: { not: null } },
    sentence: 'Strength of the ambient occlusion.',
  },
  lightMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence: 'Light baked into a map, added to that of the scene; coloured light counts by its luminance.',
  },
  lightMapIntensity: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    measure: 'factor',
    range: { from: 0 },
    when: { lightMap: { not: null } },
    sentence: 'Strength of the light map.',
  },
  emissive: {
    kind: 'color',
    group: 'Surface',
    default: 0x000000,
    defaultWords: 'black',
    sentence: 'Light that the surface gives off; its luminance lowers the tone.',
  },
  emissiveIntensity: {
    kind: 'number',
    group: 'Surface',
    default: 1,
    measure: 'factor',
    range: { from: 0 },
    sentence: 'How strong that light is.',
  },
  emissiveMap: {
    kind: 'texture',
    group: 'Surface',
    default: null,
    sentence: 'Map of that light, multiplied by `emissive`.',
  },
} as const satisfies Record<string, PropertyRow>;
