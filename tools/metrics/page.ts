/** The page of the metrics: measures one model with every technique. */
import { type BufferGeometry, PlaneGeometry, Vector3, WebGLRenderer } from 'three';
import {
  HatchingMaterial,
  type HatchingMaterialParameters,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { counts, followsForm, needsMap } from 'three-hatching/facts';
import { HATCHING_TECHNIQUES } from '../../src/look/hatchingProperties.js';
import { plainLook } from '../plainLook.js';
import { type FlatTones, measureFlatTones } from './flatTones.js';
import {
  measureAtShadows,
  measureMotion,
  measureNumbers,
  measureTones,
  measureWholeness,
  strokeKind,
} from './handStrokes.js';
import { type IntersectionMeasure, measureIntersections } from './intersections.js';
import { loadModel, type ModelName } from './loadModel.js';
import { measureLines } from './measureLines.js';
import { type EdgeJump, edgeJump } from './measures/edgeJump.js';
import { greyness } from './measures/greyness.js';
import { meanInk } from './measures/meanInk.js';
import { normalisedFlips } from './measures/normalisedFlips.js';
import { pairedEdges } from './measures/pairedEdges.js';
import { type FrameChange, type LocatedImage, poppingIndex, reprojectedChange } from './measures/reprojectedChange.js';
import type { SurfaceImage } from './measures/SurfaceImage.js';
import { strokeCoherence } from './measures/strokeCoherence.js';
import { type StrokeKink, strokeKink } from './measures/strokeKink.js';
import { strokeLength } from './measures/strokeLength.js';
import { halfSpread, strokeSpacing } from './measures/strokeSpacing.js';
import type { Vector } from './measures/vector.js';
import { measurePrintedStrokes, type PrintedStrokes } from './printedStrokes.js';
import { SurfaceCamera, TO_LIGHT } from './SurfaceCamera.js';
import { measureScene, type SceneValues } from './sceneValues.js';
import { type ModelValues, measuredModels, measureValues } from './valueShares.js';
import { measureWalls, type WallMeasure } from './walls.js';

// Scenes test one thing each and are odd on purpose, so warnings about looks are off.
HatchingMaterial.silent = true;

/** The first technique. Where stroke spacing matters, the others are scaled to its spacing. */
const TECHNIQUES: [string, HatchingMaterialParameters][] = [
  ['hatching', { technique: 'hatching' }],
  ['engraving', { technique: 'engraving', screenSpaceShare: 1 }],
  ['engraving, x', { technique: 'engraving', screenSpaceShare: 1, direction: 'x' }],
  ['engraving, form', { technique: 'engraving', screenSpaceShare: 1, direction: 'form' }],
  ['adjacency', { technique: 'adjacency' }],
  ['adjacency, crisp', { technique: 'adjacency', perTriangle: { sharpInk: true } }],
  ['triangle', { technique: 'triangle' }],
];

/** The slower measures to take. */
export interface Plan {
  edges: boolean;
  light: boolean;
  /** A hundred pictures per technique. */
  camera: boolean;
}

export interface TechniqueMetrics {
  greyness: number;
  /** Mean ink per requested tone. */
  ink: Record<string, number>;
  coherence: number;
  /** Spacing of strokes at a light tone, as a share of the map's own; only for strokes of a map. */
  strokeLength?: number;
  /** Pixels between strokes. */
  spacing: number;
  edgeJump?: EdgeJump;
  kink?: StrokeKink;
  /** Normalised flips as the light turns, at the stroke scale that gives all techniques the same spacing. */
  light?: { tilesPerObjectUnit: number; spacing: number; flips: { degrees: number; share: number }[] };
  /** Changes from frame to frame as the camera comes nearer: normalised flips, and luminance. */
  dolly?: { flips: number[]; popping: number; luminance: number[]; luminancePopping: number };
  /** Spacing in pixels as the camera comes nearer; octaveSpread: at the whole octaves of the way, 1, 2, 4 and 8 times as near. */
  zoom?: { spacings: number[]; spread: number; octaveSpread: number };
}

export interface ModelMetrics {
  triangles: number;
  techniques: Record<string, TechniqueMetrics>;
}

/** A measure with the renderer of the page. */
type OnPage<Measure> = Measure extends (renderer: WebGLRenderer, ...rest: infer Rest) => Promise<infer Result>
  ? (...rest: Rest) => Promise<Result>
  : never;

declare global {
  interface Window {
    measureModel(model: ModelName, plan: Plan, text?: string): Promise<ModelMetrics>;
    measureFlatTones(): Promise<FlatTones>;
    measuredModels: typeof measuredModels;
    measureValues(source: Parameters<typeof measureValues>[1]): Promise<ModelValues>;
    measureScene(source: Parameters<typeof measureScene>[1], planned: number): Promise<SceneValues>;
    measurePrintedStrokes(): Promise<PrintedStrokes[]>;
    measureLines: typeof measureLines;
    /** Measures of the strokes of hands. */
    handStrokes: {
      kind: ReturnType<typeof strokeKind>;
      wholeness: OnPage<typeof measureWholeness>;
      atShadows: OnPage<typeof measureAtShadows>;
      tones: OnPage<typeof measureTones>;
      motion: OnPage<typeof measureMotion>;
      numbers: OnPage<typeof measureNumbers>;
    };
    /** Measures the named looks; all by default. */
    measureWalls(wanted: readonly string[]): Promise<WallMeasure[]>;
    measureIntersections(): IntersectionMeasure[];
  }
}

const SIZE = 400;
/** Measures of motion use smaller pictures: they take many, and compare only like with like. */
const MOVING_SIZE = 256;
/** Strokes as in a picture of 1000 pixels at the default scale: the whole model reduced, or its middle at full size. */
const WHOLE = { zoom: 1, tilesPerObjectUnit: 1.2 };
const MIDDLE = { zoom: 2.5, tilesPerObjectUnit: 3 };
const TONES = [0.1, 0.25, 0.4, 0.6, 0.8];
const LIGHT_TURNS = [0.1, 0.5, 1, 2];
/** The tone of one image of the default map of eight tones, so that no technique blends two images. */
const EVEN_TONE = 3 / 7;
/** A tone in which strokes of the map lie apart. */
const LIGHT_TONE = 0.25;
/** The camera comes up to eight times nearer. */
const OCTAVES = 3;
const DOLLY_FRAMES = 45;
const ZOOM_STEPS = 12;
const CREASE = (40 * Math.PI) / 180;
/** Least cosine between normal and line of sight at which foreshortening hardly changes the stroke spacing. */
const LEAST_FACING = 0.8;

const renderer = new WebGLRenderer({ antialias: false });
renderer.setSize(8, 8, false);
document.body.append(renderer.domElement);
let tonalArtMap: TonalArtMap | undefined;
/** Length by spacing of strokes as the map draws them. */
let drawnLength: number | undefined;

window.measuredModels = measuredModels;
window.measureValues = async (source) => {
  await HatchingMaterial.preload();
  return measureValues(renderer, source);
};

window.measureScene = async (...args) => {
  await HatchingMaterial.preload();
  return measureScene(renderer, ...args);
};

window.measureFlatTones = async () => {
  await HatchingMaterial.preload();
  return measureFlatTones(renderer);
};

window.measurePrintedStrokes = async () => {
  await HatchingMaterial.preload();
  return measurePrintedStrokes(renderer);
};

/** Loads the parts of the material first. */
const onPage =
  <Rest extends unknown[], Result>(measure: (renderer: WebGLRenderer, ...rest: Rest) => Promise<Result>) =>
  async (...rest: Rest): Promise<Result> => {
    await HatchingMaterial.preload();
    return measure(renderer, ...rest);
  };

window.handStrokes = {
  kind: strokeKind(),
  wholeness: onPage(measureWholeness),
  atShadows: onPage(measureAtShadows),
  tones: onPage(measureTones),
  motion: onPage(measureMotion),
  numbers: onPage(measureNumbers),
};
window.measureIntersections = measureIntersections;
window.measureWalls = async (wanted) => {
  await HatchingMaterial.preload();
  return measureWalls(renderer, wanted);
};

window.measureLines = async (...args) => {
  await HatchingMaterial.preload();
  return measureLines(...args);
};

window.measureModel = async (name, plan, text) => {
  tonalArtMap ??= await TonalArtMap.generate();
  await HatchingMaterial.preload();
  drawnLength ??= await measureDrawnLength(tonalArtMap);
  const geometry = await prepareHatchingGeometry(await loadModel(name, text), { adjacency: true, form: true });
  const metrics: ModelMetrics = { triangles: geometry.userData.hatching.triangles, techniques: {} };
  const edges = plan.edges ? pairedEdges(geometry.getAttribute('position').array, CREASE) : new Uint32Array();
  let wantedSpacing: number | undefined;
  for (const [technique, parameters] of TECHNIQUES) {
    const material = new HatchingMaterial(
      plainLook(
        HATCHING_TECHNIQUES[parameters.technique!].map === 'none'
          ? parameters
          : { ...parameters, tonalArtMap, edgePixels: 0 },
      ),
    );
    const still = new SurfaceCamera(renderer, SIZE, geometry, material);
    const measured: TechniqueMetrics = {
      ...measureWhole(still, material),
      ...measureMiddle(still, material),
      ...(edges.length > 0 && {
        edgeJump: measureEdges(still, edges),
        // Lines that follow the form are not cut out of the triangles by planes.
        ...(!followsForm(material) && { kink: measureKink(geometry, edges, material) }),
      }),
    };
    wantedSpacing ??= measured.spacing;
    if (plan.light) measured.light = measureLight(still, material, wantedSpacing);
    if (plan.camera) {
      const moving = new SurfaceCamera(renderer, MOVING_SIZE, geometry, material);
      measured.dolly = measureDolly(moving, material);
      measured.zoom = measureZoom(still, material);
      moving.dispose();
    }
    still.dispose();
    material.dispose();
    metrics.techniques[technique] = measured;
  }
  geometry.dispose();
  return metrics;
};

function measureWhole(camera: SurfaceCamera, material: HatchingMaterial) {
  material.tilesPerObjectUnit = WHOLE.tilesPerObjectUnit;
  camera.view(WHOLE.zoom);
  return {
    greyness: greyness(camera.lit().shoot()),
    ink: Object.fromEntries(TONES.map((tone) => [tone, meanInk(camera.evenlyToned(tone).shoot())])),
  };
}

function measureEdges(camera: SurfaceCamera, edges: Uint32Array): EdgeJump {
  const half = (first: number) => edges.filter((_, i) => i % 4 === first || i % 4 === first + 1);
  camera.view(WHOLE.zoom).lit();
  return edgeJump(camera.shootEdges(half(0)), camera.shootEdges(half(2)));
}

function measureKink(geometry: BufferGeometry, edges: Uint32Array, material: HatchingMaterial): StrokeKink {
  const smooth = geometry.getAttribute('hatchNormal');
  // These strokes alone take their direction from interpolated normals; engraved lines are cut out of the triangles.
  const normals =
    material.technique === 'hatching'
      ? Float32Array.from({ length: 3 * smooth.count }, (_, i) => smooth.getComponent(Math.floor(i / 3), i % 3))
      : undefined;
  const axis: Vector = counts(material, 'direction') && material.direction === 'x' ? [1, 0, 0] : TO_LIGHT.toArray();
  return strokeKink(geometry.getAttribute('position').array, edges, axis, normals);
}

function measureMiddle(camera: SurfaceCamera, material: HatchingMaterial) {
  material.tilesPerObjectUnit = MIDDLE.tilesPerObjectUnit;
  const even = camera.view(MIDDLE.zoom).evenlyToned(EVEN_TONE).shoot();
  return {
    coherence: strokeCoherence(even),
    spacing: strokeSpacing(even),
    ...(needsMap(material) && { strokeLength: lengthBySpacing(camera) / drawnLength! }),
  };
}

/** Measures on a wall that a single frame covers, where strokes are those of the map. */
async function measureDrawnLength(tonalArtMap: TonalArtMap): Promise<number> {
  const wall = await prepareHatchingGeometry(new PlaneGeometry(3, 3), { adjacency: true });
  const material = new HatchingMaterial({
    tonalArtMap,
    technique: 'triangle',
    perTriangle: { sharpInk: true, levelRule: 'depth' },
    edgePixels: 0,
    tilesPerObjectUnit: MIDDLE.tilesPerObjectUnit,
  });
  const camera = new SurfaceCamera(renderer, SIZE, wall, material);
  const length = lengthBySpacing(camera.view(MIDDLE.zoom));
  for (const thing of [camera, material, wall]) thing.dispose();
  return length;
}

/** Lengths in spacings rather than pixels: parts of a model are nearer than the wall or lean away. */
function lengthBySpacing(camera: SurfaceCamera): number {
  const light = camera.evenlyToned(LIGHT_TONE).shoot();
  return strokeLength(light) / strokeSpacing(light);
}

/** Flips per turn of the light depend on the stroke spacing, which is therefore made equal first. */
function measureLight(camera: SurfaceCamera, material: HatchingMaterial, wantedSpacing: number) {
  material.tilesPerObjectUnit = MIDDLE.tilesPerObjectUnit;
  camera.view(MIDDLE.zoom);
  // In several steps: a coarser scale may choose another level of the map.
  for (let step = 0; step < 4; step++) {
    const tooWide = strokeSpacing(camera.evenlyToned(EVEN_TONE).shoot()) / wantedSpacing;
    if (counts(material, 'lineSpacing')) material.lineSpacing /= tooWide;
    else material.tilesPerObjectUnit *= tooWide;
  }
  const before = camera.evenlyToned(EVEN_TONE).shoot();
  const flips = LIGHT_TURNS.map((degrees) => ({
    degrees,
    share: normalisedFlips(before, camera.evenlyToned(EVEN_TONE, degrees).shoot()),
  }));
  return { tilesPerObjectUnit: material.tilesPerObjectUnit, spacing: strokeSpacing(before), flips };
}

function measureDolly(camera: SurfaceCamera, material: HatchingMaterial) {
  const target = sizeOnScreen(camera, material);
  const changes: FrameChange[] = [];
  let before = camera.dolly(target, 1).shootLocated();
  for (let frame = 1; frame <= DOLLY_FRAMES; frame++) {
    const after = camera.dolly(target, 2 ** ((OCTAVES * frame) / DOLLY_FRAMES)).shootLocated();
    changes.push(reprojectedChange(before, after));
    before = after;
  }
  const flips = changes.map((change) => change.flips);
  const luminance = changes.map((change) => change.luminance);
  return { flips, popping: poppingIndex(flips), luminance, luminancePopping: poppingIndex(luminance) };
}

function measureZoom(camera: SurfaceCamera, material: HatchingMaterial) {
  const target = sizeOnScreen(camera, material);
  const spacings = Array.from({ length: ZOOM_STEPS + 1 }, (_, step) =>
    strokeSpacing(facingCamera(camera.dolly(target, 2 ** ((OCTAVES * step) / ZOOM_STEPS)).shootLocated())),
  );
  const wholeOctaves = spacings.filter((_, step) => (OCTAVES * step) % ZOOM_STEPS === 0);
  return { spacings, spread: halfSpread(spacings), octaveSpread: halfSpread(wholeOctaves) };
}

/** Sizes strokes on the screen. Returns the point of the model to move towards: the middle of the standard view. */
function sizeOnScreen(camera: SurfaceCamera, material: HatchingMaterial): Vector3 {
  material.tilesPerObjectUnit = MIDDLE.tilesPerObjectUnit;
  material.screenSpaceShare = 1;
  return middleOf(camera.evenlyToned(EVEN_TONE).view().shootLocated());
}

/** Keeps only surface that faces the camera. */
function facingCamera(image: LocatedImage): SurfaceImage {
  return { ...image, surface: image.surface.map((s, i) => (image.places[4 * i + 3] > LEAST_FACING ? s : 0)) };
}

/** The point of the model that faces the camera and is shown nearest to the middle of the picture. */
function middleOf({ width, height, surface, places }: LocatedImage): Vector3 {
  let [best, nearest] = [-1, Number.POSITIVE_INFINITY];
  for (let i = 0; i < surface.length; i++) {
    if (surface[i] === 0 || places[4 * i + 3] < LEAST_FACING) continue;
    const distance = Math.hypot((i % width) - width / 2, Math.floor(i / width) - height / 2);
    if (distance < nearest) [best, nearest] = [i, distance];
  }
  return new Vector3().fromArray(places, 4 * best);
}
