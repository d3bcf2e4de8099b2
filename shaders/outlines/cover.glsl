// The screen triangle that covers a piece of outline.
uniform float objectScale; // view units per object unit, the mean over directions
#ifdef WOBBLE
  uniform float wobble; // pixels
#endif // WOBBLE

// Margin for the antialiased edge, pixels.
#define FRINGE 1.0

// Half widths before paper and before a surface, pixels, without the factor of fading. spacing: the distance of the lines there, pixels.
vec2 halfWidthsAt(const in PieceEnd end, const in float spacing) {
  vec2 weights = vec2(end.weight, end.innerWeight);
  #ifdef HIDDEN
    weights = vec2(hiddenWeight(max(weights.x, weights.y)));
  #endif // HIDDEN
  return 0.5 * min(outlineWidth * weights, max(CROWDED_SHARE * spacing - LEAST_WIDTH * outlineWidth, 0.0));
}

// View units per pixel at a point.
float unitsToPixel(const in vec3 position) {
  float away = isOrthographic ? 1.0 : max(-position.z, nearDistance);
  return 2.0 * away / (abs(projectionMatrix[1][1]) * viewport.w);
}

vec2 pixelOf(const in vec4 clip) {
  return viewport.xy + (0.5 * clip.xy / clip.w + 0.5) * viewport.zw;
}

// A factor on the near distance: just behind the near plane.
#define BEHIND_NEAR 1.0001

// Clips an end to the near plane, along the piece.
void cutAt(const in float z, inout vec3 place, inout PieceEnd cut, const in vec3 otherPlace, const in PieceEnd other) {
  float t = (z - place.z) / (otherPlace.z - place.z);
  place = mix(place, otherPlace, t);
  cut.weight = mix(cut.weight, other.weight, t);
  cut.innerWeight = mix(cut.innerWeight, other.innerWeight, t);
  cut.anchor = mix(cut.anchor, other.anchor, t);
  cut.overshoot = 0.0;
}

// Writes the position and the varyings of one corner of the triangle. spacing: the distance of the lines there, object units.
void coverPiece(const in Piece piece, const in float spacing, const in int corner) {
  float scale = objectScale;
  #ifdef USE_INSTANCING
    scale *= pow(abs(determinant(mat3(instancePlace))), 1.0 / 3.0);
  #endif // USE_INSTANCING
  PieceEnd from = piece.start;
  PieceEnd to = piece.end;
  #ifdef HIDDEN
    from.overshoot = 0.0;
    to.overshoot = 0.0;
  #endif // HIDDEN
  vec3 start = (objectToView() * vec4(from.position, 1.0)).xyz;
  vec3 end = (objectToView() * vec4(to.position, 1.0)).xyz;

  // Points before the near plane cannot be projected.
  if (!isOrthographic) {
    float z = -BEHIND_NEAR * nearDistance;
    if (min(start.z, end.z) > z) return;
    if (start.z > z) cutAt(z, start, from, end, to);
    else if (end.z > z) cutAt(z, end, to, start, from);
  }

  vec2 pixels = vec2(unitsToPixel(start), unitsToPixel(end));
  vec2 halfStart = halfWidthsAt(from, spacing * scale / pixels.x);
  vec2 halfEnd = halfWidthsAt(to, spacing * scale / pixels.y);
  if (halfStart + halfEnd == vec2(0.0)) return;
  vec2 halves = vec2(max(halfStart.x, halfStart.y), max(halfEnd.x, halfEnd.y)) * (1.0 + accents * piece.contour);
  vec3 nearStart = lifted(start, liftOf(from, piece, halves.x * pixels.x, pixels.x, scale));
  vec3 nearEnd = lifted(end, liftOf(to, piece, halves.y * pixels.y, pixels.y, scale));
  vec4 clipStart = projectionMatrix * vec4(nearStart, 1.0);
  vec4 clipEnd = projectionMatrix * vec4(nearEnd, 1.0);
  vec2 a = pixelOf(projectionMatrix * vec4(start, 1.0));
  vec2 b = pixelOf(projectionMatrix * vec4(end, 1.0));
  vec2 depths = vec2(clipStart.z / clipStart.w, clipEnd.z / clipEnd.w);

  float size = distance(a, b);
  vec2 along = size > 1e-4 ? (b - a) / size : vec2(1.0, 0.0);
  float slope = (depths.y - depths.x) / max(size, FRINGE);
  float middleDepth = 0.5 * (depths.x + depths.y);
  vec2 middle = 0.5 * (a + b);

  vEnds = vec4(a, b);
  vHalfWidths = vec4(halfStart.x, halfEnd.x, halfStart.y, halfEnd.y);
  vStart = vec4(start, -nearStart.z);
  vEnd = vec4(end, -nearEnd.z);
  vOvershoots = vec2(from.overshoot, to.overshoot);
  vContour = piece.contour;
  vTolerance = toleranceOf(piece, max(pixels.x, pixels.y), scale);
  vLineWeights = piece.contour > 0.0 ? vec4(-1.0) : vec4(1.0, 0.0, 1.0, 0.0);
  #ifdef HIDDEN
    vLineWeights = vec4(1.0, 0.0, 1.0, 0.0);
    vec4 origin = projectionMatrix * objectToView() * vec4(0.0, 0.0, 0.0, 1.0);
    vOrigin = pixelOf(vec4(origin.xyz, max(origin.w, 1e-3)));
  #endif // HIDDEN
  if (hasSceneDepth && size < SHORT) {
    Spine spine = Spine(a, along, size);
    // Wholly hidden pieces are skipped here, to save the tests of their fragments; for hidden outlines, wholly visible ones.
    bvec3 seen = bvec3(isSeen(spine, a), isSeen(spine, middle), isSeen(spine, b));
    #ifdef HIDDEN
      if (all(seen)) return;
    #else
      if (!any(seen)) return;
    #endif // HIDDEN
    if (vLineWeights.x < 0.0) {
      vLineWeights.xy = lineWeightAt(spine, a, max(halfStart.x, halfStart.y));
      vLineWeights.zw = lineWeightAt(spine, b, max(halfEnd.x, halfEnd.y));
    }
  }

  float reach = max(mostOutlineFading() * max(halves.x, halves.y), 0.5) + FRINGE;
  #ifdef WOBBLE
    reach += wobble;
    vAnchorStart = from.anchor;
    vAnchorEnd = to.anchor;
  #endif // WOBBLE
  // A right triangle around the bounding rectangle of the capsule: its right angle lies at a corner, and its legs are twice the sides.
  float reachAlong = 0.5 * size + reach + max(from.overshoot, to.overshoot);
  vec2 local = corner == 0 ? vec2(-reachAlong, -reach) : corner == 1 ? vec2(3.0 * reachAlong, -reach) : vec2(-reachAlong, 3.0 * reach);
  vec2 pixel = middle + local.x * along + local.y * vec2(-along.y, along.x);
  gl_Position = vec4(2.0 * (pixel - viewport.xy) / viewport.zw - 1.0, middleDepth + slope * local.x, 1.0);
}
