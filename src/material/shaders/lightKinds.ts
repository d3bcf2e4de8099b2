import { ShaderChunk } from 'three';

/** A kind of light of three.js. */
interface LightKind {
  /**
   * The name in three's shader chunks: `Point` for the struct `PointLight`, the uniform `pointLights` and the function
   * `getPointLightInfo`.
   */
  name: string;
  /** The macro for the number of such lights, which three.js replaces by the number. */
  count: string;
  /**
   * Where they shine from, which decides the members of their struct: `direction` and `color` for distant lights; `position`, `color`,
   * `distance` and `decay` for lights at a place. A `sky` is three's hemisphere light, which shines from all around.
   */
  from: 'afar' | 'place' | 'sky';
  /** The call of three's function for the share of such a light that passes its shadow map. */
  shadow?: string;
  /** Its shadow maps, if they are flat or cubes; those of a sun are cascades. */
  maps?: FlatMaps | CubeMaps;
}

/** Shadow maps of a kind of light, as three's chunks have them. */
interface CubeMaps {
  /** The macro for the number of lights that cast shadows. They are the first of their kind. */
  count: string;
}

interface FlatMaps extends CubeMaps {
  /**
   * The uniform of the matrices from world space to the shadow maps, which three.js declares in the vertex shader, and the number of
   * them.
   */
  matrix: string;
  matrices: string;
}

const SHADOW = 'getShadow(map, size, intensity, bias, radius, at)';
const CUBE_SHADOW = 'getPointShadow(map, size, intensity, bias, radius, at, near, far)';

/**
 * Every kind of light that the library's shaders evaluate, in the order of three's `lights_fragment_begin`. A new kind is a row here:
 * no file of shaders/ names any of them.
 */
const LIGHT_KINDS: readonly LightKind[] = [
  {
    name: 'Point',
    count: 'NUM_POINT_LIGHTS',
    from: 'place',
    shadow: CUBE_SHADOW,
    maps: { count: 'NUM_POINT_LIGHT_SHADOWS' },
  },
  {
    name: 'Spot',
    count: 'NUM_SPOT_LIGHTS',
    from: 'place',
    shadow: SHADOW,
    maps: {
      count: 'NUM_SPOT_LIGHT_SHADOWS',
      matrix: 'spotLightMatrix',
      matrices: 'NUM_SPOT_LIGHT_COORDS',
    },
  },
  { name: 'Sun', count: 'NUM_SUN_LIGHTS', from: 'afar', shadow: 'getSunShadow(map, light, index)' },
  {
    name: 'Directional',
    count: 'NUM_DIR_LIGHTS',
    from: 'afar',
    shadow: SHADOW,
    maps: {
      count: 'NUM_DIR_LIGHT_SHADOWS',
      matrix: 'directionalShadowMatrix',
      matrices: 'NUM_DIR_LIGHT_SHADOWS',
    },
  },
  { name: 'Hemisphere', count: 'NUM_HEMI_LIGHTS', from: 'sky' },
];

/** The kinds that the installed three.js supports. The names of others would not be replaced, and would not compile. */
const knownKinds = (): LightKind[] => LIGHT_KINDS.filter(({ count }) => ShaderChunk.lights_pars_begin.includes(count));

/** Defines for the number of lights that have a direction, which are all but skies, and of those at a place. */
export function lightCountDefines(): string {
  const sum = (kinds: LightKind[]): string => `(${kinds.map(({ count }) => count).join(' + ')})`;
  const known = knownKinds();
  return [
    `#define LIGHTS_WITH_DIRECTION ${sum(known.filter(({ from }) => from !== 'sky'))}`,
    `#define POSITIONAL_LIGHTS ${sum(known.filter(({ from }) => from === 'place'))}`,
  ].join('\n');
}

/**
 * Chunks that loop over lights. Before a shader includes one, it defines the macro `VISIT_LIGHT(source, number)`: the code for each
 * light. `source` is three's struct, and `number` counts the lights that have a direction, in three's order. The chunk undefines the
 * macro again.
 *
 * - `eachLight` visits every light that has a direction. The shader declares `IncidentLight light`, into which the chunk writes what
 * arrives at `viewPosition`.
 * - `eachDistantLight` and `eachPositionalLight` visit those that shine from afar, and those that shine from a place.
 * - `eachSky` visits hemisphere lights. Their number has no meaning.
 *
 * `lightShadows` is not a loop: it wraps three's shadow map functions, so that calls go through `KNOWN_SHADOW` and results through
 * `separateShadow`.
 */
