import { Color, MeshPhongMaterial, MeshStandardMaterial, Texture } from 'three';
import { expect, test } from 'vitest';
import { mirroredBy, reflectedColor } from '../../../../../src/viewer/files/scenes/mirroredBy.js';

const phong = (name: string, specular: number, shininess: number, parameters = {}): MeshPhongMaterial =>
  new MeshPhongMaterial({ name, specular: new Color(specular, specular, specular), shininess, ...parameters });

test('of formats without metalness, polished metal is told by its name and its gloss', () => {
  const shares = [
    phong('Kettle-chrome', 0.2, 96),
    phong('STAINLESS_steel', 0, 1),
    phong('Metal.001', 0.7, 150),
    phong('Metal.001', 0.2, 96),
    phong('Steel', 0.8, 10),
    phong('plastic', 1, 1000),
    phong('chrome', 1, 1000, { map: new Texture() }),
    new MeshPhongMaterial({ name: 'metal' }),
  ].map(mirroredBy);
  expect(shares).toEqual([1, 1, 1, 0, 0, 0, 0, 0]);
});

test('metalness and roughness count where a format has them, whatever the name', () => {
  const standard = (metalness: number, roughness: number): number =>
    mirroredBy(new MeshStandardMaterial({ name: 'chrome', metalness, roughness }));
  expect([standard(1, 0.2), standard(0.5, 0), standard(1, 0.9), standard(0, 0)]).toEqual([1, 0.5, 0, 0]);
  expect(standard(1, 0.55)).toBeCloseTo(0.5);
});

test('the colour of polished metal is what it reflects, and that of others stays', () => {
  const dark = { color: new Color(0.02, 0.03, 0.9) };
  expect(reflectedColor(phong('chrome', 0.8, 200, dark))?.toArray()).toEqual([0.8, 0.8, 0.9]);
  expect(reflectedColor(phong('chrome', 3, 200, dark))?.toArray()).toEqual([1, 1, 1]);
  expect(reflectedColor(phong('paint', 0.8, 200, dark))?.toArray()).toEqual([0.02, 0.03, 0.9]);
});

test('where a map says what is metal, nothing mirrors', () => {
  for (const name of ['metalnessMap', 'roughnessMap'] as const)
    expect(mirroredBy(new MeshStandardMaterial({ metalness: 1, roughness: 0, [name]: new Texture() }))).toBe(0);
});
