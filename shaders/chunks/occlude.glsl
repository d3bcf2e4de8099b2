// What ambient occlusion takes of the light. Light from all around loses the share of the sky that is hidden. Light with a direction
// may well reach a cavity, but cavities must be seen under any light: it loses as much where much of the sky is hidden, and nearly
// nothing where little is, so that the lights of open forms stay clear.
uniform float occlusion; // how much of it counts

float openToSky() {
  return 1.0 - occlusion * vOcclusion;
}

float openToLights() {
  return 1.0 - occlusion * vOcclusion * smoothstep(0.0, CAVITY, vOcclusion);
}

// The depths of hollows are the darkest places of a drawing, also where light reaches them.
uniform float hollowTone; // how dark they are

float hollowness() {
  return hollowTone * occlusion * smoothstep(HOLLOW.x, HOLLOW.y, vOcclusion);
}
