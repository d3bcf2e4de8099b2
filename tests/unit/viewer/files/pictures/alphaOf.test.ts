import { expect, test } from 'vitest';
import type { GltfParts } from '../../../../../src/viewer/files/gltf/parseGltf.js';
import { resolveBlendedPictures } from '../../../../../src/viewer/files/pictures/decodePictures.js';
import { alphaOf } from '../../../../../src/viewer/files/pictures/imageSize.js';

/** A picture with a pixel for each alpha. */
const pictureOf = (...alphas: number[]) => ({
  data: Uint8ClampedArray.from(alphas.flatMap((alpha) => [255, 255, 255, Math.round(255 * alpha)])),
  width: alphas.length,
  height: 1,
  close: () => {},
});

test.each([
  ['opaque', [1, 1, 1, 1], 1, 0],
  ['with clear parts', [1, 0, 0, 1], 0.5, 0],
  ['with clear parts and soft edges', [1, 1, 1, 0.5, 0], 0.7, 0.25],
  ['half there', [0.4, 0.4, 0.4, 0.4], 0.4, 1],
  ['of nothing', [0, 0], 0, 0],
])('the alpha of a picture that is %s', (_what, alphas, mean, half) => {
  const alpha = alphaOf(pictureOf(...alphas))!;
  expect(alpha.mean).toBeCloseTo(mean, 2);
  expect(alpha.half).toBeCloseTo(half, 2);
});

test('a mostly half-transparent or transparent picture passes its alpha to the material; other blended pictures cut it out', () => {
  const factorsWith = (alphaMode: string, factor: number, ...alphas: number[]): unknown => {
    const pbrMetallicRoughness = { baseColorFactor: [1, 1, 1, factor], baseColorTexture: { index: 0 } };
    const material = { alphaMode, pbrMetallicRoughness };
    const parts = {
      json: { materials: [material, {}] },
      textures: [{ image: 0, sampler: undefined }],
      bitmaps: [pictureOf(...alphas)],
    };
    resolveBlendedPictures(parts as unknown as GltfParts);
    return [
      material.alphaMode,
      pbrMetallicRoughness.baseColorFactor[3].toFixed(2),
      pbrMetallicRoughness.baseColorTexture ? 'with its picture' : 'without',
    ];
  };
  expect(factorsWith('BLEND', 0.5, 0.4, 0.4)).toEqual(['BLEND', '0.20', 'without']);
  expect(factorsWith('BLEND', 1, 0, 0)).toEqual(['BLEND', '0.00', 'without']);
  expect(factorsWith('BLEND', 1, 1, 0)).toEqual(['BLEND', '1.00', 'with its picture']);
  expect(factorsWith('MASK', 1, 0.4, 0.4)).toEqual(['MASK', '1.00', 'with its picture']);
  // Many programs write all materials as blended.
  expect(factorsWith('BLEND', 1, 1, 1)).toEqual(['OPAQUE', '1.00', 'with its picture']);
  expect(factorsWith('BLEND', 0.5, 1, 1)).toEqual(['BLEND', '0.50', 'with its picture']);
});
