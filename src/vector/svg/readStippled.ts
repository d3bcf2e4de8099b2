import type { Matrix4 } from 'three';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { STIPPLE_MAP_SIZE } from '../../material/tam/patternSizes.js';
import { stippleMap } from '../../material/tam/stippleMap.js';
import type { StippledSurface } from '../DrawnScene.js';
import type { DetailSource } from './readDetails.js';
import { readSurface } from './readSurface.js';
import { objectFrame } from './surfaceFrame.js';
import type { TriangleRange } from './TriangleRange.js';

/** Reads the part of a mesh that a material draws in dots. seen: bits of the visible sides. Yields its progress. */
export function* readStippled(
  source: DetailSource,
  material: HatchingMaterial,
  range: TriangleRange,
  worldToView: Matrix4,
  seen: number,
): Generator<number, Pick<StippledSurface, 'surface' | 'size' | 'set' | 'layers'>, void> {
  const { tilesPerUnit, strokeWidth, sizedOnScreen, strokeLayers, anchorSpacing, crossFrom } = material;
  const frame = objectFrame(source.mesh, source.copy.toWorld, worldToView);
  const surface = yield* readSurface(source, range, frame, seen);
  return {
    surface,
    // If no stroke width is known, dots are one pixel wide, as the material draws them.
    size: { dotPixels: strokeWidth ?? 1, tilesPerUnit, sizedOnScreen },
    layers: { shift: anchorSpacing / tilesPerUnit, crossFrom: strokeLayers === 'tone' ? crossFrom : null },
    set: { cells: STIPPLE_MAP_SIZE, texels: (stippleMap().image.data as Uint8Array).slice() },
  };
}
