// Strokes anchored in object space: the four triangles of the paper's adjacency primitive give way to the four nearest
// points of a lattice that is fixed on the object. Each samples the threshold map in the light's frame at the fragment,
// the fields are blended, and ink is decided once. Independent of the mesh, and continuous wherever its normals are.
#include "levelByDepth"
#include "thresholdMap"
#include "technique/simplexLattice"

uniform float anchorSpacing; // tiles between anchors
uniform float screenConstancy; // 0: strokes sized on the object, 1: on the screen

// Where strokes are sized on the screen, lattices stand this many octaves apart. The levels of the map, whose strokes nest,
// serve between them; only in the last part of the way does a lattice give way to one with other strokes.
#define LATTICE_OCTAVES 1.0
#define LATTICE_FADE 0.75

// Strokes crowd as the surface leans away, which shows its form, but no more than by so many octaves: then coarser levels take
// over. By the smooth normal, so that no edge of a triangle shows.
#define FREE_CROWDING 1.0

// The blended field of one lattice. point: object space. uAxis, vAxis: the strokes' u and v in the surface. octaves: by
// how many the map would be too fine for this lattice.
HatchField latticeField(
  const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in float lattice, const in float octaves
) {
  LatticeAnchors anchors = nearestAnchors(point * (strokeScale * exp2(lattice * LATTICE_OCTAVES) / anchorSpacing), lattice);
  #if LIGHTS_WITH_DIRECTION > 1
    // Several lights give a direction up to its sign. The map is symmetric about its centre, and shifted by half tiles
    // only: where B turns into −B the strokes stay.
    vec4 shiftU = 0.5 * vec4(anchors.hashes & 1u);
    vec4 shiftV = 0.5 * vec4((anchors.hashes >> 16u) & 1u);
  #else
    vec4 shiftU = vec4(anchors.hashes & 0xffffu) * (1.0 / 65536.0);
    vec4 shiftV = vec4(anchors.hashes >> 16u) * (1.0 / 65536.0);
  #endif // LIGHTS_WITH_DIRECTION
  vec4 mirror = 1.0 - 2.0 * vec4((anchors.hashes >> 15u) & 1u);
  vec4 u = mirror * (anchorSpacing * uAxis * anchors.offsets) + shiftU;
  vec4 v = anchorSpacing * vAxis * anchors.offsets + shiftV;
  ThresholdLevel level = chooseLevel(levelFor(octaves));
  return blendedField(
    vec2(u.x, v.x), vec2(u.y, v.y), vec2(u.z, v.z), vec2(u.w, v.w), anchors.weights, level
  );
}

// Octaves by which strokes lie closer on the screen than face on, where the surface leans away across them.
float foreshortenedOctaves(const in vec3 lean) {
  float facing = lean.z * lean.z;
  return -0.5 * log2(max(facing / max(facing + lean.y * lean.y, 1e-20), 1e-4));
}

// crowding: octaves by which strokes are finer than drawn.
HatchField anchoredField(
  const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in vec3 lean, out float crowding
) {
  // Octaves by which the map at strokeScale is magnified: > 0 too near, < 0 too far.
  float magnification = -levelByDepth(thresholdMapSize);
  float wanted = screenConstancy * magnification / LATTICE_OCTAVES;
  float lattice = ceil(wanted);
  float faceOn = lattice * LATTICE_OCTAVES - magnification;
  float foreshortened = foreshortenedOctaves(lean);
  float octaves = faceOn + max(foreshortened - FREE_CROWDING, 0.0);
  crowding = faceOn + foreshortened - levelFor(octaves);
  // At screenConstancy 0 there is one lattice, and no other to fade to.
  float fade = screenConstancy > 0.0 ? smoothstep(1.0 - LATTICE_FADE, 1.0, 1.0 - (lattice - wanted)) : 0.0;
  HatchField field = HatchField(0.0, 0.0);
  float i = 0.0;
  // A loop that is left after its body, not a branch, of which some devices compute either side.
  do {
    HatchField one = latticeField(point, uAxis, vAxis, lattice + i, octaves + i * LATTICE_OCTAVES);
    field.g += one.g * (i == 0.0 ? 1.0 - fade : fade);
    field.mixing = max(field.mixing, one.mixing);
    if (fade == 0.0) break;
    i++;
  } while (i < 2.0);
  // The fields are independent: their variances add.
  field.g *= inversesqrt(1.0 - 2.0 * fade * (1.0 - fade));
  return field;
}

float hatchLayer(const in HatchingParameters h, const in float tone) {
  float crowding;
  HatchField field = anchoredField(h.point, h.uAxis, h.vAxis, h.lean, crowding);
  return inkAt(field, tone, crowding);
}
