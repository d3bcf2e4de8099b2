// Light-oriented hatching after Suarez, Belhadj and Boyer, "GPU real time hatching", 2013: the fragment shader stage. Includes of
// "technique/…", here and in chunks, come from the folder of the material's technique.
#include "conventions"
#include "smoothNormal"
#include "strokeLayers"
#include "technique/varyings"

uniform vec3 diffuse;
uniform vec3 emissive;
uniform float emissiveIntensity;
uniform float opacity;
uniform float inked; // 0 while strokes have no map

varying vec3 vViewPosition;
#include "occlusion"
#include "plainColor"

#include <common>
#include "packing"
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include "mapCoordinates"
#include "mapTransforms"
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include "shadowMaps"
#if defined(USE_SHADOWMAP) && defined(DOUBLE_SIDED)
  #include "shadowMatrices"
#endif // USE_SHADOWMAP
#include "strokeShadows"
#include "shadows"
#include "softShadows"
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>

#include "safeNormalize"
#include "technique/read"
#include "toneNormals"
#include "occlude"
#include "radiance"
#include "lightness"
#include "tone"
#include "localColor"
#include "technique/faded"
#include "hatch"
#include "shadowStrokes"
#include "printedColor"
#include "debugViews"

void main() {
  vec4 diffuseColor = vec4(diffuse, opacity);
  #include <clipping_planes_fragment>
  #include <logdepthbuf_fragment>
  #include <color_fragment>
  vec3 plainColor = diffuseColor.rgb;
  #include <map_fragment>
  vec3 toned = tonedColor(plainColor, diffuseColor.rgb);
  #include <alphamap_fragment>

  vec3 totalEmissiveRadiance = emissiveIntensity * emissive;
  #include <emissivemap_fragment>

  #ifdef PLAIN_COLOR
    float darkness = vDarkness;
  #else
    float darkness = localDarkness(toned, totalEmissiveRadiance);
  #endif // PLAIN_COLOR

  #include <normal_fragment_begin>
  #if TONE_NORMAL == TONE_NORMAL_SMOOTH
    #include <normal_fragment_maps>
  #endif // TONE_NORMAL
  HatchingSurface material = HatchingSurface(
    normal, readToneNormals(normal, faceDirection), PerToneNormal(0.0), PerToneNormal(0.0),
    darkness, planeness(normal)
  );
  #ifdef DISSOLVES_SHADOWS
    readSoftShadows(-vViewPosition);
  #endif // DISSOLVES_SHADOWS
  #include "turnShadows"
  #include <lights_fragment_begin>
  occludeLights(material);
  addIndirectRadiance(material);
  addReflectedRadiance(geometryPosition, material);
  material.radiance += luminance(totalEmissiveRadiance);
  computeFading();
  PerToneNormal tone = faded(shadedTone(material));
  HatchingParameters parameters = readHatchingParameters();
  // For frames per vertex; frames per fragment depend on the shadows already.
  #ifdef TURNS_IN_SHADOW
    parameters = turnedInShadow(parameters);
  #endif // TURNS_IN_SHADOW

  vec3 ground = paper * fadedColor(filledColor(diffuseColor.rgb));
  vec4 printed = printedColor(ground, inked * hatchInShadow(parameters, tone, material));
  diffuseColor.a *= printed.a;
  #include <alphatest_fragment>
  #include <alphahash_fragment>
  vec3 outgoingLight = debugView(printed.rgb, parameters, tone);

  #include <opaque_fragment>
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #include <fog_fragment>
  #include <premultiplied_alpha_fragment>
  #include <dithering_fragment>
}
