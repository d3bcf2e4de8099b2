// Dots that are fixed on the surface and round on the screen. They are where needles through a set of points in a plane meet the
// surface. The plane is one of thirteen: that which lies best between the surface and the screen, so that dots are even on both.
// The set is its own enlargement: half as large it holds itself, so there is no end to how many dots may be born between others as
// one comes nearer, and none ever moves.
#include "perFragment/screenGradient"

uniform highp sampler2D stippleMap; // per cell its point and, in blue, when it is born (src/tam/stippleMap.ts)
uniform float dotPixels; // diameter of a dot at half tone
uniform float strokeScale; // tiles per object unit
uniform float anchorSpacing;
uniform float screenConstancy; // 0: dots spaced on the object, 1: on the screen
uniform float edgePixels; // width of the edge of a dot

// Of dots at half tone, the share that each has of its room: half of a square is a disc of 0.8 its side.
#define DOT_SHARE 0.8
// Dots per tile at a screenConstancy of 0, along each side.
#define DOTS_PER_TILE 64.0
// How much the surface counts in the choice of the plane, at least; the screen counts 1.
#define LEAST_PULL 0.5
// How far a plane's tilt may differ from that of the best one, as a cosine, where dots of both stand side by side.
#define PLANE_FADE 0.03
// Shares of the surface too small to be told apart.
#define LEAST_SHARE 0.02
// Cells on either side of a place whose dots are looked at, at the most.
#define MOST_REACH 1.5
// The share of an octave in which a dot grows to its full size.
#define GROWTH 0.35
// Covering less than this share, dots fade instead of lying farther apart.
#define LEAST_DENSE_SHARE 0.004
// Up to the first tone there are black dots alone; from the second on, white ones in black.
#define JOINING vec2(0.5, 0.6)
// Where the surface leans away further than this cosine, dots lean with the rest.
#define LEAST_ROUND 0.33

// Shares of the planes across a first, the first two and all three of the axes that the normal is nearest to.
vec3 planeShares(const in vec3 towards) {
  vec3 facing = vec3(1.0, 0.70710678, 0.57735027) * towards;
  vec3 shares = clamp(1.0 + (facing - max(facing.x, max(facing.y, facing.z))) / PLANE_FADE, 0.0, 1.0);
  shares *= shares;
  return shares / (shares.x + shares.y + shares.z);
}

// How much dots that are born during an octave cover so far into it, each as a share of its full area, on the average.
float grownShare(const in float octave) {
  vec2 t = max(vec2(octave, octave + GROWTH - 1.0), 0.0);
  vec2 covered = mix(0.5 * t * t / GROWTH, t - 0.5 * GROWTH, step(GROWTH, t));
  return (covered.x - covered.y) / (1.0 - GROWTH);
}

// Area of all discs together, as a share of the whole, of which they cover so much. From a half on they overlap, more so early in an
// octave, when the first of those that are born lie close to others; fitted to the set.
float discArea(const in float covered, const in float octave) {
  float beyond = max(covered - 0.5, 0.0);
  float overlap = 0.25 + 2.8 * octave * (1.0 - octave) * (1.0 - octave);
  return covered + overlap * beyond * beyond * inversesqrt(max(1.0 - covered, 1e-3));
}

// The radius that a disc with a soft edge is drawn with, in units of the edge: the edge makes it larger, by as much as it is drawn
// smaller. Of discs below that width the radius stays.
float softRadius(const in float squared) {
  return sqrt(max(squared - 1.0 / 12.0, 0.25));
}

// How much of this fragment the dots of one plane cover, of which all together cover a share. at: in the plane. gradients: of its two
// coordinates on the screen. octave: cells of the set per unit, as a logarithm.
float dotsOfPlane(
  const in vec2 at, const in vec2 gradientU, const in vec2 gradientV, const in float octave, const in float share
) {
  float cells = exp2(floor(octave) + 1.0);
  float into = fract(octave);
  float area = gradientU.x * gradientV.y - gradientU.y * gradientV.x;
  float perCell = 0.25 + 0.75 * grownShare(into);
  // In units of the edge: the squared radius of a dot that is full-grown, and the way from cells to the screen.
  float edge = max(edgePixels, 1e-2);
  float squared = discArea(share, into) * RECIPROCAL_PI / (max(abs(area), 1e-20) * cells * cells * perCell * edge * edge);
  mat2 toScreen = mat2(gradientV.y, -gradientV.x, -gradientU.y, gradientU.x) / (area * cells * edge);
  vec2 place = at * cells;
  // Rows of cells whose dots may reach this place.
  float largest = softRadius(squared) + 0.5;
  float reach = min(largest * edge * cells * length(gradientV), MOST_REACH);
  float left = floor(place.x - MOST_REACH);
  float lowest = floor(place.y - reach);
  float highest = floor(place.y + reach);
  float covered = 0.0;
  // Bounded, whatever numbers a broken mesh may bring.
  for (int row = 0; row < 4; row++) {
    if (lowest + float(row) > highest) break;
    for (int column = 0; column < 4; column++) {
      vec2 cell = vec2(left + float(column), lowest + float(row));
      vec3 texel = texelFetch(stippleMap, ivec2(cell) & (STIPPLE_MAP_SIZE - 1), 0).rgb;
      vec2 away = toScreen * (cell + texel.xy - place);
      float grown = clamp((into - texel.z * (1.0 - GROWTH)) / GROWTH, step(texel.z, 0.0), 1.0);
      float full = squared * grown;
      // Two that meet in a pixel each have a part of it. Below the width of the edge a dot keeps its ink and loses its darkness.
      covered += clamp(softRadius(full) - length(away) + 0.5, 0.0, 1.0) * min(3.0 * full, 1.0);
    }
  }
  return min(covered, 1.0);
}

