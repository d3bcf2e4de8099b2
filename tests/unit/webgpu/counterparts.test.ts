import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';

/**
 * Each chunk of GLSL has a counterpart: a section in a file of nodes, below a comment that names the chunk, with the same functions, uniforms
 * and constants; or a reason for having none.
 */

const NODES = 'src/webgpu';
const chunks = readdirSync('shaders', { recursive: true, encoding: 'utf8' })
  .map((path) => path.replaceAll('\\', '/'))
  .filter((path) => /\.(glsl|vert|frag)$/.test(path))
  .sort();

/** The comment that begins a section of nodes. */
const HEADER = /^\/\*\*(?:\n \*)? Counterpart of shaders\/([\w/]+\.\w+)/m;

/** The sections of a file, by the chunk that each names. What precedes the first belongs to none. */
function sectionsOf(nodes: string): [chunk: string, section: string][] {
  const [, ...parts] = nodes.split(new RegExp(HEADER, 'm'));
  return parts.flatMap((part, i) => (i % 2 === 0 ? [[part, parts[i + 1]]] : []));
}

const files = readdirSync(NODES, { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.ts'))
  .map((path) => readFileSync(`${NODES}/${path}`, 'utf8'));
const sections = files.flatMap(sectionsOf);
const counterparts = new Map(sections);
const hasCounterpart = (chunk: string): boolean => counterparts.has(chunk);

/** Why chunks have no counterpart: node materials need none, or only WebGLRenderer draws what they draw. */
const REASONS: readonly [chunks: RegExp, reason: string][] = [
  [/\.(frag|vert)$/, 'node materials have no main function: they compose nodes'],
  [/^(techniques\/(triangle|adjacency)|perTriangle)\//, 'only WebGLRenderer draws triangle and adjacency'],
  [/(^|\/)deform\.glsl$/, 'three.js deforms the vertices of node materials itself'],
  [
    /^(chunks\/(debugViews|noNeighbours)|techniques\/(strokes|lines)\/debug)\.glsl$/,
    'only WebGLRenderer draws debug views',
  ],
  [/^chunks\/(emitMapCoordinates|mapCoordinates|smoothNormal)\.glsl$/, "three.js' nodes read maps and normals"],
  [/^(chunks\/environment|environment\/\w+)\.glsl$/, "three.js' nodes read environments"],
  [/^chunks\/turnedShadowLayer\.glsl$/, 'its function is in strokes/layers.ts, the only nodes that use it'],
  [/^chunks\/(radiance|strokeLayers|toneNormals)\.glsl$/, 'its nodes are HatchingLightingModel.ts and hatchSurface.ts'],
  [
    /^(perFragment|techniques\/(strokes|lines))\/(faded|faceNormals|varyings|vertex|hatchLayer|layers)\.glsl$/,
    'it declares or composes what hatchSurface.ts does for nodes',
  ],
  [/^chunks\/plainColor\.glsl$/, 'its nodes compute the darkness at fragments'],
  [/^chunks\/darkenedByColor\.glsl$/, 'its function is in chunks/tone.ts'],
  [/^chunks\/(handShadowStrokes|strokeShadows)\.glsl$/, 'nodes read shadows at fragments, not along strokes of a hand'],
  [/^outlines\/surroundings\.glsl$/, 'three.js fogs outlines of nodes, and outlines/outlineNodes.ts clips them'],
];

const reasonsFor = (chunk: string): RegExp[] => REASONS.map(([path]) => path).filter((path) => path.test(chunk));

const withoutComments = (text: string): string => text.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '');
const has = (text: string, word: string): boolean => new RegExp(`\\b${word}\\b`).test(text);
const unique = (names: readonly string[]): string[] => [...new Set(names)];

/** A function's name where GLSL defines it. */
const DEFINITION = /^(?:void|float|u?int|bool|[biu]?vec[234]|mat[234](?:x[234])?|[A-Z]\w+) (\w+)\(/gm;

const functionsOf = (glsl: string): string[] =>
  unique([...glsl.matchAll(DEFINITION)].map(([, name]) => name)).filter((name) => name !== 'main');

const uniformsOf = (glsl: string): string[] =>
  [...glsl.matchAll(/^\s*uniform (?:(?:high|medium|low)p )?\w+ (\w+)/gm)].map(([, name]) => name);

const uniformsOfNodes = (nodes: string): string[] =>
  unique([...nodes.matchAll(/hatching(?:Uniform|Texture|Element)\(\s*'(\w+)'/g)].map(([, name]) => name));

const tables = import.meta.glob<Record<string, Record<string, unknown>>>('../../../src/look/constants/*.ts', {
  eager: true,
});
const sharedConstants = Object.values(tables)
  .flatMap((exported) => Object.values(exported))
  .flatMap((table) => Object.keys(table));

/** A value as both languages would write it: without brackets, types, spaces and `.0`. */
const plainValue = (value: string): string =>
  value
    .replace(/\b[iu]?vec\d|as const|[()[\]\s;]/g, '')
    .replace(/\b(\d+)\.0\b/g, '$1')
    .replace(/([\da-f])u\b/g, '$1')
    .replaceAll('Math.SQRT1_2', '0.70710678')
    .replaceAll('Math.sqrt1/3', '0.57735027');

/** The values of constants that a chunk defines: `#define NAME value` and `const type NAME = value;`. */
const constantsOf = (glsl: string): Record<string, string> =>
  Object.fromEntries(
    [...glsl.matchAll(/^\s*(?:#define|const \w+) ([A-Z][A-Z0-9_]+)(?: =)? +(.*\d.*)$/gm)]
      .filter(([, , value]) => !/[a-z]\w*\(.*[a-z]\w*\(|[&|<>=]|\b(?!vec)[a-z]/.test(value.replace(/[iu]?vec\d/g, '')))
      .map(([, name, value]) => [name, plainValue(value)]),
  );

/** The values of constants that a file of nodes defines: `const NAME = value;` and `const [A, B] = [a, b];`. */
function constantsOfNodes(nodes: string): Record<string, string> {
  const single = [...nodes.matchAll(/^(?:export )?const ([A-Z][A-Z0-9_]+)(?:: \w+)? = (.*\d.*);$/gm)];
  const several = [...nodes.matchAll(/^const \[([A-Z0-9_, ]+)\] = \[(.*)\]/gm)];
  return Object.fromEntries([
    ...single.map(([, name, value]) => [name, plainValue(value)] as const),
    ...several.flatMap(([, names, values]) =>
      names.split(', ').map((name, i) => [name, plainValue(values.split(', ')[i])] as const),
    ),
  ]);
}

/**
 * What is read with a chunk and with its counterpart, since part of one is elsewhere on the other side: chunks, and the nodes of chunks or
 * whole files of nodes.
 */
const TOGETHER: Record<string, { glsl?: readonly string[]; nodes?: readonly string[] }> = {
  // The chunk is included for flat maps and for cubes; its constants are defined before.
  'chunks/shadowSearch.glsl': { glsl: ['chunks/softShadows.glsl'] },
  'chunks/softShadows.glsl': { nodes: ['chunks/shadowSearch.glsl'] },
  // A define of the technique is an argument of the nodes.
  'chunks/crossedTones.glsl': { nodes: ['techniques/lines/hatchLayer.glsl'] },
  'techniques/lines/hatchLayer.glsl': {
    glsl: ['chunks/crossedTones.glsl'],
    nodes: ['nodes/lines/strokeLengths.ts'],
  },
  // Uniforms are declared in GLSL once per program, and in nodes where they are used first.
  'perFragment/screenGradient.glsl': { glsl: ['chunks/unitsPerPixel.glsl'] },
  'techniques/strokes/dots.glsl': { nodes: ['techniques/strokes/stipple.glsl'] },
  'techniques/strokes/stipple.glsl': {
    glsl: ['techniques/strokes/dots.glsl'],
    nodes: ['techniques/strokes/layers.glsl'],
  },
  'techniques/lines/read.glsl': { nodes: ['techniques/lines/emit.glsl'] },
  // Strokes use `octaves`, `powerOf2` and the fringe of lines too.
  'techniques/lines/ruledLines.glsl': { nodes: ['nodes/lines/strokeLengths.ts'] },
  // Instance matrices are read by `texelOf` too.
  'outlines/points.glsl': { nodes: ['nodes/base/uniforms.ts'] },
};

/** Names that functions have in nodes, where two chunks with a function of the same name share a file. */
const OTHER_NAMES: Record<string, Record<string, string>> = {
  'techniques/strokes/readForm.glsl': { readStrokeAxes: 'axesOfForm' },
  'techniques/strokes/readLight.glsl': { readStrokeAxes: 'axesOfLight' },
  'techniques/strokes/readSheet.glsl': { readStrokeAxes: 'axesOfSheet' },
  'techniques/lines/readCut.glsl': { readHatchingParameters: 'readCutLines' },
  'techniques/lines/readForm.glsl': { readHatchingParameters: 'readFormLines' },
};

/** Functions that the counterpart lacks, by chunk. */
const OTHER_FUNCTIONS: Record<string, readonly string[]> = {
  // Only WebGLRenderer draws debug views.
  'techniques/lines/readCut.glsl': ['fieldUv'],
  'techniques/lines/readForm.glsl': ['fieldUv'],
  // It is in chunks/tone.ts, for any surface.
  'chunks/metal.glsl': ['darkenedByColor'],
  // Only the techniques of triangles read a single place.
  'chunks/thresholdMap.glsl': ['thresholdsAt', 'thresholdAt'],
  // Only the techniques of triangles average three rotations.
  'perTriangle/turns.glsl': ['addTurns'],
  // three.js' nodes know the format of depths.
  'outlines/sceneDepth.glsl': ['clipDepth'],
};

/** Uniforms that one side lacks, by chunk. */
const OTHER_UNIFORMS: Record<string, readonly string[]> = {
  // GLSL reads it in the chunk of the layout.
  'deformation.vert': ['triangleVertices'],
  // three.js' own uniform, which nodes read in sceneDepth; and only WebGPURenderer blends linear light on a canvas.
  'outlines/outlines.frag': ['projectionMatrix', 'canvasBlend'],
  // Nodes read a texture of rotations, which holds normals where there is no skin, and a uniform in place of the define DEFORMED.
  'outlines/points.glsl': ['deformedNormals', 'isDeformed'],
  // A uniform in place of the define USE_INSTANCING.
  'outlines/primitives.glsl': ['isInstanced'],
  // three.js' nodes copy the depth and know its format.
  'outlines/sceneDepth.glsl': ['sceneDepth', 'logDepthBufFC'],
  // three.js' own uniform, from which GLSL derives viewToObject.
  'perFragment/viewToAnchor.glsl': ['normalMatrix'],
};

/** Constants that one side lacks, or has with another value, by chunk. */
const OTHER_CONSTANTS: Record<string, readonly string[]> = {
  // A literal in GLSL.
  'chunks/shadowSearch.glsl': ['RINGS'],
  // Words of integers in GLSL, and floats in nodes.
  'meetings/part.frag': ['NUMBERS'],
  // A property of three.js' versions.
  'outlines/sceneDepth.glsl': ['REVERSES_FLOATS'],
  // The sum of the three numbers of HASH_STEP.
  'techniques/strokes/simplexLattice.glsl': ['HASH_STEPS'],
};

/** The code of a chunk and of its counterpart, and that of the chunks that are read with each. */
function read(chunk: string): Record<'glsl' | 'nodes' | 'allGlsl' | 'allNodes', string> {
  const glslOf = (path: string): string => withoutComments(readFileSync(`shaders/${path}`, 'utf8'));
  const nodesOf = (path: string): string =>
    withoutComments(counterparts.get(path) ?? readFileSync(`${NODES}/${path}`, 'utf8'));
  const { glsl = [], nodes = [] } = TOGETHER[chunk] ?? {};
  return {
    glsl: glslOf(chunk),
    nodes: nodesOf(chunk),
    allGlsl: [chunk, ...glsl].map(glslOf).join('\n'),
    allNodes: [chunk, ...nodes].map(nodesOf).join('\n'),
  };
}

test('each chunk has a counterpart or a reason', () => {
  const unexplained = chunks.filter((chunk) => !hasCounterpart(chunk) && reasonsFor(chunk).length === 0);
  expect(unexplained).toEqual([]);
});

test.each(REASONS)('some chunks have no counterpart: %s, because %s', (path) => {
  expect(chunks.filter((chunk) => path.test(chunk) && !hasCounterpart(chunk)).length).toBeGreaterThan(0);
});

test('no chunk has two counterparts', () => {
  expect(sections.map(([chunk]) => chunk).sort()).toEqual([...counterparts.keys()].sort());
});

test('nodes read no uniform that no shader declares', () => {
  const declared = chunks.flatMap((chunk) => uniformsOf(readFileSync(`shaders/${chunk}`, 'utf8')));
  const strays = files.flatMap(uniformsOfNodes).filter((name) => !declared.includes(name));
  // They are defines in GLSL, or derived from three.js' own uniforms; and only WebGPURenderer blends linear light on a canvas.
  expect(unique(strays).sort()).toEqual(['canvasBlend', 'isDeformed', 'isInstanced', 'viewToObject']);
});

describe.each(chunks.filter(hasCounterpart))('the counterpart of %s', (chunk) => {
  const { glsl, nodes, allGlsl, allNodes } = read(chunk);

  test('has its functions', () => {
    const missing = functionsOf(glsl).filter((ofGlsl) => {
      const name = OTHER_NAMES[chunk]?.[ofGlsl] ?? ofGlsl;
      return !new RegExp(`\\b(?:function|const) ${name}\\b|^ +${name}[(:]`, 'm').test(allNodes);
    });
    expect(missing).toEqual(OTHER_FUNCTIONS[chunk] ?? []);
  });

  test('reads the same uniforms', () => {
    const others = [
      ...uniformsOf(glsl).filter((name) => !has(allNodes, name)),
      ...uniformsOfNodes(nodes).filter((name) => !has(allGlsl, name)),
    ];
    expect(others).toEqual(OTHER_UNIFORMS[chunk] ?? []);
  });

  test('has the same constants', () => {
    const [ofGlsl, ofNodes] = [constantsOf(allGlsl), constantsOfNodes(allNodes)];
    const defined = unique([...Object.keys(constantsOf(glsl)), ...Object.keys(constantsOfNodes(nodes))]);
    const literals = allGlsl.match(/\b\d+\.\d+(?:e-?\d+)?\b/g) ?? [];
    const isLiteral = (name: string): boolean =>
      !(name in ofGlsl) && literals.some((literal) => Math.abs(Number(ofNodes[name])) === Number(literal));
    const others = [
      ...defined.filter((name) => ofGlsl[name] !== ofNodes[name] && !isLiteral(name)),
      ...sharedConstants.filter((name) => has(glsl, name) && !has(allNodes, name)),
      ...sharedConstants.filter((name) => has(nodes, name) && !has(allGlsl, name)),
    ];
    expect(others).toEqual(OTHER_CONSTANTS[chunk] ?? []);
  });
});

describe('what is compared is found', () => {
  test('functions', () => {
    const glsl = 'vec3 sum(vec3 a) {\n  return a;\n}\nuniform vec3 b;\nmat4x3 turned() {}\n';
    expect(functionsOf(glsl)).toEqual(['sum', 'turned']);
  });

  test('uniforms', () => {
    expect(uniformsOf('uniform vec3 a;\n  uniform highp sampler2D b;\nuniform vec2 c[4];\n')).toEqual(['a', 'b', 'c']);
    expect(
      uniformsOfNodes("hatchingUniform('a', 'float') hatchingTexture('b', blank) hatchingElement('c', 0)"),
    ).toEqual(['a', 'b', 'c']);
  });

  test('constants', () => {
    const glsl =
      '#define HALF 0.5\n#define BOTH vec2(1.0, 2.5)\nconst uint ODD = 3u;\n#define SUM (HALF + 1.0 / 3.0)\n';
    const nodes = 'const HALF = 0.5;\nconst BOTH = [1, 2.5] as const;\nconst [ODD] = [3];\nconst SUM = HALF + 1 / 3;\n';
    expect(constantsOf(glsl)).toEqual(constantsOfNodes(nodes));
    expect(Object.keys(constantsOf(glsl))).toEqual(['HALF', 'BOTH', 'ODD', 'SUM']);
  });
});
