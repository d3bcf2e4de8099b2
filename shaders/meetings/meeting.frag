// Lines where parts meet that move: the main function of the fragment shader stage of outlines. Two parts that are seen in neighbouring pixels
// meet between them where the plane of each, continued to the pixel of the other, lies behind that. A part that is seen through meets what is
// seen in its pixel where their planes cut each other.
uniform highp usampler2D partMap;
uniform float partLook; // number of the material of these outlines
uniform float intersections; // weight
uniform vec2 shadeWeights; // on the lit side, on the shaded side

varying vec3 vMeetingLight;
#ifdef CLEAR
  varying float vPartNumber;
  varying vec3 vPartPlace;
#endif // CLEAR

// Most pixels from a line at which it is drawn.
#define MOST_REACH 4
// Sine of the angle between two faces, some 15°, below which they have no line: panels that nearly touch.
#define LEAST_CROSSING 0.26
// Cosine between a normal and the line of sight, some 78°, below which a surface counts as one that turns away, and may not reach the other.
#define TURNS_AWAY 0.2
// Pixels by which a surface may be steeper than its plane says before something else hides it.
#define STEEPER 2.0
// Share of a distance that is lost in rounding.
#define LOST_DEPTH 1e-4

struct Part {
  uint number;
  float nearness; // inverse distance; of an orthographic camera the distance, negated
  vec2 slope; // of the nearness, per pixel
};

Part partIn(const in uvec4 word) {
  return Part(word.x & 0xffffu, uintBitsToFloat(word.y), uintBitsToFloat(word.zw));
}

vec2 perUnit() {
  return vec2(projectionMatrix[0][0], projectionMatrix[1][1]);
}

vec2 onSheetPlane(const in vec2 pixel) {
  return 2.0 * (pixel - viewport.xy) / viewport.zw - 1.0;
}

// Direction of the line of sight through a pixel, at a depth of 1.
vec2 rayAt(const in vec2 pixel) {
  return (onSheetPlane(pixel) + projectionMatrix[2].xy) / perUnit();
}

// Unit, towards the eye, view space.
vec3 normalOf(const in Part part, const in vec2 pixel) {
  vec2 slope = 0.5 * part.slope * viewport.zw * perUnit();
  if (isOrthographic) return normalize(vec3(-slope, 1.0));
  return -normalize(vec3(slope, dot(slope, rayAt(pixel)) - part.nearness));
}

vec3 placeOf(const in Part part, const in vec2 pixel) {
  if (isOrthographic) return vec3((onSheetPlane(pixel) - projectionMatrix[3].xy) / perUnit(), part.nearness);
  return vec3(rayAt(pixel), -1.0) / part.nearness;
}

void main() {
  vec2 pixel = gl_FragCoord.xy;
  ivec2 texel = ivec2(pixel - viewport.xy);
  uvec4 word = texelFetch(partMap, texel, 0);
  #ifdef CLEAR
    float nearness = isOrthographic ? vPartPlace.z : -1.0 / vPartPlace.z;
    Part own = Part(uint(vPartNumber + 0.5) % 0xffffu + 1u, nearness, vec2(dFdx(nearness), dFdy(nearness)));
  #else
    if (word.x >> 16 != uint(partLook + 0.5)) discard;
    Part own = partIn(word);
  #endif // CLEAR
  vec3 ownNormal = normalOf(own, pixel);
  vec3 place = placeOf(own, pixel);
  vec3 sight = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-place);
  #ifndef CLEAR
    if (dot(ownNormal, sight) < TURNS_AWAY) discard;
  #endif // CLEAR
  float width = 0.5 * outlineWidth * intersections * outlineFadingAt(place, pixel);
  float away = NOWHERE;
  vec3 normal = ownNormal;
  #ifdef CLEAR
    Part other = partIn(word);
    vec3 otherNormal = normalOf(other, pixel);
    bool isSeen = other.number != 0u && other.number != own.number && dot(otherNormal, sight) >= TURNS_AWAY;
    if (isSeen && length(cross(ownNormal, otherNormal)) >= LEAST_CROSSING) {
      away = abs(own.nearness - other.nearness) / max(length(own.slope - other.slope), 1e-30);
      normal = ownNormal + otherNormal;
    }
  #else
    int reach = min(int(ceil(max(width * max(shadeWeights.x, shadeWeights.y), 0.5) + 0.5)), MOST_REACH);
    for (int y = -reach; y <= reach; y++) {
      for (int x = -reach; x <= reach; x++) {
        ivec2 there = texel + ivec2(x, y);
        if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, textureSize(partMap, 0)))) continue;
        Part other = partIn(texelFetch(partMap, there, 0));
        if (other.number == 0u || other.number == own.number) continue;
        vec2 way = vec2(x, y);
        float before = own.nearness - other.nearness + dot(other.slope, way);
        float beyond = own.nearness - other.nearness + dot(own.slope, way);
        float distanceTo = before / max(length(own.slope - other.slope), 1e-30);
        if (before < 0.0 || beyond > 0.0 || distanceTo >= away) continue;
        vec3 otherNormal = normalOf(other, pixel + way);
        if (dot(otherNormal, sight) < TURNS_AWAY || length(cross(ownNormal, otherNormal)) < LEAST_CROSSING) continue;
        away = distanceTo;
        normal = ownNormal + otherNormal;
      }
    }
  #endif // CLEAR
  if (away == NOWHERE) discard;
  float depth = -place.z;
  #if defined(CLEAR) && NUM_CLIPPING_PLANES > 0
    vec3 vClipPosition = -place;
  #endif // defined(CLEAR) && NUM_CLIPPING_PLANES > 0
  #ifdef CLEAR
    #include <clipping_planes_fragment>
  #endif // CLEAR
  if (hasSceneDepth && !isDrawnBefore) {
    float steep = length(own.slope) * (isOrthographic ? 1.0 : depth * depth);
    if (depthAt(pixel) < depth - STEEPER * steep - LOST_DEPTH * abs(depth)) discard;
  }

  float halfWidth =
    width * mix(shadeWeights.x, shadeWeights.y, smoothstep(LIT, SHADED, 0.5 - 0.5 * dot(normalize(normal), vMeetingLight)));
  float coverage = lineCoverage(away, halfWidth, 0.5);
  #ifdef PAPER_GRAIN
    coverage *= dryInk(min(away / max(halfWidth, 0.5), 1.0), 1.0);
  #endif // PAPER_GRAIN
  vec4 diffuseColor = vec4(ink, opacity * coverage);
  if (diffuseColor.a < 0.002) discard;

  gl_FragColor = diffuseColor;
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #ifdef USE_FOG
    float vFogDepth = depth;
  #endif // USE_FOG
  #include <fog_fragment>
  #include <premultiplied_alpha_fragment>
  #include <dithering_fragment>
}