ScreenMap roundScreenMap(const in vec3 n) {
  ScreenMap map = screenMap(n, readViewToAnchor());
  vec3 toViewer = vec3(map.centre, 1.0);
  float facing = dot(map.normal, toViewer);
  float least = LEAST_ROUND * length(map.normal);
  map.normal += toViewer * (max(least - facing, 0.0) / dot(toViewer, toViewer));
  map.scale = vViewUnitsPerPixel / max(facing, least);
  return map;
}

float hatchLayer(const in HatchingParameters h, const in float tone) {
  vec3 toViewer = normalize(readViewToAnchor() * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition));
  // The back of a sheet looks the other way.
  vec3 front = dot(h.normal, toViewer) < -0.5 ? -h.normal : h.normal;
  // Half way to the viewer, or nearer to the viewer where the surface leans away: there the screen needs it more. How far is bounded,
  // so that needles never lie along the surface.
  vec3 n = normalize(front * max(dot(front, toViewer), LEAST_PULL) + toViewer);
  // Ranks of the axes by how near the normal is to them; ties go the same way in all components.
  vec3 towards = abs(n);
  vec3 greater = step(towards.yzx, towards.xyz);
  vec3 less = 1.0 - greater;
  vec3 nearest = min(greater, less.zxy);
  vec3 nearestTwo = max(greater, less.zxy);
  vec3 rest = planeShares(vec3(dot(towards, nearest), dot(towards, nearestTwo), towards.x + towards.y + towards.z));
  vec3 side = vec3(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0, n.z < 0.0 ? -1.0 : 1.0);

  ScreenMap onScreen = roundScreenMap(front);
  // What black dots cover, and white ones of what is left to them: together, the tone.
  float black = tone > JOINING.x ? JOINING.x * max(JOINING.y - tone, 0.0) / (JOINING.y - JOINING.x) : tone;
  float white = (1.0 - tone) / (1.0 - black);
  float onObject = log2(strokeScale * DOTS_PER_TILE);
  vec2 blank = vec2(1.0);
  for (int i = 0; i < 3; i++) {
    float share = max(rest.x, max(rest.y, rest.z));
    if (share < LEAST_SHARE) break;
    vec3 axis = share == rest.x ? nearest : share == rest.y ? 0.70710678 * nearestTwo : vec3(0.57735027);
    rest *= vec3(notEqual(rest, vec3(share)));
    axis *= side;
    vec3 u = normalize(anyTangent(axis));
    vec3 v = cross(axis, u);
    vec2 gradientU = screenGradient(u, onScreen);
    vec2 gradientV = screenGradient(v, onScreen);
    float area = abs(gradientU.x * gradientV.y - gradientU.y * gradientV.x);
    float onPaper = -0.5 * log2(max(area, 1e-30)) - log2(dotPixels / DOT_SHARE);
    float octave = mix(min(onObject, onPaper), onPaper, screenConstancy) + 0.5 * log2(share);
    vec2 place = vec2(dot(h.point, u), dot(h.point, v));
    // Black dots, then white ones, where there are any: a loop that is left, not branches, of which some devices compute either side.
    int last = white < 1.0 ? 1 : 0;
    for (int kind = black > 0.0 ? 0 : 1; kind <= last; kind++) {
      bool isBlack = kind == 0;
      float all = isBlack ? black : white;
      float own = 1.0 - pow(max(1.0 - all, 1e-6), share);
      // Where there is little to cover dots are fewer, and only then smaller.
      float dense = 0.25 * log2(clamp(2.0 * all, 2.0 * LEAST_DENSE_SHARE, 1.0));
      // No two sets are the same at the same place.
      vec3 lot = isBlack ? vec3(3.17, 7.71, 5.39) : vec3(4.73, 1.93, 8.29);
      vec2 shift = vec2(dot(axis, lot), dot(axis, lot.yzx)) / strokeScale;
      float covered = dotsOfPlane(place + shift, gradientU, gradientV, octave + dense, own);
      blank *= isBlack ? vec2(1.0 - covered, 1.0) : vec2(1.0, 1.0 - covered);
    }
  }
  // Where white dots are all there is, nothing is black.
  return white < 1.0 ? 1.0 - blank.x * (1.0 - blank.y) : 1.0 - blank.x;
}
