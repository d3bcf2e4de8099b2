// Strokes anchored in object space: the four triangles of the paper's adjacency primitive give way to the four nearest
// points of a lattice that is fixed on the object. Each samples the threshold map in the light's frame at the fragment,
// the fields are blended, and ink is decided once. Independent of the mesh, and continuous wherever its normals are.
#include "simplexLattice"

uniform float anchorSpacing; // tiles between anchors
uniform float strokeScale; // tiles per object unit
uniform float thresholdMapSize; // texels per side of level 0
uniform float thresholdMapLevels;
uniform float texelPixels; // wanted pixels per texel
uniform float screenConstancy; // 0: strokes sized on the object, 1: on the screen

// Octaves between one lattice and the next finer one.
#define OCTAVES_PER_LATTICE 2.0
// The share of that range, at its end, in which the next lattice fades in; and of a level, in which the next one does.
#define LATTICE_FADE 0.3
#define LEVEL_FADE 0.3
// How alike two neighbouring levels of the threshold map are: nested strokes make them correlate.
#define LEVEL_CORRELATION 0.5

// The blended field of one lattice, at one level of the map.
float latticeField(
  const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in float tilesPerUnit, const in float level,
  const in uint lattice
) {
  float edge = anchorSpacing / tilesPerUnit;
  LatticeAnchors anchors = nearestAnchors(point / edge);
  float field = 0.0;
  float squares = 0.0;
  for (int i = 0; i < 4; i++) {
    float w = anchorWeight(anchors.offset[i]);
    uvec3 h = hashWords(uvec3(anchors.id[i]) + 0x9e3779b9u * lattice);
    // The map is symmetric about its centre and about its corners' middles, and shifted by half tiles only: where B
    // turns into −B (directions are known up to sign), the strokes stay.
    vec2 shift = 0.5 * vec2(h.xy >> 31u);
    float mirror = (h.z >> 31u) == 0u ? 1.0 : -1.0;
    vec2 uv = anchorSpacing * vec2(mirror * dot(anchors.offset[i], uAxis), dot(anchors.offset[i], vAxis));
    field += w * textureLod(thresholdMap, uv + shift, level).r;
    squares += w * w;
  }
  return field * inversesqrt(squares);
}

// The same between two levels.
float levelledField(
  const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in float tilesPerUnit, const in float level,
  const in uint lattice
) {
  float clamped = clamp(level, 0.0, thresholdMapLevels - 1.0);
  float lower = floor(clamped);
  float next = smoothstep(1.0 - LEVEL_FADE, 1.0, clamped - lower);
  float field = latticeField(point, uAxis, vAxis, tilesPerUnit, lower, lattice);
  if (next == 0.0) return field;
  float coarser = latticeField(point, uAxis, vAxis, tilesPerUnit, lower + 1.0, lattice);
  float rest = 1.0 - next;
  return mix(field, coarser, next) * inversesqrt(rest * rest + next * next + 2.0 * rest * next * LEVEL_CORRELATION);
}

// point: object space, rest pose. uAxis, vAxis: the strokes' u and v in the surface. unitsPerPixel: object units to a pixel.
float anchoredField(const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in float unitsPerPixel) {
  // Octaves by which the map at its own scale is magnified: > 0 too near, < 0 too far.
  float magnification = -log2(strokeScale * unitsPerPixel * thresholdMapSize * texelPixels);
  float wanted = screenConstancy * magnification / OCTAVES_PER_LATTICE;
  float lattice = ceil(wanted);
  float level = lattice * OCTAVES_PER_LATTICE - magnification;
  float tilesPerUnit = strokeScale * exp2(lattice * OCTAVES_PER_LATTICE);
  float field = levelledField(point, uAxis, vAxis, tilesPerUnit, level, uint(int(lattice)));
  // Coming nearer, the level falls to 0; just before, the next finer lattice takes over.
  float next = screenConstancy > 0.0 ? smoothstep(1.0 - LATTICE_FADE, 1.0, 1.0 - (lattice - wanted)) : 0.0;
  if (next == 0.0) return field;
  float finer = levelledField(
    point, uAxis, vAxis, tilesPerUnit * exp2(OCTAVES_PER_LATTICE), level + OCTAVES_PER_LATTICE, uint(int(lattice) + 1)
  );
  float rest = 1.0 - next;
  return mix(field, finer, next) * inversesqrt(rest * rest + next * next);
}
