import type { DataTexture, IUniform } from 'three';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import { Later } from './Later.js';
import type { hatchLayer } from './nodes/anchored/stipple.js';

/** The code of a medium's pattern. */
interface Code {
  readonly texture: () => DataTexture;
  /** Prints dots; stipple alone has it. */
  readonly dotLayer?: typeof hatchLayer;
}

interface Pattern {
  /** The uniform of the pattern's texture. */
  readonly name: string;
  readonly made: Later<Code>;
}

/** The pattern of each medium that has one. */
const PATTERNS: Readonly<Partial<Record<string, Pattern>>> = {
  dry: {
    name: 'toothMap',
    made: /* @__PURE__ */ new Later('makes the tooth of paper', 'surfaces are plain paper', async () => ({
      texture: (await import('../material/tam/toothMap.js')).toothMap,
    })),
  },
  stipple: {
    name: 'stippleMap',
    made: /* @__PURE__ */ new Later('places dots', 'surfaces are plain paper', async () => {
      const codes = [import('../material/tam/stippleMap.js'), import('./nodes/anchored/stipple.js')] as const;
      const [{ stippleMap }, { hatchLayer }] = await Promise.all(codes);
      return { texture: stippleMap, dotLayer: hatchLayer };
    }),
  },
};

type Look = Pick<HatchingMaterialProperties, 'technique' | 'medium'>;

const patternOf = ({ technique, medium }: Look): Pattern | undefined =>
  technique === 'anchored' ? PATTERNS[medium] : undefined;

/** Resolves when the pattern of a material's medium is loaded, or it has none. */
export const patternReady = async (look: Look): Promise<void> => patternOf(look)?.made.fetch();

/** The function that prints the dots of a material, once it is loaded. Nodes built before that print none. */
export const dotLayerOf = (look: Look): Code['dotLayer'] => patternOf(look)?.made.code?.dotLayer;

/**
 * Writes the pattern of a material's medium, once it is loaded.
 *
 * @param whenThere called when it is loaded, if it is not yet
 * @returns whether it is loaded, or the medium has none
 */
export function writePattern(look: Look, uniforms: Record<string, IUniform>, whenThere: () => void): boolean {
  const pattern = patternOf(look);
  if (!pattern) return true;
  const { code } = pattern.made;
  if (code) uniforms[pattern.name].value = code.texture();
  else pattern.made.ask(whenThere);
  return code !== undefined;
}
