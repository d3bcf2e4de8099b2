// Strokes anchored in object space: the four triangles of the paper's adjacency primitive are replaced by the four nearest points of a
// lattice that is fixed to the object. Each samples the threshold map in the light's frame at the fragment; the fields are blended, and
// then compared with the tone once. Strokes do not depend on the mesh, and are continuous wherever its normals are.
#include "levelByDepth"
#include "thresholdMap"
#include "ink"
#include "technique/simplexLattice"

uniform float latticeSpacing; // tiles between anchors
#ifdef SCREEN_SPACE_SHARE
  uniform float screenSpaceShare; // 0: strokes sized on the object, 1: on the screen
#endif // SCREEN_SPACE_SHARE

// Octaves between the lattices of strokes that are sized on the screen. Between them the levels of the map are used, whose strokes nest;
// only in the last part of an octave does a lattice fade into the next.
#define LATTICE_OCTAVES 1.0
#define LATTICE_FADE 0.75

// Octaves by which strokes may crowd at grazing angles, which shows the form, before coarser levels are used. By the smooth normal, so that
// no edges of triangles show.
#define FREE_CROWDING 1.0

// The g of one lattice's blended field. point: object space. uAxis, vAxis: the strokes' u and v in the surface. octaves: by which the map
// would be too fine for this lattice.
float latticeField(
  const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in float lattice, const in ThresholdLevel level
) {
  LatticeAnchors anchors = nearestAnchors(point * (tilesPerObjectUnit * exp2(lattice * LATTICE_OCTAVES) / latticeSpacing), lattice);
  #if LIGHTS_WITH_DIRECTION > 1 || defined(STROKES_FOLLOW_FORM)
    // Several lights give a direction up to its sign, and so does the form. Where B turns into −B strokes stay: the map is symmetric about
    // its centre, and is shifted by half tiles only.
    vec4 shiftU = 0.5 * vec4(anchors.hashes & 1u);
    vec4 shiftV = 0.5 * vec4((anchors.hashes >> 16u) & 1u);
  #else
    vec4 shiftU = vec4(anchors.hashes & 0xffffu) * (1.0 / 65536.0);
    vec4 shiftV = vec4(anchors.hashes >> 16u) * (1.0 / 65536.0);
  #endif // LIGHTS_WITH_DIRECTION
  // One bit of each word mirrors its strokes.
  vec4 along = latticeSpacing * uAxis * anchors.offsets;
  vec4 u = uintBitsToFloat(floatBitsToUint(along) ^ ((anchors.hashes << 16u) & 0x80000000u)) + shiftU;
  vec4 v = latticeSpacing * vAxis * anchors.offsets + shiftV;
  return blendedField(
    vec2(u.x, v.x), vec2(u.y, v.y), vec2(u.z, v.z), vec2(u.w, v.w), anchors.weights, level
  );
}

// Octaves by which strokes lie closer on the screen than face on.
float foreshortenedOctaves(const in vec3 lean) {
  float facing = lean.z * lean.z;
  return -0.5 * log2(max(facing / max(facing + lean.y * lean.y, 1e-20), 1e-4));
}

// Layers that cross from some tone on, and those of shadows, are blank in most places.
#if STROKE_LAYERS == STROKE_LAYERS_TONE || defined(SEPARATES_SHADOWS)
  #define MAY_BE_BLANK true
#else
  #define MAY_BE_BLANK false
#endif // STROKE_LAYERS

// crowding: octaves by which strokes are finer than drawn. isBlank: nothing will be printed, so the map is not sampled.
HatchField anchoredField(
  const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in vec3 lean, const in bool isBlank, out float crowding
) {
  // Octaves by which the map at tilesPerObjectUnit is magnified: above 0 near, below 0 far away.
  float magnification = -levelByDepth(thresholdMapSize);
  float foreshortened = foreshortenedOctaves(lean);
  HatchField field = HatchField(0.0, 0.0);
  #ifdef SCREEN_SPACE_SHARE
    float wanted = screenSpaceShare * magnification / LATTICE_OCTAVES;
    float lattice = ceil(wanted);
    float faceOn = lattice * LATTICE_OCTAVES - magnification;
    float octaves = faceOn + max(foreshortened - FREE_CROWDING, 0.0);
    float fade = smoothstep(1.0 - LATTICE_FADE, 1.0, 1.0 - (lattice - wanted));
    float i = 0.0;
    // A loop that ends after one pass, not a branch, of which some devices run both sides.
    if (!isBlank) do {
      ThresholdLevel level = chooseLevel(levelFor(octaves + i * LATTICE_OCTAVES));
      field.g += latticeField(point, uAxis, vAxis, lattice + i, level) * (i == 0.0 ? 1.0 - fade : fade);
      field.mixing = max(field.mixing, level.mixing);
      if (fade == 0.0) break;
      i++;
    } while (i < 2.0);
    // The fields are independent: their variances add.
    field.g *= inversesqrt(1.0 - 2.0 * fade * (1.0 - fade));
  #else
    float faceOn = -magnification;
    float octaves = faceOn + max(foreshortened - FREE_CROWDING, 0.0);
    if (!isBlank) {
      ThresholdLevel level = chooseLevel(levelFor(octaves));
      field = HatchField(latticeField(point, uAxis, vAxis, 0.0, level), level.mixing);
    }
  #endif // SCREEN_SPACE_SHARE
  crowding = faceOn + foreshortened - levelFor(octaves);
  return field;
}

float hatchLayer(const in HatchingParameters h, const in float tone) {
  // The edges of strokes need screen-space derivatives, so a fragment counts as blank only if all four of its quad are.
  bool isBlank = MAY_BE_BLANK && !(tone + fwidth(tone) > 0.0);
  float crowding;
  HatchField field = anchoredField(h.point, h.uAxis, h.vAxis, h.lean, isBlank, crowding);
  return inkAt(field, tone, crowding);
}
