import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';

/** Each chunk of GLSL has a file of nodes under the same name, with the same functions, or a reason why not. */

const NODES = 'src/webgpu/nodes';
const chunks = readdirSync('shaders', { recursive: true, encoding: 'utf8' })
  .map((path) => path.replaceAll('\\', '/'))
  .filter((path) => /\.(glsl|vert|frag)$/.test(path))
  .sort();

const twinOf = (chunk: string): string => `${NODES}/${chunk.replace(/^techniques\//, '').replace(/\.\w+$/, '.ts')}`;
const hasTwin = (chunk: string): boolean => existsSync(twinOf(chunk));

/** Why chunks have no twin: because node materials need none, or because what they draw is drawn by WebGLRenderer alone. */
const REASONS: readonly [chunks: RegExp, reason: string][] = [
  [/\.(frag|vert)$/, 'node materials have no main function: they put nodes together'],
  [/^(techniques\/(triangle|adjacency)|perTriangle)\//, 'triangle and adjacency are drawn by WebGLRenderer alone'],
  [/(^|\/)deform\.glsl$/, 'three.js poses the vertices of node materials itself'],
  [
    /^(chunks\/(debugViews|noNeighbours)|techniques\/(anchored|engraved)\/debug)\.glsl$/,
    'debug views are drawn by WebGLRenderer alone',
  ],
  [/^chunks\/(emitMapCoordinates|mapCoordinates|smoothNormal)\.glsl$/, "three's nodes read maps and normals"],
  [/^(chunks\/environment|environment\/\w+)\.glsl$/, "three's nodes light by environments"],
  [
    /^chunks\/turnedShadowLayer\.glsl$/,
    'its function is in anchored/shadowStrokes.ts, since no other nodes ask for it',
  ],
  [
    /^chunks\/(radiance|hatch|strokeLayers|toneNormals)\.glsl$/,
    'its nodes are HatchingLightingModel.ts, hatchSurface.ts and anchored/hatch.ts',
  ],
  [
    /^(perFragment|techniques\/(anchored|engraved))\/(emphasised|faceNormals|varyings|vertex|hatchLayer|layers)\.glsl$/,
    'it declares or puts together what hatchSurface.ts does for nodes',
  ],
  [/^outlines\/surroundings\.glsl$/, 'three.js fogs outlines of nodes, and outlines/clipping.ts clips them'],
];

const reasonsFor = (chunk: string): RegExp[] => REASONS.map(([path]) => path).filter((path) => path.test(chunk));

/** A function's name where GLSL defines it. */
const DEFINITION = /^(?:void|float|u?int|bool|[biu]?vec[234]|mat[234](?:x[234])?|[A-Z]\w+) (\w+)\(/gm;

const functionsOf = (glsl: string): string[] => [...new Set([...glsl.matchAll(DEFINITION)].map(([, name]) => name))];

/** Functions that nodes do not have under this name. */
const WITHOUT_FUNCTION: Record<string, readonly string[]> = {
  // Debug views are drawn by WebGLRenderer alone.
  'techniques/engraved/readCut.glsl': ['fieldUv'],
  'techniques/engraved/readForm.glsl': ['fieldUv'],
  // Only the techniques of triangles ask for one place.
  'chunks/thresholdMap.glsl': ['thresholdsAt', 'thresholdAt'],
  // They stand in octaves.ts, since strokes read them too.
  'techniques/engraved/ruledLines.glsl': ['octaves', 'powerOf2'],
  // It stands in texelOf.ts, since places of instances are read by it too.
  'outlines/points.glsl': ['texelOf'],
  // Only the techniques of triangles ask for the turn between three.
  'perTriangle/turns.glsl': ['addTurns'],
  // three's nodes say how depths are kept.
  'outlines/sceneDepth.glsl': ['clipDepth'],
};

test('each chunk has a twin or a reason', () => {
  const unexplained = chunks.filter((chunk) => !hasTwin(chunk) && reasonsFor(chunk).length === 0);
  expect(unexplained).toEqual([]);
});

test.each(REASONS)('there are chunks without a twin: %s, because %s', (path) => {
  expect(chunks.filter((chunk) => path.test(chunk) && !hasTwin(chunk)).length).toBeGreaterThan(0);
});

describe('a twin has the functions of its chunk', () => {
  test.each(chunks.filter(hasTwin))('%s', (chunk) => {
    const nodes = readFileSync(twinOf(chunk), 'utf8').replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '');
    const missing = functionsOf(readFileSync(`shaders/${chunk}`, 'utf8')).filter(
      (name) => !new RegExp(`\\b(?:function|const) ${name}\\b|^ +${name}[(:]`, 'm').test(nodes),
    );
    expect(missing).toEqual(WITHOUT_FUNCTION[chunk] ?? []);
  });
});

test('functions of GLSL are found', () => {
  expect(functionsOf('vec3 sum(vec3 a) {\n  return a;\n}\nuniform vec3 b;\nmat4x3 turned() {}\n')).toEqual([
    'sum',
    'turned',
  ]);
});
