// Dots that are fixed on the surface and round on the screen. They lie where needles through a set of points in a plane meet the
// surface. The plane is one of thirteen, those across the axes of a cube through its faces, edges and corners: the one between
// surface and screen on which dots are most even on both. Half as large, the set holds itself: any number of dots may be born
// between others as the camera comes nearer, and none ever moves.
#include "perFragment/screenGradient"
#include "largestComponents"

uniform float tilesPerUnit; // tiles per object unit
uniform float anchorSpacing; // tiles between anchors
uniform float sizedOnScreen; // 0: dots spaced on the object, 1: on the screen

#include "technique/dots"

// How much the normal of the surface counts against the direction to the viewer in the choice of a plane, at least. It keeps
// needles from lying along the surface.
#define LEAST_PULL 0.5
// Planes whose cosine to the best direction is less than that of the best plane by this have no dots.
#define PLANE_FADE 0.03
// Planes with a smaller share of the dots than this are left out: nobody could tell.
#define LEAST_SHARE 0.02
// Surfaces that lean away further than this cosine are taken for ones that do not, so that dots stay round: those beyond lean.
#define LEAST_ROUND 0.33
// Dots at half tone along each side of a tile, at a sizedOnScreen of 0.
#define DOTS_PER_TILE 64.0
// The diameter of a dot at half tone as a share of the distance between dots: 0.8² π/4 is one half.
#define DOT_SHARE 0.8
// From this tone on down dots lie no further apart, and only grow smaller.
#define LEAST_DENSE_SHARE 0.004
// Black dots alone give a tone up to the first of these, white dots on black alone one from the second on.
#define JOINING vec2(0.5, 0.6)
// Components of unit vectors along the diagonals of a square and of a cube: 1/√2 and 1/√3.
#define SQUARE_DIAGONAL 0.70710678
#define CUBE_DIAGONAL 0.57735027
// Shifts of the set for black dots and for white ones along each axis, in tiles: any numbers that bring no two dots together.
#define BLACK_SHIFT vec3(3.17, 7.71, 5.39)
#define WHITE_SHIFT vec3(4.73, 1.93, 8.29)

// The three planes next to a direction: across the axis nearest to it, across the bisector of the two nearest, and across the
// diagonal of all three.
struct StipplePlanes {
  vec3 nearest; // 1 at the axis, as a mask
  vec3 nearestTwo; // 1 at both axes
  vec3 side; // signs of the direction
  vec3 shares; // of the dots, by plane
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

// The unit axis of the plane with the largest share of those that are left; takes that plane away.
vec3 takePlane(inout StipplePlanes planes, const in float share) {
  vec3 rest = planes.shares;
  planes.shares *= vec3(notEqual(rest, vec3(share)));
  vec3 axis = share == rest.x ? planes.nearest : share == rest.y ? SQUARE_DIAGONAL * planes.nearestTwo : vec3(CUBE_DIAGONAL);
  return axis * planes.side;
}

// Half way from the surface to the viewer, and nearer to the viewer where the surface leans away: there the screen needs it more.
vec3 directionOfNeedles(const in vec3 front, const in vec3 toViewer) {
  return normalize(front * max(dot(front, toViewer), LEAST_PULL) + toViewer);
}

// The tangent plane, leaning away no further than dots stay round.
ScreenMap roundScreenMap(const in vec3 n) {
  ScreenMap map = screenMap(n, readViewToAnchor());
  vec3 toViewer = vec3(map.centre, 1.0);
  float facing = dot(map.normal, toViewer);
  float least = LEAST_ROUND * length(map.normal);
  map.normal += toViewer * (max(least - facing, 0.0) / dot(toViewer, toViewer));
  map.scale = vViewUnitsPerPixel / max(facing, least);
  return map;
}

// What black dots cover, and white ones of what those leave: together they give the tone.
vec2 blackAndWhite(const in float tone) {
  float black = tone > JOINING.x ? JOINING.x * max(JOINING.y - tone, 0.0) / (JOINING.y - JOINING.x) : tone;
  return vec2(black, (1.0 - tone) / (1.0 - black));
}

// Cells of the set per object unit, as a logarithm to base 2, at half tone. Of several planes each has a share of the dots.
float octaveOf(const in PlaneOnScreen plane, const in float share) {
  float onObject = log2(tilesPerUnit * DOTS_PER_TILE);
  float onScreen = -0.5 * log2(max(abs(plane.area), 1e-30)) - log2(dotPixels / DOT_SHARE);
  return mix(min(onObject, onScreen), onScreen, sizedOnScreen) + 0.5 * log2(share);
}

// Takes away what the dots across an axis cover of the blanks that black dots and white ones leave.
void printPlane(
  const in vec3 point, const in vec3 axis, const in float share, const in vec2 covers, const in ScreenMap onScreen, inout vec2 blank
) {
  vec3 u = normalize(anyTangent(axis));
  vec3 v = cross(axis, u);
  PlaneOnScreen plane = planeOnScreen(screenGradient(u, onScreen), screenGradient(v, onScreen));
  float octave = octaveOf(plane, share);
  vec2 place = vec2(dot(point, u), dot(point, v));
  // A loop that ends early, not branches, of which some devices compute either side.
  int last = covers.y < 1.0 ? 1 : 0;
  for (int kind = covers.x > 0.0 ? 0 : 1; kind <= last; kind++) {
    bool isBlack = kind == 0;
    float cover = isBlack ? covers.x : covers.y;
    // Planes are printed over one another.
    float own = 1.0 - pow(max(1.0 - cover, 1e-6), share);
    // A lighter tone has fewer dots and smaller ones, both by its square root: by the fourth root to each side.
    float sparser = 0.25 * log2(clamp(2.0 * cover, 2.0 * LEAST_DENSE_SHARE, 1.0));
    vec3 setShift = isBlack ? BLACK_SHIFT : WHITE_SHIFT;
    vec2 shift = vec2(dot(axis, setShift), dot(axis, setShift.yzx)) / tilesPerUnit;
    float covered = dotsAt(place + shift, plane, octave + sparser, own);
    blank *= isBlack ? vec2(1.0 - covered, 1.0) : vec2(1.0, 1.0 - covered);
  }
}

float hatchLayer(const in HatchingParameters h, const in float tone) {
  vec3 toViewer = normalize(readViewToAnchor() * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition));
  // The normal of a sheet that is seen from behind looks the other way.
  vec3 front = dot(h.normal, toViewer) < -0.5 ? -h.normal : h.normal;
  StipplePlanes planes = planesNear(directionOfNeedles(front, toViewer));
  ScreenMap onScreen = roundScreenMap(front);
  vec2 covers = blackAndWhite(tone);
  vec2 blank = vec2(1.0);
  for (int i = 0; i < 3; i++) {
    float share = max(planes.shares.x, max(planes.shares.y, planes.shares.z));
    if (share < LEAST_SHARE) break;
    vec3 axis = takePlane(planes, share);
    printPlane(h.point, axis, share, covers, onScreen, blank);
  }
  // Without white dots nothing lies on the black ones.
  return covers.y < 1.0 ? 1.0 - blank.x * (1.0 - blank.y) : 1.0 - blank.x;
}
