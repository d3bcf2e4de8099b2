/** Counterpart of shaders/techniques/anchored/dots.glsl: the dots of one plane, a disc on the screen for each point of the set. */
import { STIPPLE_CONSTANTS } from '../../../look/constants/stippleConstants.js';
import { STIPPLE_MAP_SIZE } from '../../../material/tam/patternSizes.js';
import { blankDots } from '../base/blankTextures.js';
import { hatchingTexture } from '../base/textures.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { abs, clamp, exp2, float, floor, fract, If, int, inverseSqrt, ivec2, length, Loop, max, min, mix } = tsl;
const { sqrt, step, vec2 } = tsl;
const { DOT_GROWTH, LEAST_BLANK, OVERLAP, OVERLAP_WITHIN } = STIPPLE_CONSTANTS;

/** One texel per cell: the position of its point and, in blue, the part of an octave at which it appears. */
const stippleMap = /* @__PURE__ */ hatchingTexture('stippleMap', blankDots);
/** Width of the edge of a dot. */
const edgePixels = /* @__PURE__ */ hatchingUniform('edgePixels', 'float');

/** The greatest distance, in cells, from which a dot reaches a place, and the most cells of a row within that distance. */
const MOST_REACH = 1.5;
const MOST_CELLS = 4;
/** A disc of radius r whose edge fades over a width of 1 covers π (r² + 1/12). */
const EDGE_COVER = 1 / 12;
/** A smaller disc would be all edge: it is drawn with this squared radius, and paler. */
const LEAST_SQUARED_RADIUS = 0.25;
const FADING = 3;

/** How coordinates of a plane change on the screen. */
export interface PlaneOnScreen {
  /** Per pixel. */
  gradientU: Value;
  gradientV: Value;
  /** Object units² per pixel; its sign is the orientation. */
  area: Value;
}

export const planeOnScreen = (gradientU: Value, gradientV: Value): PlaneOnScreen => ({
  gradientU,
  gradientV,
  area: gradientU.x.mul(gradientV.y).sub(gradientU.y.mul(gradientV.x)).toVar(),
});

/** The mean area, as a share of the full one, of the dots that appear during an octave. */
function grownShare(octave: Value): Value {
  const t = max(vec2(octave, octave.add(DOT_GROWTH - 1)), 0).toVar();
  const growing = t.mul(t).mul(0.5 / DOT_GROWTH);
  const covered = mix(growing, t.sub(0.5 * DOT_GROWTH), step(DOT_GROWTH, t)).toVar();
  return covered.x.sub(covered.y).div(1 - DOT_GROWTH);
}

/** The area of a dot during an octave, as a share of its full area. @param born 0 for dots of the octave before */
const grownBy = (octave: Value, born: Value): Value =>
  clamp(octave.sub(born.mul(1 - DOT_GROWTH)).div(DOT_GROWTH), step(born, 0), 1);

/** The total area of discs that together cover a share of the plane, as a share of the plane. From 0.5 on they overlap. */
function discArea(covered: Value, octave: Value): Value {
  const beyond = max(covered.sub(0.5), 0).toVar();
  const rest = float(1).sub(octave).toVar();
  const overlap = octave.mul(OVERLAP_WITHIN).mul(rest).mul(rest).add(OVERLAP);
  return covered.add(
    overlap
      .mul(beyond)
      .mul(beyond)
      .mul(inverseSqrt(max(float(1).sub(covered), LEAST_BLANK))),
  );
}

/** The radius of a disc whose soft edge does not enlarge it, in widths of the edge. */
const softRadius = (squared: Value): Value => sqrt(max(squared.sub(EDGE_COVER), LEAST_SQUARED_RADIUS));

/** The share of a pixel that a dot covers. @param away distance to its centre, in widths of the edge; the root of `squared` */
const dotCover = (away: Value, squared: Value): Value =>
  clamp(softRadius(squared).sub(away).add(0.5), 0, 1).mul(min(squared.mul(FADING), 1));

/**
 * The share of the fragment that the dots of a plane cover.
 *
 * @param octave of the cells per object unit
 * @param share the share that all of its dots cover
 */
export function dotsAt(at: Value, { gradientU, gradientV, area }: PlaneOnScreen, octave: Value, share: Value): Value {
  const cells = exp2(floor(octave).add(1)).toVar();
  const into = fract(octave).toVar();
  // A quarter of the cells had their dots before this octave.
  const dotsPerCell = grownShare(into).mul(0.75).add(0.25);
  // In widths of the edge: the squared radius of a full-grown dot, and the Jacobian from cells to the screen.
  const edge = max(edgePixels, 1e-2).toVar();
  const perCell = max(abs(area), 1e-20).mul(cells).mul(cells).mul(dotsPerCell).mul(edge).mul(edge);
  const squared = discArea(share, into)
    .mul(1 / Math.PI)
    .div(perCell)
    .toVar();
  const scale = area.mul(cells).mul(edge).toVar();
  const columnU = vec2(gradientV.y, gradientV.x.negate()).div(scale).toVar();
  const columnV = vec2(gradientU.y.negate(), gradientU.x).div(scale).toVar();
  const place = at.mul(cells).toVar();
  // Rows of cells whose dots may reach this place.
  const largest = softRadius(squared).add(0.5);
  const reach = min(largest.mul(edge).mul(cells).mul(length(gradientV)), MOST_REACH).toVar();
  const left = floor(place.x.sub(MOST_REACH)).toVar();
  const lowest = floor(place.y.sub(reach)).toVar();
  const highest = floor(place.y.add(reach)).toVar();
  const covered = float(0).toVar();
  const range = { start: int(0), end: int(MOST_CELLS), type: 'int', condition: '<' };
  // A bounded loop, so that broken meshes cannot stall the GPU.
  Loop(range, ({ i: row }) => {
    const y = lowest.add(float(row)).toVar();
    If(y.lessThanEqual(highest), () => {
      Loop({ ...range, name: 'column' }, ({ column }) => {
        const cell = vec2(left.add(float(column)), y).toVar();
        const texel = stippleMap.load(ivec2(cell).bitAnd(ivec2(STIPPLE_MAP_SIZE - 1))).toVar();
        const way = cell.add(texel.xy).sub(place).toVar();
        const away = columnU.mul(way.x).add(columnV.mul(way.y));
        // Two dots that meet in a pixel each cover a part of it.
        covered.addAssign(dotCover(length(away), squared.mul(grownBy(into, texel.z)).toVar()));
      });
    });
  });
  return min(covered, 1);
}