export function lightChunks(): Record<string, string> {
  const kinds = knownKinds();
  const walk = (from: LightKind['from'], writesLight = false): string =>
    kinds.map((kind, i) => (kind.from === from ? loopOver(kind, kinds.slice(0, i), writesLight) : '')).join('');
  const end = '#undef VISIT_LIGHT';
  return {
    eachLight: walk('afar', true) + walk('place', true) + end,
    eachDistantLight: walk('afar') + end,
    eachPositionalLight: walk('place') + end,
    eachSky: walk('sky') + end,
    // A macro does not expand within itself, so that the wrapped function can have its own name.
    lightShadows: kinds
      .map(({ shadow }) => (shadow ? `#define ${shadow} separateShadow(KNOWN_SHADOW(${shadow}))\n` : ''))
      .join(''),
  };
}

/**
 * Chunks that loop over shadow maps, as those of {@link lightChunks} loop over lights, at a `viewPosition` and with a `light` of the
 * shader:
 *
 * - `eachFlatShadow` visits every flat shadow map by `VISIT_SHADOW(number, map, matrix, shadow)`: the number of its light, the map, the
 *   matrix that leads to it from the world, and three's struct of the shadow. `shadowMatrices` declares the matrices.
 * - `eachCubeShadow` visits every cube by `VISIT_SHADOW(number, map, fromLight, shadow)`: the third is in view space.
 */
export function shadowChunks(): Record<string, string> {
  const kinds = knownKinds();
  const flat: string[] = [];
  const cubes: string[] = [];
  const matrices: string[] = [];
  for (const [i, { name, from, maps }] of kinds.entries()) {
    if (!maps) continue;
    const { count } = maps;
    const lower = name.toLowerCase();
    const map = `${lower}ShadowMap[i]`;
    const shadow = `${lower}LightShadows[i]`;
    const number = numberAfter(kinds.slice(0, i));
    if ('matrix' in maps) {
      const { matrix, matrices: most } = maps;
      matrices.push(`#if ${count} > 0\nuniform mat4 ${matrix}[${most}];\n#endif\n`);
      const visit = `${readLight(name, from)}\nVISIT_SHADOW(${number}, ${map}, ${matrix}[i], ${shadow})`;
      flat.push(unrolled(count, visit));
    } else {
      const fromLight = `viewPosition - ${lower}Lights[i].position`;
      cubes.push(unrolled(count, `VISIT_SHADOW(${number}, ${map}, ${fromLight}, ${shadow})`));
    }
  }
  const end = '#undef VISIT_SHADOW';
  return {
    shadowMatrices: matrices.join(''),
    eachFlatShadow: flat.join('') + end,
    eachCubeShadow: cubes.join('') + end,
  };
}

function loopOver({ name, count, from }: LightKind, before: readonly LightKind[], writesLight: boolean): string {
  const visit = `VISIT_LIGHT(${name.toLowerCase()}Lights[i], ${numberAfter(before)})`;
  return unrolled(count, `${writesLight ? readLight(name, from) : ''}\n${visit}`);
}

/** The index of a light among all that have a direction. */
const numberAfter = (before: readonly LightKind[]): string =>
  [...before.map((kind) => kind.count), 'UNROLLED_LOOP_INDEX'].join(' + ');

/** Writes the light that arrives from a source into `light`. */
const readLight = (name: string, from: LightKind['from']): string =>
  `get${name}LightInfo(${name.toLowerCase()}Lights[i], ${from === 'place' ? 'viewPosition, ' : ''}light);`;

/** A loop in the form that three.js unrolls: some drivers warn of a loop that runs once. */
const unrolled = (count: string, body: string): string => `#if ${count} > 0
#pragma unroll_loop_start
for (int i = 0; i < ${count}; i++) {
${body}
}
#pragma unroll_loop_end
#endif
`;
