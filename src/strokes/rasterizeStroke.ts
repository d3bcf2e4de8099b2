import type { PaperGrain } from './paperGrain.js';
import { profileSlope, profileWidth, type Stroke, strokeOffset } from './Stroke.js';

/** The width of the tip of a tapered stroke, in texels. A thinner tip would break into grey dots. */
const TIP_WIDTH = 1;

/**
 * Draws one stroke into a square toroidal image: a stroke that leaves it on one side continues on the other.
 *
 * The darkness of a texel is the share of it that the stroke covers, estimated from the distance between the texel's centre and
 * the centre line (exact for a line along an axis). Where strokes overlap, the darker value stays, so the order of drawing does
 * not matter, and an image can only become darker.
 *
 * @param image size² bytes in rows of growing v, 255 = paper, 0 = ink; changed in place
 * @param size texels per side, a power of two
 * @param grain the grain of the paper, which gives the stroke a soft edge and keeps ink on the peaks
 * @returns the amount by which the sum of the bytes has decreased
 */
export function rasterizeStroke(image: Uint8Array, size: number, stroke: Stroke, grain?: PaperGrain): number {
  const mask = size - 1;
  // "Forward" is the axis the stroke runs along, "sideways" the other one.
  const forwardStride = stroke.across ? size : 1;
  const sidewaysStride = stroke.across ? 1 : size;
  const centre = (stroke.across ? stroke.v : stroke.u) * size;
  const base = (stroke.across ? stroke.u : stroke.v) * size;
  const halfLength = 0.5 * stroke.length * size;
  const halfWidth = 0.5 * stroke.width;
  const tip = Math.min(halfWidth, 0.5 * TIP_WIDTH);
  // At least half of the stroke keeps its full width; otherwise strokes would look thinner on coarse levels.
  const taper = Math.min(stroke.taper, 0.5 * halfLength);
  const { profile } = stroke;
  let cosine = 1 / Math.sqrt(1 + stroke.slope * stroke.slope);

  const cap = profile
    ? 0.5 * Math.max(profileWidth(profile, stroke.width, -1), profileWidth(profile, stroke.width, 1))
    : halfWidth;
  const first = Math.ceil(centre - halfLength - cap - 1);
  const last = Math.floor(centre + halfLength + cap);
  let darkened = 0;
  for (let column = first; column <= last; column++) {
    const forward = column + 0.5 - centre;
    const along = Math.min(halfLength, Math.max(-halfLength, forward));
    const beyond = forward - along;
    const middle = base + size * strokeOffset(stroke, halfLength > 0 ? along / halfLength : 0);
    let radius: number;
    if (profile) {
      const x = along / halfLength;
      const slope = profileSlope(stroke, profile, x);
      radius = 0.5 * profileWidth(profile, stroke.width, x);
      cosine = 1 / Math.sqrt(1 + slope * slope);
    } else {
      const fromEnd = halfLength - Math.abs(along);
      const rest = fromEnd < taper ? 1 - fromEnd / taper : 0;
      radius = halfWidth - (halfWidth - tip) * rest * rest;
    }
    // A soft edge wider than the line would make its middle grey.
    const edge = grain ? Math.min(grain.edge, 2 * radius) : 1;
    const reach = (radius + 0.5 * edge) / cosine;
    const lastRow = Math.floor(middle + reach - 0.5);
    const columnStart = (column & mask) * forwardStride;
    for (let row = Math.ceil(middle - reach - 0.5); row <= lastRow; row++) {
      const sideways = (row + 0.5 - middle) * cosine;
      const distance = beyond === 0 ? Math.abs(sideways) : Math.sqrt(sideways * sideways + beyond * beyond);
      let ink = (radius + 0.5 * edge - distance) / edge;
      if (ink <= 0) continue;
      const texel = columnStart + (row & mask) * sidewaysStride;
      if (grain) ink = inkOnGrain(Math.min(1, ink), stroke.pressure, grain, texel);
      const byte = ink >= 1 ? 0 : Math.round(255 * (1 - ink));
      const before = image[texel];
      if (byte < before) {
        image[texel] = byte;
        darkened += before - byte;
      }
    }
  }
  return darkened;
}

/** The share of a stroke's coverage ∈ (0, 1] that stays on the grain. The higher the pressure, the deeper the ink reaches. */
function inkOnGrain(coverage: number, pressure: number, { depths, contrast }: PaperGrain, texel: number): number {
  const fill = (pressure * coverage - depths[texel] / 255) * contrast + 0.5;
  return coverage * Math.max(0, Math.min(1, fill));
}
