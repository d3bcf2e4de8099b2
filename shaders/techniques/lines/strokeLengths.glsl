// The strokes that the lines of a family are drawn in. They begin and end at fixed places on the object, a power of two apart: as the
// camera comes nearer, strokes split into halves.
uniform float strokeLength; // pixels, or 256ths of a tile

// The coordinates of a fragment along the lines of a family: on the two axes of the field along which the lines run most.
struct Along {
  vec3 first, second; // the axes
  vec2 places;
  float share; // of the first axis
  float period; // length of a stroke with its gap
  float longer; // share of strokes twice as long
};

float crossed(const in vec2 a, const in vec2 b) {
  return abs(a.x * b.y - a.y * b.x);
}

Along alongLines(const in HatchingParameters h, const in Family family) {
  vec3 direction = cross(vFieldNormal, family.gradient);
  vec3 squares = direction * direction;
  squares /= max(squares.x + squares.y + squares.z, 1e-20);
  // The axis along which the lines run least is left out.
  vec3 first = vec3(1.0, 0.0, 0.0);
  vec3 second = vec3(0.0, 1.0, 0.0);
  if (squares.x < min(squares.y, squares.z)) first = vec3(0.0, 0.0, 1.0);
  else if (squares.y < squares.z) second = vec3(0.0, 0.0, 1.0);
  Along along;
  along.first = first;
  along.second = second;
  along.places = vec2(dot(first, vFieldPoint), dot(second, vFieldPoint));
  along.share = smoothstep(-AXES_FADE, AXES_FADE, dot(squares, first - second));
  vec2 value = normalize(screenGradient(family.gradient, h.onScreen));
  float perPixel = mix(
    crossed(screenGradient(second, h.onScreen), value), crossed(screenGradient(first, h.onScreen), value), along.share
  );
  float octave = mix(octaves(strokeLength / PARTS_OF_TILE), octaves(strokeLength * max(perPixel, 1e-12)), screenSpaceShare);
  float whole = ceil(octave - 0.5);
  along.period = powerOf2(whole);
  along.longer = smoothstep(1.0 - LENGTHS_FADE, 1.0, octave - whole + 0.5);
  return along;
}

// The amplitude of variation from line to line, as a share of the greatest: less if few lines lie between repeats of their numbers. octave:
// of their spacing.
float differing(const in Family family, const in float octave) {
  return clamp((family.coarsest - octave) / DIFFERING_OCTAVES, LEAST_DIFFERING, 1.0);
}

// The number of a line: the same on both sides of a seam, except for its sign.
float numberOf(const in float line, const in Family family) {
  #ifdef FOLLOWS_FORM
    float repeat = powerOf2(family.coarsest);
    return line - repeat * floor(line / repeat + 0.5);
  #else
    return line;
  #endif // FOLLOWS_FORM
}
