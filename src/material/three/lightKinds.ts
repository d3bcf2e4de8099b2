/** Known in three.js 0.170 to 0.187: the structs, counts and functions of its lights, and the loops that it unrolls. */
import { ShaderChunk } from 'three';
import { expectChunk } from './chunks.js';

/** A kind of light of three.js. */
interface LightKind {
  /**
   * The name in three's shader chunks: `Point` for the struct `PointLight`, the uniform `pointLights` and the function
   * `getPointLightInfo`.
   */
  name: string;
  /** The name in macros for numbers, which three.js replaces: `DIR` for `NUM_DIR_LIGHTS` and `NUM_DIR_LIGHT_SHADOWS`. */
  key: string;
  /**
   * Its type, which decides the members of the struct: `direction` and `color` of distant lights; `position`, `color`,
   * `distance` and `decay` of positional ones. A `sky` is three's hemisphere light.
   */
  type: 'distant' | 'positional' | 'sky';
  /**
   * Of flat shadow maps: the uniform of the matrices from world space to them, which three.js declares in the vertex shader, and the
   * macro for their number. Other lights at a place have cubes, and those of a sun are cascades.
   */
  matrices?: readonly [uniform: string, count: string];
}

/**
 * Every kind of light that the library's shaders evaluate, in the order of three's `lights_fragment_begin`. A new kind is a row here:
 * no file of shaders/ names any of them.
 */
const LIGHT_KINDS: readonly LightKind[] = [
  { name: 'Point', key: 'POINT', type: 'positional' },
  { name: 'Spot', key: 'SPOT', type: 'positional', matrices: ['spotLightMatrix', 'NUM_SPOT_LIGHT_COORDS'] },
  { name: 'Sun', key: 'SUN', type: 'distant' },
  { name: 'Directional', key: 'DIR', type: 'distant', matrices: ['directionalShadowMatrix', 'NUM_DIR_LIGHT_SHADOWS'] },
  { name: 'Hemisphere', key: 'HEMI', type: 'sky' },
];

/** The macro for the number of lights of a kind. */
const countOf = ({ key }: LightKind): string => `NUM_${key}_LIGHTS`;

/** The kinds that the installed three.js supports. The names of others would not be replaced, and would not compile. */
function knownKinds(): LightKind[] {
  const { lights_pars_begin: chunk } = ShaderChunk;
  const kinds = LIGHT_KINDS.filter(
    (kind) => chunk.includes(countOf(kind)) && (kind.type === 'sky' || chunk.includes(`get${kind.name}LightInfo(`)),
  );
  // Versions before 0.187 have no sun.
  expectChunk('lights_pars_begin', kinds.length > 3 + Number(chunk.includes('SUN_LIGHTS')));
  return kinds;
}

/** Macros around the functions by which three.js reads shadow maps, so that each result goes through `separateShadow`. */
function shadowMacros(): string {
  const calls = ShaderChunk.lights_fragment_begin.matchAll(/\b(get\w*Shadow)\(([^()]*)\)/g);
  const macros = new Map<string, string>();
  for (const [, name, given] of calls) {
    // A macro does not expand within itself, so that the wrapped function can have its own name.
    const call = `${name}(${given.split(',').map((_, i) => `p${i}`)})`;
    macros.set(name, `#define ${call} separateShadow(KNOWN_SHADOW(${call}))\n`);
  }
  expectChunk('lights_fragment_begin', macros.size > 1);
  return [...macros.values()].join('');
}

/** Defines for the number of lights that have a direction, which are all but skies, and of those at a place. */
export function lightCountDefines(): string {
  const sum = (kinds: LightKind[]): string => `(${kinds.map(countOf).join(' + ')})`;
  const known = knownKinds();
  return [
    `#define LIGHTS_WITH_DIRECTION ${sum(known.filter(({ type }) => type !== 'sky'))}`,
    `#define POSITIONAL_LIGHTS ${sum(known.filter(({ type }) => type === 'positional'))}`,
  ].join('\n');
}

/**
 * Chunks that loop over lights. Before a shader includes one, it defines the macro `VISIT_LIGHT(source, number)`: the code for each
 * light. `source` is three's struct, and `number` counts the lights that have a direction, in three's order. The chunk undefines the
 * macro again.
 *
 * - `eachLight` visits every light that has a direction. The shader declares `IncidentLight light`, into which the chunk writes what
 * arrives at `viewPosition`.
 * - `eachDistantLight` and `eachPositionalLight` visit lights of one type.
 * - `eachSky` visits hemisphere lights. Their number has no meaning.
 *
 * `lightShadows` is not a loop: it wraps three's shadow map functions, so that calls go through `KNOWN_SHADOW` and results through
 * `separateShadow`.
 */
export function lightChunks(): Record<string, string> {
  const kinds = knownKinds();
  const loops = (type: LightKind['type'], writesLight = false): string =>
    kinds.map((kind, i) => (kind.type === type ? loopOver(kind, kinds.slice(0, i), writesLight) : '')).join('');
  const end = '#undef VISIT_LIGHT';
  return {
    eachLight: loops('distant', true) + loops('positional', true) + end,
    eachDistantLight: loops('distant') + end,
    eachPositionalLight: loops('positional') + end,
    eachSky: loops('sky') + end,
    lightShadows: shadowMacros(),
  };
}

