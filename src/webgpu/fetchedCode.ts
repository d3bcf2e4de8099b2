/** Code that is fetched when a material first needs it: patterns of techniques, strokes of a hand, and the fit of the exposure. */
import type { Camera, DataTexture, IUniform, Scene, WebGLRenderer } from 'three';
import type { HatchingTechnique } from '../look/hatchingProperties.js';
import { drawsHand } from '../look/queries.js';
import { isFitted } from '../material/exposure/ToneFit.js';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import type { Hand } from '../strokes/hand/Hand.js';
import type { FamilyPrinter } from './nodes/lines/ruledLines.js';
import type { hatchLayer } from './nodes/strokes/stipple.js';

/** Code that is imported when a material first needs it. */
export class Later<Code> {
  /** Undefined until it is loaded. */
  code: Code | undefined;
  private fetching: Promise<void> | undefined;

  /** @param what the task of the code, as a verb phrase. @param without the effect while it is missing, as a clause */
  constructor(
    private readonly what: string,
    private readonly without: string,
    private readonly load: () => Promise<Code>,
  ) {}

  /** Imports the code, once. After a failure the next call tries again. @throws Error that says what could not be fetched */
  fetch(): Promise<void> {
    this.fetching ??= this.load().then(
      (code) => {
        this.code = code;
      },
      (cause: unknown) => {
        this.fetching = undefined;
        const message = `HatchingNodeMaterial: the code that ${this.what} could not be fetched; ${this.without}. Serve all files of the package; the next frame, or "ready", tries again.`;
        console.error(message);
        throw new Error(message, { cause });
      },
    );
    return this.fetching;
  }

  /** Starts the import without waiting for it. @param whenThere called once it is loaded */
  ask(whenThere?: () => void): void {
    // `fetch` reports its failure itself.
    this.fetch().then(whenThere, () => {});
  }
}

/** The code of a technique's pattern. */
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

/** The pattern of each technique that has one. */
const PATTERNS: Readonly<Partial<Record<HatchingTechnique, Pattern>>> = {
  dryMedia: {
    name: 'toothMap',
    made: /* @__PURE__ */ new Later('makes the tooth of paper', 'surfaces are plain paper', async () => ({
      texture: (await import('../material/tam/toothMap.js')).toothMap,
    })),
  },
  stipple: {
    name: 'stippleMap',
    made: /* @__PURE__ */ new Later('places dots', 'surfaces are plain paper', async () => {
      const codes = [import('../material/tam/stippleMap.js'), import('./nodes/strokes/stipple.js')] as const;
      const [{ stippleMap }, { hatchLayer }] = await Promise.all(codes);
      return { texture: stippleMap, dotLayer: hatchLayer };
    }),
  },
};

type Look = Pick<HatchingMaterialProperties, 'technique'>;

const patternOf = ({ technique }: Look): Pattern | undefined => PATTERNS[technique];

/** Resolves when the pattern of a material's technique is loaded, or it has none. */
export const patternReady = async (look: Look): Promise<void> => patternOf(look)?.made.fetch();

/** The function that prints the dots of a material, once it is loaded. Nodes built before that print none. */
export const dotLayerOf = (look: Look): Code['dotLayer'] => patternOf(look)?.made.code?.dotLayer;

/**
 * Writes the pattern of a material's technique, once it is loaded.
 *
 * @param whenThere called when it is loaded, if it is not yet
 * @returns whether it is loaded, or the technique has none
 */
export function writePattern(look: Look, uniforms: Record<string, IUniform>, whenThere: () => void): boolean {
  const pattern = patternOf(look);
  if (!pattern) return true;
  const { code } = pattern.made;
  if (code) uniforms[pattern.name].value = code.texture();
  else pattern.made.ask(whenThere);
  return code !== undefined;
}

const ofHands = /* @__PURE__ */ new Later(
  'draws the strokes of a hand',
  'plain strokes of a pen are drawn',
  async () => {
    const codes = [import('../material/parts/handRows.js'), import('./nodes/lines/handStrokes.js')] as const;
    const [{ part }, { castShadowsOf, ruledLines }] = await Promise.all(codes);
    return { ...part, castShadowsOf, printer: ruledLines as FamilyPrinter };
  },
);

/** A look that may draw the strokes of a hand. */
type HandLook = Pick<HatchingMaterialProperties, 'technique' | 'hand'>;

/** Resolves when the code of the strokes of a hand is loaded, or a look draws none. */
export const handReady = async (look: HandLook): Promise<void> => {
  if (drawsHand(look)) await ofHands.fetch();
};

/** The code that prints the strokes of a hand, if a look draws them and the code is loaded. */
export const handCodeOf = (look: HandLook): typeof ofHands.code => (drawsHand(look) ? ofHands.code : undefined);

/** Finds every fault of a hand, once the code is loaded. @throws TypeError or RangeError with the fault */
export const checkStrokes = (hand: Hand): void => ofHands.code?.checkHand(hand);

/**
 * Writes the strokes of a material's hand and its numbers after all other values, once the code is loaded. Allocates nothing after the first
 * call.
 *
 * @param whenThere called when it is loaded, if it is not yet
 */
export function writeHand(
  material: HatchingMaterialProperties,
  pixelRatio: number,
  uniforms: Record<string, IUniform>,
  whenThere: () => void,
): void {
  if (!drawsHand(material)) return;
  const { code } = ofHands;
  if (code) code.writeUniforms(uniforms, material, pixelRatio);
  else ofHands.ask(whenThere);
}

const fitting = /* @__PURE__ */ new Later(
  'fits an exposure',
  'the exposure is 1',
  () => import('../material/parts/exposure.js'),
);

/** Resolves when the code that fits a material's exposure is loaded, or is not needed. */
export const exposureReady = async (material: HatchingMaterialProperties): Promise<void> => {
  if (!isFitted(material)) return;
  await fitting.fetch();
  await fitting.code?.fetchPlansOf(material);
};

/** Writes the exposure that suits the scene kept or of the present frame, if `exposure` is fitted, once the code is loaded. */
export function writeExposure(
  material: HatchingMaterialProperties,
  renderer: WebGLRenderer,
  scene: Scene,
  camera: Camera,
  uniforms: Record<string, IUniform>,
): void {
  if (!isFitted(material)) return;
  const { code } = fitting;
  const { composition } = material;
  if (!code) {
    fitting.ask();
    return;
  }
  const fit = composition.keptFit ?? code.sceneExposure(renderer, scene, camera);
  code.writeFit(composition.kept(fit), material, uniforms);
}
