/** Measures how long the strokes of looks are in print, on an even light tone. */
import type { WebGLRenderer } from 'three';
import {
  HatchingMaterial,
  type PresetName,
  prepareHatchingGeometry,
  presets,
  scalePreset,
  TonalArtMap,
} from 'three-hatching';
import { loadModel } from './loadModel.js';
import { type Piece, pieceLengths } from './measures/pieceLengths.js';
import { SurfaceCamera } from './SurfaceCamera.js';

const LOOKS = ['pen', 'crossHatching'] as const satisfies readonly PresetName[];
const MODELS = ['sphere', 'bunny'] as const;
const TONE = 0.25;
/** The model fills the width of a sheet of A5. */
const SHEET_MILLIMETRES = 148;
const DPI = 300;
/** A stroke that is shorter is a crumb. */
const CRUMB_MILLIMETRES = 3;

/** The strokes of a look on a model. */
export interface PrintedStrokes {
  look: PresetName;
  model: string;
  strokes: number;
  /** The length of the middle stroke, and of the one that the middle of the ink belongs to, in millimetres. */
  median: number;
  medianByInk: number;
  /** The share of strokes that are crumbs, and of the ink that lies in them. */
  crumbs: number;
  crumbsByInk: number;
}

/** Draws each look on each model in print, without its tone curve. */
export async function measurePrintedStrokes(renderer: WebGLRenderer): Promise<PrintedStrokes[]> {
  const found: PrintedStrokes[] = [];
  const size = Math.round((SHEET_MILLIMETRES * DPI) / 25.4);
  for (const look of LOOKS) {
    const { material: parameters, tonalArtMap: drawing } = scalePreset(presets[look], DPI / 96);
    const map = drawing && (await TonalArtMap.generate(drawing));
    const material = new HatchingMaterial({
      ...parameters,
      tonalArtMap: map,
      composition: { exposure: 1 },
      toneCurve: 'linear',
      reflectedLight: 0,
      ink: 'black',
      paper: 'white',
    });
    for (const model of MODELS) {
      const geometry = await prepareHatchingGeometry(await loadModel(model), {
        form: { crossAngle: material.crossAngle },
      });
      const camera = new SurfaceCamera(renderer, size, geometry, material);
      const pieces = pieceLengths(camera.evenlyToned(TONE).shoot())
        .map(({ length, area }) => ({ length: (length * 25.4) / DPI, area }))
        .sort((one, other) => one.length - other.length);
      const crumbs = pieces.filter(({ length }) => length < CRUMB_MILLIMETRES);
      found.push({
        look,
        model,
        strokes: pieces.length,
        median: pieces[pieces.length >> 1].length,
        medianByInk: middleByInk(pieces),
        crumbs: crumbs.length / pieces.length,
        crumbsByInk: inkOf(crumbs) / inkOf(pieces),
      });
      for (const thing of [camera, geometry]) thing.dispose();
    }
    for (const thing of [material, map]) thing?.dispose();
  }
  return found;
}

const inkOf = (pieces: readonly Piece[]): number => pieces.reduce((sum, { area }) => sum + area, 0);

/** @param pieces by length */
function middleByInk(pieces: readonly Piece[]): number {
  let left = inkOf(pieces) / 2;
  for (const { length, area } of pieces) {
    left -= area;
    if (left <= 0) return length;
  }
  return Number.NaN;
}
