// R: the radiance that a white surface shows under the scene's lights, for the normals of c, α, β, γ at once.
// three's own <lights_fragment_begin> walks the lights and calls RE_Direct with each, shadows included.

uniform float shininess;

struct HatchingSurface {
  mat4x3 normals; // unit, view space
  vec4 radiance;
};

void addDirectRadiance(
  const in IncidentLight light, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, inout HatchingSurface surface,
  inout ReflectedLight reflectedLight
) {
  vec4 cosine = light.direction * surface.normals;
  #if TONE_MODEL == TONE_MODEL_HALF_LAMBERT
    // The terminator moves from 90° to 180°: nothing is lost in flat black.
    vec4 halfway = 0.5 * cosine + 0.5;
    vec4 response = halfway * halfway;
  #else
    vec4 response = max(cosine, 0.0);
  #endif // TONE_MODEL
  #if TONE_MODEL == TONE_MODEL_PHONG
    // R·V of Phong's model, where R is the light mirrored at the normal.
    vec4 mirrored = 2.0 * cosine * (geometryViewDir * surface.normals) - dot(light.direction, geometryViewDir);
    response += step(0.0, cosine) * pow(max(mirrored, 1e-6), vec4(shininess));
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

void addIndirectRadiance(inout HatchingSurface surface) {
  surface.radiance += vec4(
    indirectRadiance(surface.normals[0]), indirectRadiance(surface.normals[1]),
    indirectRadiance(surface.normals[2]), indirectRadiance(surface.normals[3])
  );
}
