import { mat4 } from 'gl-matrix';
import { STIPPLE_CONSTANTS } from '../../src/look/constants/patternConstants.js';
import { dot, normalize, timesVector, type Vec3 } from '../../src/look/vectors.js';
import { STIPPLE_MAP_SIZE } from '../../src/material/tam/patternSizes.js';
import { stippleMap } from '../../src/material/tam/stippleMap.js';
import { Projection } from '../../src/vector/Projection.js';
import { type Mat3, screenGradient, screenMap } from '../../src/vector/shading/screenGradient.js';
import {
  coverOf,
  directionOfNeedles,
  dotArea,
  dotOctave,
  grownBy,
  ownCover,
  planesNear,
  roundScreenMap,
  setShift,
} from '../../src/vector/shading/stipple.js';
import type { HatchingReference } from '../reference/hatchingReference.js';
import type { HatchingSpec } from './hatchingSpec.js';
import type { DarknessOf } from './referenceCase.js';

const texels = stippleMap().image.data as Uint8Array;
const wrap = (cell: number) => ((cell % STIPPLE_MAP_SIZE) + STIPPLE_MAP_SIZE) % STIPPLE_MAP_SIZE;

/** The input of the darkness of dots. */
export type StippleScene = Pick<HatchingSpec, 'matrixWorld' | 'camera' | 'width' | 'height'> & {
  material: Pick<HatchingSpec['material'], 'tilesPerObjectUnit'>;
  dots: NonNullable<HatchingSpec['dots']>;
  screenSpaceShare: number;
};

/** The ink of a disc with a soft edge, by the distance from its middle, as in dots.glsl. Smaller discs are paler. */
function discInk(away: number, area: number, edge: number): number {
  const squared = area / Math.PI;
  const radius = Math.sqrt(Math.max(squared - edge ** 2 / 12, edge ** 2 / 4));
  return Math.min(Math.max((radius - away) / edge + 0.5, 0), 1) * Math.min((3 * squared) / edge ** 2, 1);
}

/** The darkness of dots, by the functions that draw them in vector files. Light and tone are those of the reference. */
export function stippleDarkness(scene: StippleScene, reference: HatchingReference): DarknessOf {
  const { matrixWorld, camera, material, dots, screenSpaceShare } = scene;
  const size = { dotPixels: dots.strokeWidth, tilesPerObjectUnit: material.tilesPerObjectUnit, screenSpaceShare };
  const edge = Math.max(dots.edgePixels, 0.01);
  const world = mat4.invert(mat4.create(), camera.view as unknown as mat4)!;
  const projection = new Projection({ ...camera, world, near: 0 }, scene.width, scene.height);
  const { isOrthographic } = projection;
  const back = mat4.multiply(mat4.create(), mat4.invert(mat4.create(), matrixWorld as unknown as mat4)!, world);
  const row = (i: number): Vec3 => [back[i], back[4 + i], back[8 + i]];
  const viewToObject: Mat3 = [row(0), row(1), row(2)];
  return (place, normal, toneNormal) => {
    const inWorld = reference.toWorld(place);
    const cover = coverOf(reference.tone(inWorld, [...normalize(toneNormal)]));
    if (cover >= 1) return 1;
    const view = projection.toView(inWorld);
    const front = normalize(normal);
    const toViewer = normalize(timesVector(viewToObject, isOrthographic ? [0, 0, 1] : [-view[0], -view[1], -view[2]]));
    const unitsPerPixel = projection.unitsPerPixel(-view[2]);
    const map = roundScreenMap(screenMap(front, viewToObject, { view, isOrthographic, unitsPerPixel }), unitsPerPixel);
    let blank = Math.min((1 - cover) / (1 - STIPPLE_CONSTANTS.FILLING), 1);
    for (const { axis, u, v, share } of planesNear(directionOfNeedles(front, toViewer))) {
      const [gu, gv] = [screenGradient(u, map), screenGradient(v, map)];
      const area = gu[0] * gv[1] - gu[1] * gv[0];
      const own = ownCover(cover, share);
      const octave = dotOctave(Math.abs(area), own, size);
      const cells = 2 ** (Math.floor(octave) + 1);
      const full = dotArea(Math.abs(area), own, octave);
      const shift = setShift(axis, size.tilesPerObjectUnit);
      const at = [cells * (dot(place, u) + shift[0]), cells * (dot(place, v) + shift[1])];
      let ink = 0;
      for (let y = Math.floor(at[1]) - 3; y <= at[1] + 3; y++) {
        for (let x = Math.floor(at[0]) - 3; x <= at[0] + 3; x++) {
          const texel = 4 * (wrap(y) * STIPPLE_MAP_SIZE + wrap(x));
          const du = (x + texels[texel] / 255 - at[0]) / cells;
          const dv = (y + texels[texel + 1] / 255 - at[1]) / cells;
          const away = Math.hypot((du * gv[1] - dv * gu[1]) / area, (dv * gu[0] - du * gv[0]) / area);
          ink += discInk(away, full * grownBy(octave - Math.floor(octave), texels[texel + 2] / 255), edge);
        }
      }
      blank *= 1 - Math.min(ink, 1);
    }
    return 1 - blank;
  };
}
