// The same place in the second layer, whose strokes run along the other direction of the tensor: all turned by 90°.
vec2 crossedUv(const in vec2 uv) {
  return vec2(-uv.y, uv.x) + LAYER_SHIFT.xy;
}
