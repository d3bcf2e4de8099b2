import { ShaderChunk } from 'three';

/** A kind of light of three.js, by the names that three's shader chunks have for it. */
interface LightKind {
  /** The number of such lights; three.js writes it in the place of this name. */
  count: string;
  /** The uniform that holds them, an array of structs. */
  lights: string;
  /**
   * Where they shine from, and with it what their struct has: `direction` and `color` where that is far away, `position`, `color`,
   * `distance` and `decay` where it is a place. A sky is three's hemisphere light.
   */
  from: 'afar' | 'place' | 'sky';
  /** three's function that says what arrives of one: it writes an `IncidentLight`. */
  info?: string;
  /** three's function that says how much of one passes its shadow map, as it is called. */
  shadow?: string;
}

/**
 * Every kind of light that our shaders look at, in the order of three's `lights_fragment_begin`. A new kind is a row here: no
 * file of shaders/ names any of them.
 */
const LIGHT_KINDS: readonly LightKind[] = [
  {
    count: 'NUM_POINT_LIGHTS',
    lights: 'pointLights',
    from: 'place',
    info: 'getPointLightInfo',
    shadow: 'getPointShadow(map, size, intensity, bias, radius, at, near, far)',
  },
  {
    count: 'NUM_SPOT_LIGHTS',
    lights: 'spotLights',
    from: 'place',
    info: 'getSpotLightInfo',
    shadow: 'getShadow(map, size, intensity, bias, radius, at)',
  },
  {
    count: 'NUM_SUN_LIGHTS',
    lights: 'sunLights',
    from: 'afar',
    info: 'getSunLightInfo',
    shadow: 'getSunShadow(map, light, index)',
  },
  {
    count: 'NUM_DIR_LIGHTS',
    lights: 'directionalLights',
    from: 'afar',
    info: 'getDirectionalLightInfo',
    shadow: 'getShadow(map, size, intensity, bias, radius, at)',
  },
  { count: 'NUM_HEMI_LIGHTS', lights: 'hemisphereLights', from: 'sky' },
];

/** The kinds that the installed three.js has: it replaces no other names, and GLSL would not know them. */
const knownKinds = (): LightKind[] => LIGHT_KINDS.filter(({ count }) => ShaderChunk.lights_pars_begin.includes(count));

const withDirection = (kinds: readonly LightKind[]): LightKind[] => kinds.filter(({ from }) => from !== 'sky');

/** The number of lights that have a direction, which are all but skies, as a define. */
export const lightCountDefine = (): string =>
  `#define LIGHTS_WITH_DIRECTION (${withDirection(knownKinds())
    .map(({ count }) => count)
    .join(' + ')})`;

/**
 * Chunks that walk over lights. Before it includes one, a shader defines the macro `VISIT_LIGHT`: what it does with each light. The
 * chunk undefines it again.
 *
 * - `eachLight`: `VISIT_LIGHT(source, number)` for every light that has a direction. `source` is three's struct, `number` counts all of
 *   these lights in three's order. The shader declares `IncidentLight light`, which holds what arrives at `viewPosition`.
 * - `eachDistantLight` and `eachPositionalLight`: the same for those that shine from afar, and from a place. They write no `light`.
 * - `eachSky`: `VISIT_LIGHT(source)` for every hemisphere light.
 *
 * `lightShadows` is no walk. It makes what three's functions of shadow maps return go through `tellShadow`.
 */
export function lightChunks(): Record<string, string> {
  const kinds = knownKinds();
  const walk = (from: LightKind['from'], writesLight = false): string =>
    kinds.map((kind, index) => (kind.from === from ? loopOver(kind, kinds.slice(0, index), writesLight) : '')).join('');
  const shadows = new Set(withDirection(kinds).map(({ shadow }) => shadow));
  return {
    eachLight: `${walk('afar', true)}${walk('place', true)}#undef VISIT_LIGHT`,
    eachDistantLight: `${walk('afar')}#undef VISIT_LIGHT`,
    eachPositionalLight: `${walk('place')}#undef VISIT_LIGHT`,
    eachSky: `${walk('sky')}#undef VISIT_LIGHT`,
    // A macro does not expand within itself.
    lightShadows: [...shadows].map((shadow) => `#define ${shadow} tellShadow(${shadow})`).join('\n'),
  };
}

/** In the form that three.js unrolls: some drivers warn of a loop that runs once. */
function loopOver(
  { count, lights, from, info }: LightKind,
  before: readonly LightKind[],
  writesLight: boolean,
): string {
  const source = `${lights}[i]`;
  const number = [...withDirection(before).map((kind) => kind.count), 'UNROLLED_LOOP_INDEX'].join(' + ');
  return `#if ${count} > 0
#pragma unroll_loop_start
for (int i = 0; i < ${count}; i++) {
${writesLight ? `${info}(${source}, ${from === 'place' ? 'viewPosition, ' : ''}light);` : ''}
VISIT_LIGHT(${from === 'sky' ? source : `${source}, ${number}`})
}
#pragma unroll_loop_end
#endif
`;
}
