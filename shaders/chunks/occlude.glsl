// The light that ambient occlusion takes. Ambient light loses the share of the sky that is hidden. Directed light may reach a cavity, but
// cavities must show under any light: it loses as much where most of the sky is hidden, and nearly nothing elsewhere, so that open forms
// keep their lights.
uniform float occlusion; // strength of ambient occlusion
uniform float openOcclusion; // the occlusion that counts as open to the sky, in rooms and among many deep hollows; 0 elsewhere

// The baked occlusion of the side that is seen, relative to that of the open parts.
float occluded() {
  #ifdef DOUBLE_SIDED
    float baked = gl_FrontFacing ? vOcclusion.x : vOcclusion.y;
  #else
    float baked = vOcclusion;
  #endif // DOUBLE_SIDED
  return max(baked - openOcclusion, 0.0) / (1.0 - openOcclusion);
}

float openToSky() {
  return 1.0 - occlusion * occluded();
}

float openToLights() {
  return 1.0 - occlusion * occluded() * smoothstep(0.0, CAVITY, occluded());
}

// Deep hollows are the darkest places of a drawing, lit or not.
uniform float hollowStrength; // their tone

float hollowness() {
  return hollowStrength * occlusion * smoothstep(HOLLOW.x, HOLLOW.y, occluded());
}
