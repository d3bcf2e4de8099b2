// Smooth metal mirrors a room: light above its horizon, dark below, and a floor that is light again. In place of darkenedByColor.glsl.
uniform float metalness;
uniform float roughness;

// The light of the room where a surface mirrors it, from 0 to 1.
PerToneNormal mirroredRoom(const in HatchingSurface surface) {
  vec3 toViewer = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition);
  vec3 up = viewMatrix[1].xyz;
  // The sine of the angle from the horizon of the way to the viewer, mirrored at the normal.
  PerToneNormal above = 2.0 * cosines(toViewer, surface.normals) * cosines(up, surface.normals) - dot(up, toViewer);
  PerToneNormal below = mix(PerToneNormal(ROOM.x), PerToneNormal(ROOM.y), smoothstep(FLOOR.x, FLOOR.y, -above));
  return mix(below, PerToneNormal(1.0), smoothstep(-HORIZON, HORIZON, above));
}

// The tone of a light, as far as metal mirrors the room instead, and darkened by its colour.
PerToneNormal darkenedByColor(const in PerToneNormal tone, const in HatchingSurface surface) {
  float share = MIRRORED * metalness * (1.0 - smoothstep(ROUGH.x, ROUGH.y, roughness));
  PerToneNormal room = toneFromRadiance(openToSky() * mirroredRoom(surface));
  return mix(mix(tone, room, share), PerToneNormal(toneEnds.y), surface.darkness);
}
