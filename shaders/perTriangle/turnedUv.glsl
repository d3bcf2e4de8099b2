// The same place in another layer, whose strokes are turned. turn: cosine and sine of the angle.
vec2 turnedUv(const in vec2 uv, const in float layer, const in vec2 turn) {
  return vec2(turn.x * uv.x - turn.y * uv.y, turn.y * uv.x + turn.x * uv.y) + layer * LAYER_SHIFT.xy;
}
