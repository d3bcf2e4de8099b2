// How much weight the drawing has at a place: 1 as usual, 0 none.
uniform vec3 depthFading; // the depths from which and up to which it fades, view units; how strongly

// The air takes the same share of what is left with every stretch of the way: e to this power of it all the way.
#define AIR 3.0
// How much more weight than usual outlines have in front, where the back has none.
#define FRONT_GAIN 0.4

// How much air lies before a place: 0 in front, 1 at the back.
float airBefore(const in vec3 viewPosition) {
  float way = clamp((-viewPosition.z - depthFading.x) / (depthFading.y - depthFading.x), 0.0, 1.0);
  return (1.0 - exp(-AIR * way)) / (1.0 - exp(-AIR));
}

// A factor on the tone.
float emphasisAt(const in vec3 viewPosition) {
  return 1.0 - depthFading.z * airBefore(viewPosition);
}

// A factor on the width of outlines.
float outlineEmphasisAt(const in vec3 viewPosition) {
  return emphasisAt(viewPosition) + FRONT_GAIN * depthFading.z * (1.0 - airBefore(viewPosition));
}
