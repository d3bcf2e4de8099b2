import type { Bvh } from './Bvh.js';
import type { DrawnBackground } from './DrawnScene.js';
import type { Projection } from './Projection.js';
import { type LinePath, PATH_STRIDE } from './paths/LinePath.js';
import { type BackgroundField, lineAt, lineWidth, placeOnLine } from './shading/background.js';

/** Distance between samples of a line, and the number of bisection steps to find its ends. Pixels. */
const STEP = 2;
const HALVINGS = 8;
/** A pen draws a line where it is at least this share of its width. */
const LEAST_IN_PENS = 0.5;
/** Thinner lines are omitted, pixels. */
const LEAST_WIDTH = 0.02;

/**
 * The visible lines of the field behind a subject. Yields its progress.
 *
 * @param pen its width, pixels; null where widths are the tone
 */
export function* backgroundPaths(
  background: DrawnBackground,
  projection: Projection,
  bvh: Bvh,
  pen: number | null,
): Generator<number, LinePath[], void> {
  const ruler = new Ruler(background, projection, bvh, pen);
  const paths: LinePath[] = [];
  const [first, last] = ruler.lines();
  for (let line = first; line <= last; line++) {
    yield (line - first) / (last - first + 1);
    for (const path of ruler.rule(line)) paths.push(path);
  }
  return paths;
}

/** A place on a line: pixels of the picture, and half the width there. */
interface RuledPlace {
  along: number;
  x: number;
  y: number;
  half: number;
  isSeen: boolean;
}

class Ruler {
  private readonly field: BackgroundField;
  private readonly offset: readonly [number, number];
  private readonly reach: number;

  constructor(
    { tone, contrast, spacing, angle, extent, seen, lit, sheet }: DrawnBackground,
    private readonly projection: Projection,
    private readonly bvh: Bvh,
    private readonly pen: number | null,
  ) {
    const { width, height } = projection;
    const size = [sheet[2] * width, sheet[3] * height] as const;
    this.offset = [sheet[0] * width, sheet[1] * height];
    this.field = {
      ...{ tone, contrast, spacing, extent, lit, sheet: size },
      direction: [Math.cos(angle), Math.sin(angle)],
      centre: [(0.25 * (seen.left + seen.right) + 0.5) * size[0], (0.25 * (seen.bottom + seen.top) + 0.5) * size[1]],
      half: [0.25 * (seen.right - seen.left) * size[0], 0.25 * (seen.top - seen.bottom) * size[1]],
    };
    // No line lies outside the sheet, or beyond the field and its ragged ends.
    const field = 1.3 * extent * Math.max(...this.field.half);
    this.reach = Math.min(field, Math.hypot(...size));
  }

  /** The first and the last line, by number. */
  lines(): readonly [number, number] {
    const { centre, direction } = this.field;
    const at = (away: number) => lineAt(this.field, [centre[0] - away * direction[1], centre[1] + away * direction[0]]);
    return [at(-this.reach), at(this.reach)];
  }

  /** The visible parts of a line. */
  *rule(line: number): Generator<LinePath, void, void> {
    let points: number[] = [];
    let before: RuledPlace | undefined;
    for (let along = -this.reach; along <= this.reach; along += STEP) {
      const place = this.placeAt(line, along);
      if (before && before.isSeen !== place.isSeen) {
        const border = this.borderBetween(line, before, place);
        points.push(border.x, border.y, border.half, border.half);
        if (before.isSeen) {
          yield { points, isClosed: false };
          points = [];
        }
      }
      if (place.isSeen) points.push(place.x, place.y, place.half, place.half);
      before = place;
    }
    if (points.length > PATH_STRIDE) yield { points, isClosed: false };
  }

  private placeAt(line: number, along: number): RuledPlace {
    const { field, offset, projection, pen, bvh } = this;
    const place = placeOnLine(field, line, along);
    const width = lineWidth(field, line, place);
    const [x, y] = [place[0] + offset[0], projection.height - place[1] - offset[1]];
    let isSeen = width > (pen === null ? LEAST_WIDTH : LEAST_IN_PENS * pen) && projection.contains(x, y);
    if (isSeen) {
      const { origin, direction } = projection.rayThrough(x, y);
      isSeen = bvh.firstMet(origin, direction, projection.camera.near) === Infinity;
    }
    return { along, x, y, half: 0.5 * (pen ?? width), isSeen };
  }

  /** The last visible place between two. */
  private borderBetween(line: number, one: RuledPlace, other: RuledPlace): RuledPlace {
    let [seen, hidden] = one.isSeen ? [one, other] : [other, one];
    for (let i = 0; i < HALVINGS; i++) {
      const middle = this.placeAt(line, 0.5 * (seen.along + hidden.along));
      if (middle.isSeen) seen = middle;
      else hidden = middle;
    }
    return seen;
  }
}
