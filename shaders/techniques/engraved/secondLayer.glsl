// Lines cross by tone and not by disagreeing lights: there is nothing for a second layer to do.
float crossingOf(const in HatchingParameters h) {
  return 0.0;
}

HatchingParameters secondLayer(const in HatchingParameters h) {
  return h;
}
