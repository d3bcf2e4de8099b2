// Contours and feature edges: the fragment shader stage. A piece of outline is a capsule on the screen, so that pieces join
// without mitres; its edge fades over one pixel.
#include "conventions"
#include "outlines/conventions"
#include "outlines/varyings"

uniform vec3 ink;
uniform float opacity;
uniform mat4 projectionMatrix;

#include <common>
#include <dithering_pars_fragment>
#include "lineCoverage"
#include "fading"
#include "outlines/surroundings"
#include "outlines/sceneDepth"
#include "outlines/hierarchy"
#ifdef HIDDEN
  #include "outlines/hidden"
#endif // HIDDEN
#ifdef WOBBLE
  #include "outlines/wobble"
#endif // WOBBLE
#ifdef PAPER_GRAIN
  #include "outlines/dryOutline"
#endif // PAPER_GRAIN

void main() {
  vec2 pixel = gl_FragCoord.xy;
  vec2 ends = vEnds.zw - vEnds.xy;
  float size = length(ends);
  Spine spine = Spine(vEnds.xy, size > 1e-4 ? ends / size : vec2(1.0, 0.0), size);
  float place = dot(pixel - spine.start, spine.along);
  #ifdef WOBBLE
    pixel -= wobbleAt(mix(vAnchorStart, vAnchorEnd, alongLine(clamp(place / max(size, 1e-4), 0.0, 1.0))));
    place = dot(pixel - spine.start, spine.along);
  #endif // WOBBLE
  float onSpine = clamp(place, 0.0, size);
  float t = onSpine / max(size, 1e-4);
  float onOutline = clamp(place, -vOvershoots.x, size + vOvershoots.y);
  float away = distance(pixel, spine.start + onOutline * spine.along);

  vec3 viewPosition = mix(vStart.xyz, vEnd.xyz, alongLine(t));
  // Per fragment, not at the ends: an edge may run across the whole sheet.
  vec2 halves = outlineFadingAt(viewPosition, gl_FragCoord.xy) * mix(vHalfWidths.xz, vHalfWidths.yw, t);
  float halfWidth = halves.x;
  if (away > max(max(halves.x, halves.y) * (1.0 + accents), 0.5) + 0.5) discard;
  if (hasSceneDepth) {
    vec2 seen = spine.start + onSpine * spine.along;
    bool isDrawn = isSeen(spine, seen);
    #ifdef HIDDEN
      isDrawn = !isDrawn;
    #endif // HIDDEN
    if (!isDrawn || isCutAway(spine, seen)) discard;
    vec2 lineWeight = mix(vLineWeights.xy, vLineWeights.zw, t);
    if (vLineWeights.x < 0.0) lineWeight = lineWeightAt(spine, seen, max(halves.x, halves.y));
    halfWidth = halfWidthAs(lineWeight, halves);
  }
  // Round ends fill the joints. Their edges lie inside, or two fading edges would add up beside each joint.
  float fringe = place == onOutline ? 0.5 : 0.0;
  float coverage = lineCoverage(away, halfWidth, fringe);
  #ifdef HIDDEN
    coverage *= hiddenCoverage(place, size, spine.along, pixel - vOrigin, outlineWidth);
  #endif // HIDDEN
  #ifdef PAPER_GRAIN
    #ifdef WOBBLE
      float pressed = pressureWave(mix(vAnchorStart, vAnchorEnd, alongLine(t)));
    #else
      float pressed = 1.0;
    #endif // WOBBLE
    // Overlapping ends are narrower, or their soft sides would add up at each joint.
    float across = away / max(halfWidth, 0.5) * (fringe == 0.0 ? 1.6 : 1.0);
    coverage *= dryInk(min(across, 1.0), pressed);
  #endif // PAPER_GRAIN
  vec4 diffuseColor = vec4(ink, opacity * coverage);

  #if NUM_CLIPPING_PLANES > 0
    vec3 vClipPosition = -viewPosition;
  #endif // NUM_CLIPPING_PLANES
  #include <clipping_planes_fragment>
  if (diffuseColor.a < 0.002) discard;
  #ifdef LOGARITHMIC_DEPTH
    float depth = 1.0 / mix(1.0 / vStart.w, 1.0 / vEnd.w, t);
    gl_FragDepth = isOrthographic ? gl_FragCoord.z : log2(1.0 + depth) * logDepthBufFC * 0.5;
  #endif // LOGARITHMIC_DEPTH

  gl_FragColor = diffuseColor;
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #ifdef USE_FOG
    float vFogDepth = -viewPosition.z;
  #endif // USE_FOG
  #include <fog_fragment>
  #include <premultiplied_alpha_fragment>
  #include <dithering_fragment>
}
