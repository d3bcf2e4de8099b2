import { anchoredSpecs } from '../gpu/compareAnchored.js';
import { engravingSpecs } from '../gpu/compareEngraving.js';
import { stippleSpecs } from '../gpu/compareStipple.js';
import { testSpecs } from './besideGlsl.js';

testSpecs('engraving', engravingSpecs(), {
  quick: ['along the form, carved', 'on a plane that falls off around a point'],
  drawnInCases: [
    'along the form',
    'along the form of a rotated, moved and scaled object',
    'along the form, with a pen',
    'along the form, in shadow, tone',
    'along the form, in shadow, reorient',
    'across the form',
    'tangent to the light',
    'tangent to a light from above',
    'towards the light',
    'across the axis x',
    'across the axis y',
    'across the axis z',
    'across a slant',
    'with a pen',
    'carved',
    'orthographic camera',
    'rotated object',
    'rotated, moved and scaled object',
    'two lights',
    'a near lamp',
    'a near lamp, rotated, moved and scaled object',
    'in shadow, tone',
    'in shadow, cross',
    'in shadow, reorient',
  ],
});
testSpecs('hatching', anchoredSpecs(), {
  quick: ['exposed, of a colour, in a shadow that crosses'],
  drawnInCases: [
    'directional light',
    'point light',
    'spot light',
    'two lights',
    'rotated object',
    'rotated, moved and scaled object',
    'sized on the screen',
    'sized half on the screen, two lights',
    'halfLambert',
    'phong',
    'toon',
    'second layer under two lights',
    'layers by tone',
    'in shadow, tone',
    'in shadow, cross',
    'in shadow, reorient',
    'along the form, sized on the screen',
    'along the form, of a moved object',
    'along the form, in layers by tone',
    'across the form',
  ],
});
testSpecs('stipple', stippleSpecs(), {
  quick: ['rotated, moved and scaled object, two lights', 'in shadow'],
  drawnInCases: ['sized on the screen', 'rotated object', 'orthographic camera'],
});
