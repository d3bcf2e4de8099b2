// What occlusion takes of the light. Light from all around loses the share of the sky that is hidden. Light with a direction may
// well arrive, yet cavities must read under any: it loses as much where much is hidden, and nearly nothing where little is, so
// that the lights of open forms stay clear.
uniform float occlusion; // how much of it counts

// From so much on, all of it counts.
#define CAVITY 0.4

float openToSky() {
  return 1.0 - occlusion * vOcclusion;
}

float openToLights() {
  return 1.0 - occlusion * vOcclusion * smoothstep(0.0, CAVITY, vOcclusion);
}
