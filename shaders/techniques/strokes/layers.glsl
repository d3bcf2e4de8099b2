float crossingOf(const in HatchingParameters h) {
  return h.crossing;
}

// The same place in another layer, whose strokes are turned. turn: cosine and sine of the angle.
HatchingParameters turnedLayer(const in HatchingParameters h, const in float layer, const in vec2 turn) {
  HatchingParameters turned = h;
  turned.point = h.point + layer * LAYER_SHIFT * latticeSpacing / tilesPerObjectUnit;
  turned.uAxis = turn.x * h.uAxis - turn.y * h.vAxis;
  turned.vAxis = turn.y * h.uAxis + turn.x * h.vAxis;
  #if TECHNIQUE != TECHNIQUE_STIPPLE
    turned.lean = vec3(turn.x * h.lean.x - turn.y * h.lean.y, turn.y * h.lean.x + turn.x * h.lean.y, h.lean.z);
  #endif // TECHNIQUE
  return turned;
}
