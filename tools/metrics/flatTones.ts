/** Measures the looks whose texture makes the tone, on a wall in even tones. */
import { PlaneGeometry, type WebGLRenderer } from 'three';
import { HatchingMaterial, type PresetName, prepareHatchingGeometry, presets, TonalArtMap } from 'three-hatching';
import { countPieces, type PieceCounts } from './measures/countPieces.js';
import { meanInk } from './measures/meanInk.js';
import { strokeCoherence } from './measures/strokeCoherence.js';
import { toneSpectrum } from './measures/toneSpectrum.js';
import { SurfaceCamera } from './SurfaceCamera.js';

/** The presets that are measured. */
const LOOKS = ['stipple', 'pencil', 'charcoal', 'chalk'] as const satisfies readonly PresetName[];
const TONES = [0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
/** A power of two, as the spectrum asks. */
const SIZE = 256;

/** A look in one even tone. */
export interface FlatTone {
  tone: number;
  ink: number;
  pieces: PieceCounts;
  /** Deviations of the tone by bands of wavelength. */
  bands: number[];
  coherence: number;
}

/** The tones of each look, by its name. */
export type FlatTones = Record<string, FlatTone[]>;

/** Draws each look on a wall, with its own map and sizes, in black on white and with the tone as the light has it. */
export async function measureFlatTones(renderer: WebGLRenderer): Promise<FlatTones> {
  const found: FlatTones = {};
  for (const look of LOOKS) {
    const { material: parameters, tonalArtMap: drawing } = presets[look];
    const map = drawing && (await TonalArtMap.generate(drawing));
    const wall = await prepareHatchingGeometry(new PlaneGeometry(6, 6), { form: true });
    const material = new HatchingMaterial({
      ...parameters,
      tonalArtMap: map,
      toneCurve: 'linear',
      reflectedLight: 0,
      composition: { exposure: 1 },
      ink: 'black',
      paper: 'white',
    });
    const camera = new SurfaceCamera(renderer, SIZE, wall, material);
    found[look] = TONES.map((tone) => {
      const image = camera.evenlyToned(tone).shoot();
      return {
        tone,
        ink: meanInk(image),
        pieces: countPieces(image),
        bands: toneSpectrum(image),
        coherence: strokeCoherence(image),
      };
    });
    for (const thing of [camera, material, wall, map]) thing?.dispose();
  }
  return found;
}
