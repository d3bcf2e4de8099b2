// What occlusion takes of the light. Light from all around loses the share of the sky that is hidden. Light with a direction may
// well arrive, yet cavities must read under any: it loses the share to the power of 3/2, so that gentle folds stay clear and
// deep ones close.
uniform float occlusion; // how much of it counts

float openToSky() {
  return 1.0 - occlusion * vOcclusion;
}

float openToLights() {
  float hidden = occlusion * vOcclusion;
  return 1.0 - hidden * sqrt(hidden);
}
