float crossingOf(const in HatchingParameters h) {
  return h.crossing;
}

// The same place in the second layer, whose strokes run along the other direction of the tensor: all turned by 90°.
HatchingParameters secondLayer(const in HatchingParameters h) {
  HatchingParameters second = h;
  second.point = h.point + LAYER_SHIFT * anchorSpacing / strokeScale;
  second.uAxis = -h.vAxis;
  second.vAxis = h.uAxis;
  second.lean = vec3(-h.lean.y, h.lean.x, h.lean.z);
  return second;
}
