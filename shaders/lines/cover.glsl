// From a piece of line to the triangle on the screen that covers it.
uniform float lineWidth; // pixels
uniform vec4 viewport; // x, y, width, height in pixels
uniform float objectScale; // view units per object unit: the mean over directions
uniform float nearDistance;
#ifdef WOBBLE
  uniform float wobble; // pixels
#endif // WOBBLE

// Room for the edge that fades out, in pixels.
#define FRINGE 1.0

void clearVaryings() {
  vEnds = vec4(0.0);
  vHalfWidths = vec2(0.0);
  vStart = vec4(0.0);
  vEnd = vec4(0.0);
  #ifdef WOBBLE
    vAnchorStart = vec3(0.0);
    vAnchorEnd = vec3(0.0);
  #endif // WOBBLE
}

// View units to a pixel at a point.
float unitsToPixel(const in vec3 position) {
  float away = isOrthographic ? 1.0 : max(-position.z, nearDistance);
  return 2.0 * away / (projectionMatrix[1][1] * viewport.w);
}

vec2 pixelOf(const in vec4 clip) {
  return viewport.xy + (0.5 * clip.xy / clip.w + 0.5) * viewport.zw;
}

void coverPiece(const in Piece piece, const in int corner) {
  float scale = objectScale;
  #ifdef USE_INSTANCING
    scale *= pow(abs(determinant(mat3(instancePlace))), 1.0 / 3.0);
  #endif // USE_INSTANCING
  PieceEnd from = piece.start;
  PieceEnd to = piece.end;
  vec3 start = (objectToView() * vec4(from.position, 1.0)).xyz;
  vec3 end = (objectToView() * vec4(to.position, 1.0)).xyz;

  // Cut off what lies before the near plane; it has no place on the screen.
  if (!isOrthographic) {
    float z = -1.0001 * nearDistance;
    if (min(start.z, end.z) > z) return;
    if (start.z > z) {
      float t = (z - start.z) / (end.z - start.z);
      start = mix(start, end, t);
      from.weight = mix(from.weight, to.weight, t);
      from.anchor = mix(from.anchor, to.anchor, t);
      from.overshoot = 0.0;
    } else if (end.z > z) {
      float t = (z - end.z) / (start.z - end.z);
      end = mix(end, start, t);
      to.weight = mix(to.weight, from.weight, t);
      to.anchor = mix(to.anchor, from.anchor, t);
      to.overshoot = 0.0;
    }
  }

  vec2 halves = 0.5 * lineWidth * vec2(from.weight, to.weight);
  vec3 nearStart = lifted(start, liftOf(from, piece, halves.x * unitsToPixel(start), scale));
  vec3 nearEnd = lifted(end, liftOf(to, piece, halves.y * unitsToPixel(end), scale));
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
  a -= from.overshoot * along;
  b += to.overshoot * along;

  float reach = max(max(halves.x, halves.y), 0.5) + FRINGE;
  #ifdef WOBBLE
    reach += wobble;
    vAnchorStart = from.anchor;
    vAnchorEnd = to.anchor;
  #endif // WOBBLE
  // Half of a rectangle around the capsule. Of the triangles that cover it this has its right angle at one corner and twice
  // its sides.
  float reachAlong = 0.5 * size + reach + max(from.overshoot, to.overshoot);
  vec2 local = corner == 0 ? vec2(-reachAlong, -reach) : corner == 1 ? vec2(3.0 * reachAlong, -reach) : vec2(-reachAlong, 3.0 * reach);
  vec2 pixel = middle + local.x * along + local.y * vec2(-along.y, along.x);
  gl_Position = vec4(2.0 * (pixel - viewport.xy) / viewport.zw - 1.0, middleDepth + slope * local.x, 1.0);

  vEnds = vec4(a, b);
  vHalfWidths = halves;
  vStart = vec4(start, -nearStart.z);
  vEnd = vec4(end, -nearEnd.z);
}
