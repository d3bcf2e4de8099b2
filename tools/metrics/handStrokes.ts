/** Measures the strokes of hands: how whole they are, their tones, how steady they are, and their numbers on a plane. */
import { type BufferGeometry, MeshLambertMaterial, PlaneGeometry, Vector3, type WebGLRenderer } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import {
  type Hand,
  type HandNumbers,
  HatchingMaterial,
  type HatchingMaterialParameters,
  learnHand,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { HATCHING_PROPERTIES } from 'three-hatching/facts';
import { type ExampleHandName, exampleHand } from 'three-hatching/hands';
import { traceStrokesSteps } from '../../src/strokes/strokeTracing/traceStrokesSteps.js';
import { plainLook } from '../plainLook.js';
import { loadModel, type ModelName, parseModel } from './loadModel.js';
import { type BlockTones, blockTones } from './measures/blockTones.js';
import { centreLines } from './measures/centreLines.js';
import { type LocatedImage, poppingIndex, reprojectedChange } from './measures/reprojectedChange.js';
import type { SurfaceImage } from './measures/SurfaceImage.js';
import { silhouetteDistances } from './measures/silhouetteDistances.js';
import { type Wholeness, wholeness } from './measures/wholeness.js';
import { SurfaceCamera } from './SurfaceCamera.js';

const SIZE = 900;
/** Pictures of motion are smaller: there are many, and they are compared with like ones. */
const MOVING_SIZE = 400;
/** The width of strokes on the screen, in pixels. */
const STROKE_WIDTH = 2.4;
/** How much larger strokes are drawn to be traced. */
const TRACED = 2.5;
/** The tones at which strokes are measured one by one. */
const LIGHT_TONES = [0.1, 0.25];
const ALL_TONES = [0.03, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95];
/** How many times as near the camera is. */
const DISTANCES = [0.6, 1, 1.7];
const FRAMES = 24;
/** How far the camera comes nearer, goes round, and the light goes round, in all frames. */
const [NEARER, ROUND, LIGHT_ROUND] = [2, 24, 36];
const MOVING_TONE = 0.25;

/** A model of the metrics, or the text of an OBJ file. */
export type StrokeModel = { name: ModelName } | { text: string };

/** How strokes of a hand are drawn: whole in rows, or in a map. */
export type StrokeKind = 'rows' | 'map';

/** Whether the material draws with a hand without a map. */
export const strokeKind = (): StrokeKind => ('hand' in HATCHING_PROPERTIES ? 'rows' : 'map');

/** A material that draws with a hand, and what it was drawn with. */
interface Drawn {
  hand: Hand;
  material: HatchingMaterial;
  /** Pixels to a millimetre of the sheet. */
  scale: number;
  dispose(): void;
}

/** @param times how many times as large as usual the strokes are */
async function drawnWith(name: ExampleHandName, times = 1): Promise<Drawn> {
  const hand = exampleHand(name);
  const strokeWidth = STROKE_WIDTH * times;
  const common: HatchingMaterialParameters = { screenSpaceShare: 1, direction: 'form', strokeWidth };
  const scale = strokeWidth / hand.numbers.width;
  if (strokeKind() === 'rows') {
    const { crossFrom: _, ...plain } = plainLook({ ...common, technique: 'pen' });
    const material = new HatchingMaterial({ ...plain, hand } as HatchingMaterialParameters);
    return { hand, material, scale, dispose: () => material.dispose() };
  }
  const tonalArtMap = await TonalArtMap.generate({ hand, size: 512, strokeTexels: 2.6 });
  const material = new HatchingMaterial(plainLook({ ...common, technique: 'hatching', tonalArtMap, edgePixels: 0 }));
  const dispose = (): void => {
    material.dispose();
    tonalArtMap.dispose();
  };
  return { hand, material, scale, dispose };
}

const prepared = async (geometry: BufferGeometry): Promise<BufferGeometry> =>
  prepareHatchingGeometry(geometry, { form: true });

const loaded = async (model: StrokeModel): Promise<BufferGeometry> =>
  prepared('name' in model ? await loadModel(model.name) : parseModel(model.text));

/** How whole the strokes of a hand are in one picture. */
export interface PicturedWholeness extends Wholeness {
  tone: number;
  /** How many times as near as usual the camera is. */
  nearness: number;
}

/** Measures the strokes of hands on a model in even tones. */
export async function measureWholeness(
  renderer: WebGLRenderer,
  model: StrokeModel,
  hands: readonly ExampleHandName[],
): Promise<Partial<Record<ExampleHandName, PicturedWholeness[]>>> {
  const geometry = await loaded(model);
  const found: Partial<Record<ExampleHandName, PicturedWholeness[]>> = {};
  for (const name of hands) {
    const { hand, material, scale, dispose } = await drawnWith(name);
    const camera = new SurfaceCamera(renderer, SIZE, geometry, material);
    found[name] = DISTANCES.flatMap((nearness) => {
      camera.dolly(new Vector3(), nearness);
      const distances = silhouetteDistances(camera.shootLocated());
      return LIGHT_TONES.map((tone) => {
        const lines = centreLines(camera.evenlyToned(tone).shoot());
        return { tone, nearness, ...wholeness(lines, scale * hand.numbers.length, distances) };
      });
    });
    camera.dispose();
    dispose();
  }
  geometry.dispose();
  return found;
}

/** The tones of a wall in the light and in the shadow of bars. */
const BARRED = [
  [0.03, 0.3],
  [0.1, 0.5],
] as const;
/** The bars: their number, and their width as a share of their distance. */
const [BARS, BAR_WIDTH] = [4, 0.5];

/** Measures the strokes of hands at the hard edges of shadows: pieces whose middle is within half a length of one. */
export async function measureAtShadows(
  renderer: WebGLRenderer,
  hands: readonly ExampleHandName[],
): Promise<Partial<Record<ExampleHandName, PicturedWholeness[]>>> {
  const geometry = await wall();
  const bars = barsBeforeWall();
  const found: Partial<Record<ExampleHandName, PicturedWholeness[]>> = {};
  for (const name of hands) {
    const { hand, material, scale, dispose } = await drawnWith(name);
    found[name] = BARRED.map(([lit, shaded]) => {
      const camera = new SurfaceCamera(renderer, SIZE, geometry, material).barred(lit, shaded, bars);
      const plain = new SurfaceCamera(renderer, SIZE, geometry, flat as unknown as HatchingMaterial);
      const drawn = scale * hand.numbers.length;
      const edges = nearEdges(plain.barred(0, 1, bars).shoot(), 0.5 * drawn);
      const lines = centreLines(camera.shoot());
      for (const one of [camera, plain]) one.dispose();
      return { tone: shaded, nearness: 1, ...wholeness(lines, drawn, edges) };
    });
    dispose();
  }
  renderer.shadowMap.enabled = false;
  for (const one of [geometry, bars]) one.dispose();
  return found;
}

const flat = new MeshLambertMaterial();

/** Upright bars half way to the light. */
function barsBeforeWall(): BufferGeometry {
  const bars = Array.from({ length: BARS }, (_, i) =>
    new PlaneGeometry(BAR_WIDTH * (4 / BARS), 6).translate((4 / BARS) * (i - 0.5 * (BARS - 1)), 0, 0.4),
  );
  return mergeGeometries(bars);
}

/** Infinity at pixels near a step of luminance along a row of the picture, and 0 at others. */
function nearEdges({ width, height, luminance }: SurfaceImage, reach: number): Float32Array {
  const near = new Float32Array(width * height);
  for (let y = 0; y < height; y++)
    for (let x = 1; x < width; x++) {
      const i = width * y + x;
      if (luminance[i] > 0.3 === luminance[i - 1] > 0.3) continue;
      near.fill(Infinity, i - Math.min(Math.round(reach), x), i + Math.min(Math.round(reach), width - x));
    }
  return near;
}

/** The tones of a hand, by what was asked for. */
export type HandTones = Record<string, BlockTones>;

/** Measures all tones of a hand, on a model or, without one, on a wall that fills the picture. */
export async function measureTones(
  renderer: WebGLRenderer,
  model: StrokeModel | undefined,
  name: ExampleHandName,
): Promise<HandTones> {
  const geometry = model ? await loaded(model) : await wall();
  const { material, dispose } = await drawnWith(name);
  const camera = new SurfaceCamera(renderer, SIZE, geometry, material);
  const tones = Object.fromEntries(
    ALL_TONES.map((tone) => [tone, blockTones(camera.evenlyToned(tone).shoot(), tone)] as const),
  );
  for (const thing of [camera, geometry]) thing.dispose();
  dispose();
  return tones;
}

const wall = (): Promise<BufferGeometry> => prepared(new PlaneGeometry(4, 4, 24, 24));

/** The mean change of luminance from frame to frame, and the largest change over their median. */
export interface Steadiness {
  change: number;
  popping: number;
}

/** What changes while one thing moves. */
export interface HandMotion {
  zoom: Steadiness;
  camera: Steadiness;
  light: Steadiness;
}

/**
 * Measures how steady the strokes of a hand are on a model.
 *
 * @param name of the hand; undefined for lines of a pen as far apart as the strokes of a middle swatch are in the mean
 */
export async function measureMotion(
  renderer: WebGLRenderer,
  model: StrokeModel,
  name: ExampleHandName | undefined,
): Promise<HandMotion> {
  const geometry = await loaded(model);
  const { material, dispose } = name ? await drawnWith(name) : linesOfPen();
  const camera = new SurfaceCamera(renderer, MOVING_SIZE, geometry, material);
  const middle = new Vector3();
  const filmed = (place: (share: number) => SurfaceCamera): Steadiness => {
    const changes: number[] = [];
    let before: LocatedImage | undefined;
    for (let frame = 0; frame <= FRAMES; frame++) {
      const after = place(frame / FRAMES).shootLocated();
      if (before) changes.push(reprojectedChange(before, after).luminance);
      before = after;
    }
    const change = changes.reduce((sum, one) => sum + one, 0) / changes.length;
    return { change, popping: poppingIndex(changes) };
  };
  const even = camera.evenlyToned(MOVING_TONE);
  const motion = {
    zoom: filmed((share) => even.dolly(middle, NEARER ** share)),
    camera: filmed((share) => even.orbit(ROUND * share)),
    light: filmed((share) => camera.view().lit(LIGHT_ROUND * share)),
  };
  for (const thing of [camera, geometry]) thing.dispose();
  dispose();
  return motion;
}

function linesOfPen(): Pick<Drawn, 'material' | 'dispose'> {
  const material = new HatchingMaterial(
    plainLook({ technique: 'pen', screenSpaceShare: 1, direction: 'form', lineSpacing: 2.5 * STROKE_WIDTH }),
  );
  return { material, dispose: () => material.dispose() };
}

/** The numbers of a hand on its sheet, and of its strokes as they are traced on a wall; lengths of both in millimetres. */
export interface NumbersOnWall {
  tone: number;
  strokes: number;
  sheet: HandNumbers;
  wall: HandNumbers;
}

/** Draws a wall as dark as the middle swatch of a hand, traces its strokes, and learns their numbers. */
export async function measureNumbers(renderer: WebGLRenderer, name: ExampleHandName): Promise<NumbersOnWall> {
  const geometry = await wall();
  const { hand, material, scale, dispose } = await drawnWith(name, TRACED);
  const camera = new SurfaceCamera(renderer, SIZE, geometry, material);
  const tone = toneOfMiddle(hand);
  const image = camera.evenlyToned(tone).shoot();
  const traced = learnHand(tracedFrom(image, 1 / scale));
  for (const thing of [camera, geometry]) thing.dispose();
  dispose();
  return { tone, strokes: traced.strokes.length, sheet: hand.numbers, wall: traced.numbers };
}

/** The share of ink between neighbouring strokes of the middle swatch, up to a half: the first layer alone. */
function toneOfMiddle({ strokes, numbers }: Hand): number {
  const widths = strokes.filter(({ swatch }) => swatch === 'middle').flatMap((stroke) => stroke.widths);
  const width = widths.reduce((sum, value) => sum + value, 0) / widths.length;
  return Math.min(0.5, width / numbers.spacing / (1 - Math.min(0.5, numbers.overlap)));
}

function tracedFrom({ width, height, luminance }: SurfaceImage, millimetresPerPixel: number) {
  const data = Uint8Array.from(luminance, (value) => 255 * value);
  const steps = traceStrokesSteps({ image: { width, height, data }, millimetresPerPixel, swatch: 'middle' });
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
