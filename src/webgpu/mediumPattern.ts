import type { DataTexture, IUniform } from 'three';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import { Later } from './Later.js';
import type { hatchLayer } from './nodes/anchored/stipple.js';

/** What a medium is drawn with. */
interface Code {
  readonly texture: () => DataTexture;
  /** What prints dots, which no other medium has. */
  readonly dotLayer?: typeof hatchLayer;
}

interface Pattern {
  /** The uniform that holds it. */
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

/** Resolves when the pattern of a material's medium is there, or it has none. */
export const patternReady = async (look: Look): Promise<void> => patternOf(look)?.made.fetch();

/** What prints the dots of a material, as soon as it is there; nodes that are built before print none. */
export const dotLayerOf = (look: Look): Code['dotLayer'] => patternOf(look)?.made.code?.dotLayer;

/**
 * Writes the pattern of a material's medium, as soon as it is there.
 *
 * @param whenThere called when it comes later
 * @returns whether there is nothing to wait for
 */
export function writePattern(look: Look, uniforms: Record<string, IUniform>, whenThere: () => void): boolean {
  const pattern = patternOf(look);
  if (!pattern) return true;
  const { code } = pattern.made;
  if (code) uniforms[pattern.name].value = code.texture();
  else pattern.made.ask(whenThere);
  return code !== undefined;
}
