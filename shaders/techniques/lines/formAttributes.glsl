// The baked functions of lines that follow the form (src/mesh/bake/attributeLayouts.ts).
attribute vec2 formValue;
attribute vec4 formSlope;
attribute vec4 formCrossing;

// slope: a gradient in object space, as packed. place: field space.
vec4 formVarying(const in vec4 slope, const in float value, const in mat3 toField, const in vec3 place) {
  vec3 gradient = toField * slope.xyz * exp2(round(32767.0 * slope.w));
  return vec4(gradient, value - 0.5 * dot(gradient, place));
}