/**
 * Chunks that loop over shadow maps, as those of {@link lightChunks} loop over lights, at a `viewPosition` and with a `light` of the
 * shader:
 *
 * - `eachFlatShadow` visits every flat shadow map by `VISIT_SHADOW(number, map, matrix, shadow)`: the number of its light, the map, the
 *   matrix that leads to it from the world, and three's struct of the shadow. `shadowMatrices` declares the matrices.
 * - `eachFlatPlace` visits those, and of every sun the cascade that holds the depth of `viewPosition`. `cascades` declares what finds it.
 * - `eachCubeShadow` visits every cube by `VISIT_SHADOW(number, map, fromLight, shadow)`: the third is in view space.
 *
 * `turnedShadows` is no such loop: it moves the places at which three's functions read shadow maps by `turned`, a vector in world space,
 * times the bias along the normal.
 */
export function shadowChunks(): Record<string, string> {
  const kinds = knownKinds();
  const flat: string[] = [];
  const cascaded: string[] = [];
  const cascades: string[] = [];
  const cubes: string[] = [];
  const matrices: string[] = [];
  const turned: string[] = [];
  for (const [i, { name, key, type, matrices: ofKind }] of kinds.entries()) {
    // Lights that cast shadows are the first of their kind.
    const count = `NUM_${key}_LIGHT_SHADOWS`;
    const lower = name.toLowerCase();
    const map = `${lower}ShadowMap[i]`;
    const shadow = `${lower}LightShadows[i]`;
    const number = numberAfter(kinds.slice(0, i));
    if (ofKind) {
      const [matrix, most] = ofKind;
      matrices.push(`#if ${count} > 0\nuniform mat4 ${matrix}[${most}];\n#endif\n`);
      const visit = `${readLight(name, type)}\nVISIT_SHADOW(${number}, ${map}, ${matrix}[i], ${shadow})`;
      flat.push(unrolled(count, visit));
      const varying = type === 'distant' ? `v${name}ShadowCoord` : `v${name}LightCoord`;
      turned.push(turnedCoords(varying, count, `${matrix}[i] * vec4(${shadow}.shadowNormalBias * turned, 0.0)`));
    } else if (type === 'distant') {
      const at = `${lower}Cascade(UNROLLED_LOOP_INDEX, -viewPosition.z)`;
      cascaded.push(unrolled(count, `VISIT_SHADOW(${number}, ${map}, ${lower}ShadowMatrix[${at}], ${shadow})`));
      cascades.push(`#if ${count} > 0\n${cascadeFunction(lower, key)}#endif\n`);
    } else if (type === 'positional') {
      const fromLight = `viewPosition - ${lower}Lights[i].position`;
      cubes.push(unrolled(count, `VISIT_SHADOW(${number}, ${map}, ${fromLight}, ${shadow})`));
      // The vector from the light, in world space.
      turned.push(turnedCoords(`v${name}ShadowCoord`, count, `vec4(${shadow}.shadowNormalBias * turned, 0.0)`));
    }
  }
  const end = '#undef VISIT_SHADOW';
  return {
    shadowMatrices: matrices.join(''),
    eachFlatShadow: flat.join('') + end,
    eachFlatPlace: flat.join('') + cascaded.join('') + end,
    cascades: cascades.join(''),
    eachCubeShadow: cubes.join('') + end,
    turnedShadows: turned.join(''),
  };
}

/** Finds the nearest cascade of a light that holds a depth. */
const cascadeFunction = (
  light: string,
  key: string,
): string => `int ${light}Cascade(const in int number, const in float viewDepth) {
  int last = (number + 1) * ${key}_LIGHT_CASCADES - 1;
  for (int i = number * ${key}_LIGHT_CASCADES; i < last; i++) if (viewDepth < ${light}ShadowCascade[i].y) return i;
  return last;
}
`;

/** Replaces a varying of coordinates of shadow maps by moved ones, for the chunks after it. */
function turnedCoords(varying: string, count: string, change: string): string {
  const moved = `turned${varying.slice(1)}`;
  return `#if ${count} > 0
vec4 ${moved}[${count}];
#endif
${unrolled(count, `${moved}[i] = ${varying}[i] + ${change};`)}#if ${count} > 0
#define ${varying} ${moved}
#endif
`;
}

function loopOver(kind: LightKind, before: readonly LightKind[], writesLight: boolean): string {
  const { name, type } = kind;
  const visit = `VISIT_LIGHT(${name.toLowerCase()}Lights[i], ${numberAfter(before)})`;
  return unrolled(countOf(kind), `${writesLight ? readLight(name, type) : ''}\n${visit}`);
}

/** The index of a light among all that have a direction. */
const numberAfter = (before: readonly LightKind[]): string =>
  [...before.map(countOf), 'UNROLLED_LOOP_INDEX'].join(' + ');

/** Writes the light that arrives from a source into `light`. */
const readLight = (name: string, type: LightKind['type']): string =>
  `get${name}LightInfo(${name.toLowerCase()}Lights[i], ${type === 'positional' ? 'viewPosition, ' : ''}light);`;

/** A loop in the form that three.js unrolls: some drivers warn of a loop that runs once. */
const unrolled = (count: string, body: string): string => `#if ${count} > 0
#pragma unroll_loop_start
for (int i = 0; i < ${count}; i++) {
${body}
}
#pragma unroll_loop_end
#endif
`;
