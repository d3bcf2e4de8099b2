import { expect, test } from 'vitest';
import { definesOf } from '../../../../src/material/shaders/shaderText.js';

test('numbers are floats or vectors in shaders, and whole ones what is asked for', () => {
  expect(definesOf({ WHOLE: 3, PART: 0.25, SMALL: 1e-7, SLANT: [0.5, 2, -1] })).toBe(
    ['#define WHOLE 3.', '#define PART 0.25', '#define SMALL 1e-7', '#define SLANT vec3(0.5,2,-1)'].join('\n'),
  );
  expect(definesOf({ STEPS: 24 }, '')).toBe('#define STEPS 24');
  expect(definesOf({ GOLDEN_RATIO: 0x9e3779b9 }, 'u')).toBe('#define GOLDEN_RATIO 2654435769u');
});
