import { choiceOf, colorOf, numberOf } from './materialRows.js';
import { inGroup } from './Setting.js';

/** How light becomes tone. */
export const TONE_SETTINGS = inGroup('Tone', 'hand', {
  toneModel: choiceOf('toneModel', {
    label: 'Shading',
    choices: { lambert: 'Lambert', halfLambert: 'Half Lambert', phong: 'Phong', toon: 'Toon' },
    // `shadow` is for the ground's material.
    leftOut: ['shadow'],
  }),
  toneNormal: choiceOf('toneNormal', {
    label: 'Normals',
    choices: { auto: 'As the technique does', face: 'Of the triangles', smooth: 'Smoothed' },
  }),
  toneSteps: numberOf('toneSteps', { label: 'Toon steps', max: 8 }),
  shininess: numberOf('shininess', { label: 'Shininess', min: 1, max: 200 }),
  toneCurve: {
    kind: 'choice',
    label: 'Curve',
    partOf: 'toneCurve',
    default: 'linear',
    choices: {
      linear: 'As the light is',
      perceptual: 'As the eye sees it',
      contrast: 'More contrast',
      printed: 'As in prints',
      cut: 'As cut in wood',
      rubbed: 'As rubbed',
      chalked: 'As chalk on dark',
    },
  },
  blendAngle: numberOf('blendAngle', { label: 'Blend up to' }),
  highlightTone: numberOf('highlightTone', { label: 'Blank below', max: 60 }),
  localTone: numberOf('localTone', { label: 'Local tone', ends: ['white', 'by colour'] }),
});

/** Colours of ink, paper and surfaces. */
export const COLOUR_SETTINGS = inGroup('Colours', 'hand', {
  ink: colorOf('ink', { label: 'Ink', default: '#1c1a17' }),
  paper: colorOf('paper', { label: 'Paper', default: '#f7f3e8' }),
  inkBlend: choiceOf('inkBlend', { label: 'On colour', choices: { cover: 'Ink covers', multiply: 'Ink tints' } }),
  surfaceColors: {
    kind: 'choice',
    label: 'Surfaces',
    owner: 'scene',
    default: 'shown',
    choices: { shown: 'By their own colours', paper: 'White as paper' },
  },
  colorFill: numberOf('colorFill', { label: 'Fill', ends: ['ink alone', 'coloured'] }),
  color: colorOf('color', { label: 'Model' }),
});
