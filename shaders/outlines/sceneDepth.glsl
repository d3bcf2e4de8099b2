// The depth of the opaque objects drawn before the outlines (src/material/outlines/SceneDepth.ts).
uniform bool hasSceneDepth;
uniform highp sampler2D sceneDepth;
uniform float nearDistance;
uniform vec4 viewport; // x, y, width, height in pixels

// The define's name in three.js since about 0.180, and its name before.
#if defined(USE_LOGARITHMIC_DEPTH_BUFFER) || defined(USE_LOGDEPTHBUF)
  #define LOGARITHMIC_DEPTH
  uniform float logDepthBufFC;
#endif // USE_LOGARITHMIC_DEPTH_BUFFER

// Farther than anything in a scene.
#define NOWHERE 1e30

float clipDepth(const in float z) {
  return (projectionMatrix[2][2] * z + projectionMatrix[3][2]) / (projectionMatrix[2][3] * z + projectionMatrix[3][3]);
}

// Whether a pixel lies in the view, which may be a tile of a picture. Outside, no depth is known.
bool isInView(const in vec2 pixel) {
  vec2 place = pixel - viewport.xy;
  return all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, viewport.zw));
}

// Distance from the eye to the surface visible in a pixel, or in the nearest pixel of the view; NOWHERE if nothing is drawn there.
float depthAt(const in vec2 pixel) {
  vec2 place = clamp(pixel, viewport.xy, viewport.xy + viewport.zw - 1.0);
  float depth = texelFetch(sceneDepth, ivec2(place), 0).x;
  // A reversed depth is 1 at the near plane.
  bool isReversed = clipDepth(-nearDistance) > 0.0;
  if (isReversed ? depth <= 0.0 : depth >= 1.0) return NOWHERE;
  #ifdef LOGARITHMIC_DEPTH
    if (!isOrthographic) return exp2(2.0 * depth / logDepthBufFC) - 1.0;
  #endif // LOGARITHMIC_DEPTH
  float clip = isReversed ? depth : 2.0 * depth - 1.0;
  return -(projectionMatrix[3][2] - clip * projectionMatrix[3][3]) / (clip * projectionMatrix[2][3] - projectionMatrix[2][2]);
}

// Height of the view at a distance from the eye, view units.
float viewHeightAt(const in float away) {
  return 2.0 * (isOrthographic ? 1.0 : away) / abs(projectionMatrix[1][1]);
}
