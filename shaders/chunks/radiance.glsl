// R: the radiance of a white surface under the scene's lights, for each of its tone normals. three.js' <lights_fragment_begin> loops over
// the lights and calls RE_Direct with each, shadows included.
#include "environment"

uniform float shininess;
uniform float reflectedLight; // share of each light that the surroundings reflect

struct HatchingSurface {
  vec3 smoothNormal; // unit, view space
  ToneNormals normals; // unit, view space
  PerToneNormal radiance;
  PerToneNormal shadowed; // radiance that shadows take, where SEPARATES_SHADOWS
  float darkness; // darkness of its own colour, as far as it becomes tone
  float plane; // 1 on plane surfaces, 0 on round ones
};

// The flatness of a surface: 1 where the normal changes by less than 2e-5 from one pixel to the next, 0 from 1e-4 on.
float planeness(const in vec3 smoothNormal) {
  #if TONE_MODEL == TONE_MODEL_SHADOW
    return 0.0; // The tone of a dissolving shadow is the share of the light that it takes.
  #else
    return 1.0 - smoothstep(2e-5, 1e-4, length(fwidth(smoothNormal)));
  #endif // TONE_MODEL
}

float cosines(const in vec3 direction, const in vec3 normal) {
  return dot(direction, normal);
}

void addDirectRadiance(const in IncidentLight light, const in vec3 toViewer, inout HatchingSurface surface) {
  PerToneNormal cosine = cosines(light.direction, surface.normals);
  #if TONE_MODEL == TONE_MODEL_HALF_LAMBERT
    // Half Lambert: the terminator moves from 90° to 180°, so that nothing is lost in flat black.
    PerToneNormal halfway = 0.5 * cosine + 0.5;
    PerToneNormal response = halfway * halfway;
  #else
    PerToneNormal response = max(cosine, 0.0);
  #endif // TONE_MODEL
  #if TONE_MODEL == TONE_MODEL_PHONG
    // R·V of Phong's model; R is the light direction mirrored at the normal.
    PerToneNormal mirrored =
      2.0 * cosine * cosines(toViewer, surface.normals) - dot(light.direction, toViewer);
    response += step(0.0, cosine) * pow(max(mirrored, 1e-6), PerToneNormal(shininess));
  #endif // TONE_MODEL
  PerToneNormal arriving = luminance(light.color) * RECIPROCAL_PI * response;
  #ifdef SEPARATES_SHADOWS
    surface.shadowed += (1.0 - lightShadow) * arriving;
    #ifdef SHADOWS_ALONG_STROKES
      sent[lightsVisited] = vec2(1.0, lightShadow) * arriving;
    #endif // SHADOWS_ALONG_STROKES
    arriving *= lightShadow;
    #ifdef DISSOLVES_SHADOWS
      float takes = luminance(light.color) * max(dot(light.direction, surface.smoothNormal), 0.0) * (1.0 - lightShadow);
      shadowTaken += takes;
      shadowLost += takes * (1.0 - toneLeft[lightsVisited]);
    #endif // DISSOLVES_SHADOWS
    #ifdef REORIENTS_IN_SHADOW
      float taken = max(dot(light.direction, surface.smoothNormal), 0.0) * (1.0 - 2.0 * lightShadow);
      isLightShadowed[lightsVisited] = taken > LEAST_RESPONSE;
      lightSent += luminance(light.color);
      lightTaken += luminance(light.color) * taken;
    #endif // REORIENTS_IN_SHADOW
    lightShadow = 1.0;
    lightsVisited++;
  #endif // SEPARATES_SHADOWS
  surface.radiance += arriving;
}
// three.js also passes arguments for its own materials. One is named reflectedLight, and does not exist here.
#define RE_Direct(light, at, normal, toViewer, clearcoat, surface, sum) addDirectRadiance(light, toViewer, surface)

void occludeLights(inout HatchingSurface surface) {
  float open = openToLights();
  surface.radiance *= open;
  surface.shadowed *= open;
}

float indirectRadiance(const in vec3 n) {
  vec3 irradiance = getAmbientLightIrradiance(ambientLightColor);
  #ifdef USE_LIGHT_PROBES
    irradiance += getLightProbeIrradiance(lightProbe, n);
  #endif // USE_LIGHT_PROBES
  #define VISIT_LIGHT(source, number) irradiance += getHemisphereLightIrradiance(source, n);
  #include "eachSky"
  #ifdef ENVIRONMENT
    irradiance += environmentIrradiance(n);
  #endif // ENVIRONMENT
  return luminance(irradiance) * RECIPROCAL_PI;
}

void addIndirectRadiance(inout HatchingSurface surface) {
  PerToneNormal radiance = indirectRadiance(surface.normals);
  #ifdef USE_LIGHTMAP
    radiance += lightMapIntensity * luminance(texture2D(lightMap, vLightMapUv).rgb) * RECIPROCAL_PI;
  #endif // USE_LIGHTMAP
  #ifdef USE_AOMAP
    radiance *= 1.0 - aoMapIntensity * (1.0 - texture2D(aoMap, vAoMapUv).r);
  #endif // USE_AOMAP
  surface.radiance += openToSky() * radiance;
}

// Adds the light of one source that the surroundings reflect. They act as a sky of that light on the opposite side, so that shade is
// darkest at the terminator and opens up behind it (an engraver's reflected light). Planes get more of it on the side that they turn to the
// light.
void addReflection(const in vec3 toLight, const in vec3 color, inout HatchingSurface surface) {
  PerToneNormal seen = 0.5 - 0.5 * cosines(toLight, surface.normals);
  if (surface.plane > 0.0) {
    vec3 side = safeNormalize(cross(toLight, mat3(viewMatrix) * SIDE_AXIS));
    seen += surface.plane * BESIDE_LIGHT * max(seen - BESIDE_FROM, 0.0) * max(cosines(side, surface.normals), 0.0);
  }
  surface.radiance += openToSky() * reflectedLight * luminance(color) * RECIPROCAL_PI * seen;
}

// The same for a positional light, regardless of its cone and its shadow.
void addReflection(
  const in vec3 toLight, const in vec3 color, const in float range, const in float decay, inout HatchingSurface surface
) {
  addReflection(normalize(toLight), getDistanceAttenuation(length(toLight), range, decay) * color, surface);
}

void addReflectedRadiance(const in vec3 viewPosition, inout HatchingSurface surface) {
  if (reflectedLight == 0.0) return;
  #define VISIT_LIGHT(source, number) addReflection(source.direction, source.color, surface);
  #include "eachDistantLight"
  #define VISIT_LIGHT(source, number) addReflection(source.position - viewPosition, source.color, source.distance, source.decay, surface);
  #include "eachPositionalLight"
}
