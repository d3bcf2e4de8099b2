// Dots that are fixed on the surface and round on the screen. A set of points in a plane is projected onto the surface along the normal of
// the plane. There are thirteen planes, perpendicular to the axes of a cube through its faces, edges and corners; the one between surface
// and screen has dots that are even on both. The set contains itself at half the scale: any number of dots may appear between others as the
// camera comes nearer, and none ever moves.
#include "technique/constants"
#include "perFragment/screenGradient"
#include "largestComponents"

uniform float tilesPerObjectUnit; // tiles per object unit
uniform float latticeSpacing; // tiles between anchors
uniform float screenSpaceShare; // 0: dots spaced on the object, 1: on the screen

#include "technique/dots"

// Components of unit vectors along the diagonals of a square and of a cube: 1/√2 and 1/√3.
#define SQUARE_DIAGONAL 0.70710678
#define CUBE_DIAGONAL 0.57735027

// The three planes whose axes are nearest to a direction: the nearest coordinate axis, the bisector of the two nearest, and the diagonal of
// all three.
struct StipplePlanes {
  vec3 nearest; // mask of the nearest axis
  vec3 nearestTwo; // mask of the two nearest
  vec3 side; // signs of the direction
  vec3 shares; // shares of the dots that lie in each plane
};

vec3 planeShares(const in vec3 cosines) {
  vec3 shares = clamp(1.0 + (cosines - max(cosines.x, max(cosines.y, cosines.z))) / PLANE_FADE, 0.0, 1.0);
  shares *= shares;
  return shares / (shares.x + shares.y + shares.z);
}

StipplePlanes planesNear(const in vec3 direction) {
  StipplePlanes planes;
  vec3 towards = abs(direction);
  largestComponents(towards, planes.nearest, planes.nearestTwo);
  vec3 sums = vec3(dot(towards, planes.nearest), dot(towards, planes.nearestTwo), towards.x + towards.y + towards.z);
  planes.shares = planeShares(vec3(1.0, SQUARE_DIAGONAL, CUBE_DIAGONAL) * sums);
  planes.side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0, direction.z < 0.0 ? -1.0 : 1.0);
  return planes;
}

// The unit axis of the plane with the largest remaining share, which is then removed.
vec3 takePlane(inout StipplePlanes planes, const in float share) {
  vec3 rest = planes.shares;
  planes.shares *= vec3(notEqual(rest, vec3(share)));
  vec3 axis = share == rest.x ? planes.nearest : share == rest.y ? SQUARE_DIAGONAL * planes.nearestTwo : vec3(CUBE_DIAGONAL);
  return axis * planes.side;
}

// The direction that chooses the planes: half way from the normal to the viewer, nearer to the viewer at grazing angles, where dots must
// face the screen.
vec3 directionOfNeedles(const in vec3 front, const in vec3 toViewer) {
  return normalize(front * max(dot(front, toViewer), LEAST_PULL) + toViewer);
}

// The screen map of the tangent plane, with the angle limited to where dots stay round.
mat2x3 roundScreenMap(const in vec3 n) {
  mat3 viewToPlace = readViewToAnchor();
  vec3 normal = n * viewToPlace;
  vec3 toViewer = vec3(centreOfScreen(), 1.0);
  float facing = dot(normal, toViewer);
  float least = LEAST_ROUND * length(normal);
  normal += toViewer * (max(least - facing, 0.0) / dot(toViewer, toViewer));
  return screenMapOf(normal * (vViewUnitsPerPixel / max(facing, least)), toViewer.xy, viewToPlace);
}

// The share that dots cover at a tone: the tone itself in the lights, more in the darks, which end solid.
float coverOf(const in float tone) {
  float way = clamp((tone - CLOSING.x) / (CLOSING.y - CLOSING.x), 0.0, 1.0);
  return min(tone + (1.0 - CLOSING.y) * way * way, 1.0);
}

// The logarithm to base 2 of cells per object unit at which dots cover half.
float octaveOf(const in PlaneOnScreen plane) {
  float onObject = log2(tilesPerObjectUnit * DOTS_PER_TILE);
  float onScreen = -0.5 * log2(max(abs(plane.area), 1e-30)) - log2(dotPixels / DOT_SHARE);
  return mix(min(onObject, onScreen), onScreen, screenSpaceShare);
}

// The share that the dots of the plane across an axis cover.
float dotsAcross(const in vec3 point, const in vec3 axis, const in float cover, const in mat2x3 onScreen) {
  vec3 u = normalize(anyTangent(axis));
  vec3 v = cross(axis, u);
  PlaneOnScreen plane = planeOnScreen(screenGradient(u, onScreen), screenGradient(v, onScreen));
  float crowding = 0.5 * CROWDING * log2(-log2(1.0 - max(cover, LEAST_DENSE_SHARE)));
  vec2 place = vec2(dot(point, u), dot(point, v));
  vec2 shift = vec2(dot(axis, SET_SHIFT), dot(axis, SET_SHIFT.yzx)) / tilesPerObjectUnit;
  return dotsAt(place + shift, plane, octaveOf(plane) + crowding, cover);
}

float hatchLayer(const in HatchingParameters h, const in float tone) {
  float cover = coverOf(tone);
  float blank = 1.0 - cover;
  if (cover <= 0.0 || cover >= 1.0) return cover;
  vec3 toViewer = normalize(readViewToAnchor() * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition));
  // The normal of a back-facing sheet points away.
  vec3 front = dot(h.normal, toViewer) < FROM_BEHIND ? -h.normal : h.normal;
  StipplePlanes planes = planesNear(directionOfNeedles(front, toViewer));
  mat2x3 onScreen = roundScreenMap(front);
  float left = 1.0;
  for (int i = 0; i < 3; i++) {
    float share = max(planes.shares.x, max(planes.shares.y, planes.shares.z));
    if (share < LEAST_SHARE) break;
    vec3 axis = takePlane(planes, share);
    // Planes are printed over one another.
    left *= 1.0 - dotsAcross(h.point, axis, 1.0 - pow(blank, share), onScreen);
  }
  return 1.0 - left * min(blank / (1.0 - FILLING), 1.0);
}
