import { expect, test } from 'vitest';
import { describeFacts, type Facts } from '../../../../src/playground/export/factsOf.js';

const FACTS: Facts = {
  versions: { hatching: '0.1.0', three: '187' },
  browser: 'Mozilla/5.0 (X11; Linux x86_64) Chrome/140.0',
  graphics: 'ANGLE (NVIDIA, NVIDIA GeForce RTX 3060)',
  sheet: { width: 900, height: 700, pixelRatio: 1.5 },
  model: 'bunny',
  statistics: {
    triangles: 3851,
    borderEdges: 42,
    nonManifoldEdges: 0,
    unpairedEdges: 0,
    inconsistentEdges: 0,
    degenerateTriangles: 1,
  },
  meshes: { all: 3, formed: 2 },
  settings: 'technique=engraving&ink=%23000000',
};

test('the facts are lines that a report can hold', () => {
  expect(describeFacts(FACTS)).toBe(
    `three-hatching: 0.1.0
three.js: r187
Browser: Mozilla/5.0 (X11; Linux x86_64) Chrome/140.0
Graphics: ANGLE (NVIDIA, NVIDIA GeForce RTX 3060)
Sheet: 900 × 700 CSS pixels, pixel ratio 1.5
Model: bunny
Mesh: 3851 triangles, 42 border edges, 0 non-manifold edges, 1 without area
Lines along the form: on 2 of 3 meshes
Settings: technique=engraving&ink=%23000000
`,
  );
  expect(describeFacts({ ...FACTS, statistics: undefined })).toContain('Mesh: none\n');
});

test.each([
  [['secret plan.glb'], 'own, GLB, in 1 file'],
  [['secret.ply.gz'], 'own, PLY, in 1 file'],
  [['secret.obj', 'secret.mtl', 'secret.png'], 'own, OBJ, in 3 files'],
  [['the.secret', 'secret'], 'own, of another format, in 2 files'],
])('of own files %j only the formats are told', (model, words) => {
  const facts = describeFacts({ ...FACTS, model });
  expect(facts).toContain(`Model: ${words}\n`);
  expect(facts).not.toContain('secret');
});
