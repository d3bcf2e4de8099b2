// Strokes anchored in object space: the four triangles of the paper's adjacency primitive give way to the four nearest
// points of a lattice that is fixed on the object. Each samples the threshold map in the light's frame at the fragment,
// the fields are blended, and ink is decided once. Independent of the mesh, and continuous wherever its normals are.
#include "simplexLattice"

uniform float screenConstancy; // 0: strokes sized on the object, 1: on the screen

// Where strokes are sized on the screen, lattices stand this many octaves apart. The levels of the map, whose strokes nest,
// serve between them; only in the last part of the way does a lattice give way to one with other strokes.
#define LATTICE_OCTAVES 1.0
#define LATTICE_FADE 0.75

// The blended field of one lattice. point: object space. uAxis, vAxis: the strokes' u and v in the surface. octaves: by
// how many the map would be too fine for this lattice.
HatchField latticeField(
  const in vec3 point, const in vec3 uAxis, const in vec3 vAxis, const in float lattice, const in float octaves
) {
  float edge = anchorSpacing / (strokeScale * exp2(lattice * LATTICE_OCTAVES));
  LatticeAnchors anchors = nearestAnchors(point / edge);
  ThresholdLevel level = chooseLevel(octaves);
  float field = 0.0;
  float squares = 0.0;
  for (int i = 0; i < 4; i++) {
    float w = anchorWeight(anchors.offset[i]);
    // Out of reach, as the others are close to an anchor: no fetch.
    if (w == 0.0) continue;
    uint h = hashAnchor(anchors.id[i], uint(int(lattice)));
    #if LIGHTS_WITH_DIRECTION > 1
      // Several lights give a direction up to its sign. The map is symmetric about its centre, and shifted by half tiles
      // only: where B turns into −B the strokes stay.
      vec2 shift = 0.5 * vec2(h & 1u, (h >> 16u) & 1u);
    #else
      vec2 shift = vec2(h & 0xffffu, h >> 16u) * (1.0 / 65536.0);
    #endif // LIGHTS_WITH_DIRECTION
    float mirror = (h & 0x8000u) == 0u ? 1.0 : -1.0;
    vec2 uv = anchorSpacing * vec2(mirror * dot(anchors.offset[i], uAxis), dot(anchors.offset[i], vAxis)) + shift;
    field += w * thresholdAt(uv, level);
    squares += w * w;
  }
  return HatchField(field * inversesqrt(squares), level.mixing);
}

HatchField anchoredField(const in vec3 point, const in vec3 uAxis, const in vec3 vAxis) {
  // Octaves by which the map at strokeScale is magnified: > 0 too near, < 0 too far.
  float magnification = -levelByDepth(thresholdMapSize);
  float wanted = screenConstancy * magnification / LATTICE_OCTAVES;
  float lattice = ceil(wanted);
  float octaves = lattice * LATTICE_OCTAVES - magnification;
  HatchField field = latticeField(point, uAxis, vAxis, lattice, octaves);
  // At screenConstancy 0 there is one lattice, and no other to fade to.
  float fade = screenConstancy > 0.0 ? smoothstep(1.0 - LATTICE_FADE, 1.0, 1.0 - (lattice - wanted)) : 0.0;
  if (fade == 0.0) return field;
  return blendFields(field, latticeField(point, uAxis, vAxis, lattice + 1.0, octaves + LATTICE_OCTAVES), fade);
}
