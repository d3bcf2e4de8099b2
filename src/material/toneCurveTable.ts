import { DataTexture, DataUtils, HalfFloatType, type IUniform, LinearFilter, RedFormat } from 'three';
import { type FittedToneCurve, fittedCurve, type ToneCurve } from './fitToneCurve.js';

/** The number of light tones, evenly from 0 to 1, that a table has printed tones for. */
export const TONE_CURVE_TEXELS = 1024;

/** A table of zeros. */
export const blankTable = (): DataTexture => {
  const table = new DataTexture(new Uint16Array(TONE_CURVE_TEXELS), TONE_CURVE_TEXELS, 1, RedFormat, HalfFloatType);
  table.magFilter = table.minFilter = LinearFilter;
  return table;
};

/** The tone that a fitted curve prints for a tone of the light. */
function curvedTone({ start, spans, cubics }: FittedToneCurve, tone: number): number {
  let curved = start;
  for (let i = 0; 2 * i < spans.length; i++) {
    const t = Math.min(Math.max((tone - spans[2 * i]) * spans[2 * i + 1], 0), 1);
    curved += t * (cubics[3 * i] + t * (cubics[3 * i + 1] + t * cubics[3 * i + 2]));
  }
  return curved;
}

function fill(table: DataTexture, fitted: FittedToneCurve): DataTexture {
  const texels = table.image.data as Uint16Array;
  for (let i = 0; i < TONE_CURVE_TEXELS; i++)
    texels[i] = DataUtils.toHalfFloat(curvedTone(fitted, i / (TONE_CURVE_TEXELS - 1)));
  table.needsUpdate = true;
  return table;
}

/** The texels of `'printed'`, the curve of most looks. Tables share them, and three.js uploads them once for each renderer. */
let printed: DataTexture['source'] | undefined;

/** Writes the table of a tone curve through points; a curve that the shader computes changes nothing. */
export function writeCurveUniforms(curve: ToneCurve, { toneCurveTable: u }: Record<string, IUniform>): void {
  const fitted = fittedCurve(curve);
  if (!fitted) return;
  const wasPrinted = u.value !== null && u.value.source === printed;
  if (curve !== 'printed') {
    if (wasPrinted) u.value.dispose();
    u.value = fill(wasPrinted ? blankTable() : (u.value ?? blankTable()), fitted);
  } else if (!wasPrinted) {
    u.value?.dispose();
    printed ??= fill(blankTable(), fitted).source;
    u.value = blankTable();
    u.value.source = printed;
    u.value.version = 1;
  }
}
