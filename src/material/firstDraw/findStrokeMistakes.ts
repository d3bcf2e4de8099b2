import type { Object3D, Sphere } from 'three';
import { counts } from '../../look/measuredFacts.js';
import type { TonalArtMap } from '../tam/TonalArtMap.js';
import type { FirstDraw, NoteMistake } from './FirstDraw.js';
import { rounded } from './sentences.js';
import { worldSphere } from './worldSphere.js';

/**
 * Stroke widths in pixels of the drawing buffer, below and above which a mistake is likely. Strokes that are a little thinner than a
 * pixel, or very wide, are a matter of taste.
 */
const TOO_THIN = 0.5;
const WIDE = 32;
/** Lengths of strokes, as shares of a tile. */
const LONGEST_STROKE = 0.5;
/** The unit of `lineSpacing` on the object, as a share of a tile. */
const SPACING_UNIT = 1 / 256;
/** Values that suit every model: tiles per radius, and widths of strokes and distances of lines in pixels. */
const SUITABLE = { tilesPerRadius: 3, strokeWidth: 1.5, lineSpacing: 5 };

/** Finds strokes that are too small or too large to be seen as strokes, from the meshes of a scene that are drawn first. */
export function findStrokeMistakes(draws: readonly FirstDraw[], note: NoteMistake): void {
  // All hatched meshes of the scene count as one model. It is measured once, and only if strokes are sized on it.
  let model: Sphere | undefined;
  for (const draw of draws) {
    const { material, scene } = draw;
    const onScreen = counts(material, 'sizedOnScreen') ? material.sizedOnScreen : 0;
    if (onScreen === 0) {
      model ??= hatchedMeshes(scene);
      checkOnObject(draw, model, note);
    } else if (onScreen === 1) checkOnScreen(draw, note);
  }
}

function checkOnObject(draw: FirstDraw, model: Sphere, note: NoteMistake): void {
  const { material, mesh } = draw;
  const tilesPerUnit = material.tilesPerUnit as number;
  const scale = mesh.matrixWorld.getMaxScaleOnAxis();
  const tile = scale / tilesPerUnit;
  const forModel = (SUITABLE.tilesPerRadius / model.radius) * scale;
  const say = (mistake: 'tooFine' | 'tooCoarse', suitable: number): void =>
    note(mistake, draw, material, 'tilesPerUnit', rounded(tilesPerUnit), rounded(suitable));
  const length = counts(material, 'lineSpacing') ? (material.lineSpacing as number) * SPACING_UNIT : LONGEST_STROKE;
  // Strokes as long as the model are plausible; those of twice its diameter are a mistake.
  if (tile * length > 4 * model.radius) say('tooCoarse', forModel);
  const map = material.tonalArtMap as TonalArtMap | string | null;
  if (!map || typeof map === 'string' || !counts(material, 'tonalArtMap')) return;
  // Levels of the map keep the drawn width of strokes, down to the coarsest level.
  const coarsest = map.size >> (map.levels - 1);
  const width = (tile * pixelsPerUnit(draw) * map.strokeTexels) / coarsest;
  // A distant model needs larger strokes than one that fills the picture.
  if (width < TOO_THIN) say('tooFine', Math.min(forModel, (tilesPerUnit * width) / SUITABLE.strokeWidth));
}

function checkOnScreen(draw: FirstDraw, note: NoteMistake): void {
  const { material, mesh, renderer } = draw;
  const property = counts(material, 'lineSpacing') ? 'lineSpacing' : 'strokeWidth';
  const size = material[property] as number | null;
  if (size === null) return;
  const say = (mistake: 'tooFine' | 'tooCoarse'): void =>
    note(mistake, draw, material, property, rounded(size), String(SUITABLE[property]));
  const pixels = size * renderer.getPixelRatio();
  if (pixels < TOO_THIN) say('tooFine');
  else if (pixels > WIDE && pixels > 2 * worldSphere([mesh]).radius * pixelsPerUnit(draw)) say('tooCoarse');
}

/** The number of pixels per world unit at the point of the mesh that is nearest to the camera. */
function pixelsPerUnit({ mesh, camera, height }: FirstDraw): number {
  const { elements } = camera.projectionMatrix;
  const pixels = (Math.abs(elements[5]) * height) / 2;
  if (elements[11] === 0) return pixels;
  const { center, radius } = worldSphere([mesh]);
  const depth = -center.clone().applyMatrix4(camera.matrixWorldInverse).z - radius;
  return depth > 0 ? pixels / depth : Infinity;
}

/** A sphere around all hatched meshes of a scene: one stroke size serves the whole model, not each of its parts. */
function hatchedMeshes(scene: Object3D): Sphere {
  const meshes: Object3D[] = [];
  scene.traverseVisible((object) => {
    const { material } = object as { material?: object };
    if ([material].flat().some((one) => one && 'isHatchingMaterial' in one)) meshes.push(object);
  });
  return worldSphere(meshes);
}
