import type { DataTexture, IUniform } from 'three';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import { Later } from './Later.js';

interface Pattern {
  /** The uniform that holds it. */
  readonly name: string;
  readonly made: Later<() => DataTexture>;
}

/** The pattern of each medium that has one. */
const PATTERNS: Readonly<Partial<Record<string, Pattern>>> = {
  dry: {
    name: 'toothMap',
    made: /* @__PURE__ */ new Later(
      'makes the tooth of paper',
      'surfaces are plain paper',
      async () => (await import('../tam/toothMap.js')).toothMap,
    ),
  },
  stipple: {
    name: 'stippleMap',
    made: /* @__PURE__ */ new Later(
      'places dots',
      'surfaces are plain paper',
      async () => (await import('../tam/stippleMap.js')).stippleMap,
    ),
  },
};

type Look = Pick<HatchingMaterialProperties, 'technique' | 'medium'>;

const patternOf = ({ technique, medium }: Look): Pattern | undefined =>
  technique === 'anchored' ? PATTERNS[medium] : undefined;

/** Resolves when the pattern of a material's medium is there, or it has none. */
export const patternReady = async (look: Look): Promise<void> => patternOf(look)?.made.fetch();

/** Writes the pattern of a material's medium, as soon as it is there. @returns whether there is nothing to wait for */
export function writePattern(look: Look, uniforms: Record<string, IUniform>): boolean {
  const pattern = patternOf(look);
  if (!pattern) return true;
  const { code } = pattern.made;
  if (code) uniforms[pattern.name].value = code();
  else pattern.made.ask();
  return code !== undefined;
}
