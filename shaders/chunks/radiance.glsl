// R: the radiance that a white surface shows under the scene's lights, for each of its tone normals.
// three's own <lights_fragment_begin> walks the lights and calls RE_Direct with each, shadows included.

uniform float shininess;

struct HatchingSurface {
  ToneNormals normals; // unit, view space
  PerToneNormal radiance;
};

float cosines(const in vec3 direction, const in vec3 normal) {
  return dot(direction, normal);
}

vec4 cosines(const in vec3 direction, const in mat4x3 normals) {
  return direction * normals;
}

void addDirectRadiance(
  const in IncidentLight light, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, inout HatchingSurface surface,
  inout ReflectedLight reflectedLight
) {
  PerToneNormal cosine = cosines(light.direction, surface.normals);
  #if TONE_MODEL == TONE_MODEL_HALF_LAMBERT
    // The terminator moves from 90° to 180°: nothing is lost in flat black.
    PerToneNormal halfway = 0.5 * cosine + 0.5;
    PerToneNormal response = halfway * halfway;
  #else
    PerToneNormal response = max(cosine, 0.0);
  #endif // TONE_MODEL
  #if TONE_MODEL == TONE_MODEL_PHONG
    // R·V of Phong's model, where R is the light mirrored at the normal.
    PerToneNormal mirrored =
      2.0 * cosine * cosines(geometryViewDir, surface.normals) - dot(light.direction, geometryViewDir);
    response += step(0.0, cosine) * pow(max(mirrored, 1e-6), PerToneNormal(shininess));
  #endif // TONE_MODEL
  surface.radiance += luminance(light.color) * RECIPROCAL_PI * response;
}
#define RE_Direct addDirectRadiance

float indirectRadiance(const in vec3 n) {
  vec3 irradiance = getAmbientLightIrradiance(ambientLightColor);
  #ifdef USE_LIGHT_PROBES
    irradiance += getLightProbeIrradiance(lightProbe, n);
  #endif // USE_LIGHT_PROBES
  #if NUM_HEMI_LIGHTS > 0
    for (int i = 0; i < NUM_HEMI_LIGHTS; i++) irradiance += getHemisphereLightIrradiance(hemisphereLights[i], n);
  #endif // NUM_HEMI_LIGHTS
  return luminance(irradiance) * RECIPROCAL_PI;
}

vec4 indirectRadiance(const in mat4x3 normals) {
  return vec4(
    indirectRadiance(normals[0]), indirectRadiance(normals[1]), indirectRadiance(normals[2]), indirectRadiance(normals[3])
  );
}

void addIndirectRadiance(inout HatchingSurface surface) {
  surface.radiance += indirectRadiance(surface.normals);
}
