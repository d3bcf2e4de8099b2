// The dots of one plane, a disc on the screen for each point of the set.
uniform highp sampler2D stippleMap; // one texel per cell: the position of its point and, in blue, the part of an octave at which it appears (src/material/tam/stippleMap.ts)
uniform float dotPixels; // diameter of a dot at half tone
uniform float edgePixels; // width of the edge of a dot

// The greatest distance, in cells, from which a dot reaches a place, and the most cells of a row within that distance.
#define MOST_REACH 1.5
#define MOST_CELLS 4
// A disc of radius r whose edge fades over a width of 1 covers π (r² + 1/12).
#define EDGE_COVER (1.0 / 12.0)
// A smaller disc would be all edge: it is drawn with this squared radius, and paler. It covers π/3, so that a disc of squared radius s,
// which should cover π s, is 3 s as dark.
#define LEAST_SQUARED_RADIUS 0.25
#define FADING 3.0

// The derivatives of coordinates in a plane.
struct PlaneOnScreen {
  vec2 gradientU, gradientV; // per pixel
  float area; // object units² per pixel; its sign is the orientation
};

PlaneOnScreen planeOnScreen(const in vec2 gradientU, const in vec2 gradientV) {
  return PlaneOnScreen(gradientU, gradientV, gradientU.x * gradientV.y - gradientU.y * gradientV.x);
}

// The mean area, as a share of the full one, of the dots that appear during an octave. They appear evenly from its beginning to 1 −
// DOT_GROWTH.
float grownShare(const in float octave) {
  vec2 t = max(vec2(octave, octave + DOT_GROWTH - 1.0), 0.0);
  vec2 covered = mix(0.5 * t * t / DOT_GROWTH, t - 0.5 * DOT_GROWTH, step(DOT_GROWTH, t));
  return (covered.x - covered.y) / (1.0 - DOT_GROWTH);
}

// The area of a dot during an octave, as a share of its full area. born: 0 for dots of the octave before.
float grownBy(const in float octave, const in float born) {
  return clamp((octave - born * (1.0 - DOT_GROWTH)) / DOT_GROWTH, step(born, 0.0), 1.0);
}

// The total area of discs that together cover a share of the plane, as a share of the plane. From 0.5 on they overlap.
float discArea(const in float covered, const in float octave) {
  float beyond = max(covered - 0.5, 0.0);
  float overlap = OVERLAP + OVERLAP_WITHIN * octave * (1.0 - octave) * (1.0 - octave);
  return covered + overlap * beyond * beyond * inversesqrt(max(1.0 - covered, LEAST_BLANK));
}

// The radius of a disc whose soft edge does not enlarge it, in widths of the edge. squared: of a disc with a hard edge.
float softRadius(const in float squared) {
  return sqrt(max(squared - EDGE_COVER, LEAST_SQUARED_RADIUS));
}

// The share of a pixel that a dot covers. away: distance to its centre, in widths of the edge; the root of `squared`.
float dotCover(const in float away, const in float squared) {
  return clamp(softRadius(squared) - away + 0.5, 0.0, 1.0) * min(FADING * squared, 1.0);
}

// The share of the fragment that the dots of a plane cover. octave: of the cells per object unit. share: that all of its dots cover.
float dotsAt(const in vec2 at, const in PlaneOnScreen plane, const in float octave, const in float share) {
  float cells = exp2(floor(octave) + 1.0);
  float into = fract(octave);
  // A quarter of the cells had their dots before this octave.
  float dotsPerCell = 0.25 + 0.75 * grownShare(into);
  // In widths of the edge: the squared radius of a full-grown dot, and the Jacobian from cells to the screen.
  float edge = max(edgePixels, 1e-2);
  float squared = discArea(share, into) * RECIPROCAL_PI / (max(abs(plane.area), 1e-20) * cells * cells * dotsPerCell * edge * edge);
  mat2 toScreen = mat2(plane.gradientV.y, -plane.gradientV.x, -plane.gradientU.y, plane.gradientU.x) / (plane.area * cells * edge);
  vec2 place = at * cells;
  // Rows of cells whose dots may reach this place.
  float largest = softRadius(squared) + 0.5;
  float reach = min(largest * edge * cells * length(plane.gradientV), MOST_REACH);
  float left = floor(place.x - MOST_REACH);
  float lowest = floor(place.y - reach);
  float highest = floor(place.y + reach);
  float covered = 0.0;
  // A bounded loop, so that broken meshes cannot stall the GPU.
  for (int row = 0; row < MOST_CELLS; row++) {
    if (lowest + float(row) > highest) break;
    for (int column = 0; column < MOST_CELLS; column++) {
      vec2 cell = vec2(left + float(column), lowest + float(row));
      vec3 texel = texelFetch(stippleMap, ivec2(cell) & (STIPPLE_MAP_SIZE - 1), 0).rgb;
      vec2 away = toScreen * (cell + texel.xy - place);
      // Two dots that meet in a pixel each cover a part of it.
      covered += dotCover(length(away), squared * grownBy(into, texel.z));
    }
  }
  return min(covered, 1.0);
}
