// Which outlines are seen, and how much they weigh by what lies behind them. A piece of outline is judged at its spine, the place
// on it that is nearest to a pixel ("Two fast methods for high-quality line visibility", Cole and Finkelstein, 2010), so that an
// outline is seen over its whole width or not at all.
uniform float outlineWidth; // pixels
uniform float accents; // how much heavier an outline becomes where it passes before another
uniform bool isDrawnBefore; // whether surfaces that lie nearer do not hide it
uniform bool isCutOut; // whether parts of its surface are not drawn

// Pieces that are no longer than this are judged at their ends, for fragments to share, and others in each fragment, pixels.
#define SHORT 16.0

struct Spine {
  vec2 start; // pixels
  vec2 along; // unit
  float size; // pixels
};

// Of a place between the ends on the screen the place between them in space: of an outline that runs away from the eye, the
// nearer half takes more of the screen.
float alongLine(const in float t) {
  return isOrthographic ? t : t * vStart.z / mix(vEnd.z, vStart.z, t);
}

float spineDepth(const in Spine spine, const in vec2 pixel) {
  // A little further than the ends: so far from them, texels may lie.
  float t = clamp(dot(pixel - spine.start, spine.along) / max(spine.size, 1e-3), -0.25, 1.25);
  return mix(-vStart.z, -vEnd.z, alongLine(t));
}

// How far behind the outline that surface lies which is seen in a pixel.
float gapAt(const in Spine spine, const in vec2 pixel) {
  vec2 texel = floor(pixel) + 0.5;
  return min(depthAt(texel) - spineDepth(spine, texel), NOWHERE);
}

bool isSeen(const in Spine spine, const in vec2 place) {
  if (isDrawnBefore) return true;
  vec2 beside = BESIDE * vec2(-spine.along.y, spine.along.x);
  if (!isInView(place + beside) || !isInView(place - beside)) return true;
  return max(gapAt(spine, place + beside), gapAt(spine, place - beside)) >= -vTolerance;
}

// Whether the surface is not there, on neither side of a place: both show what lies behind it.
bool isCutAway(const in Spine spine, const in vec2 place) {
  if (!isCutOut) return false;
  vec2 beside = BESIDE * vec2(-spine.along.y, spine.along.x);
  float pixel = viewHeightAt(spineDepth(spine, place)) / viewport.w;
  return min(gapAt(spine, place + beside), gapAt(spine, place - beside)) > vTolerance + CUT_SLOPE * pixel;
}

// Whether what lies so far behind, as a share of the height of the view, is as good as paper.
float paperness(const in float gap) {
  return smoothstep(BEGINS_AS_PAPER, IS_PAPER, gap);
}

// The standing of an outline at a place on its spine: the share of paper in what lies behind it, and of an accent. halfWidth: the most.
vec2 standingAt(const in Spine spine, const in vec2 place, const in float halfWidth) {
  float height = viewHeightAt(spineDepth(spine, place));
  vec2 beside = (halfWidth + BEYOND) * vec2(-spine.along.y, spine.along.x);
  float left = gapAt(spine, place + beside);
  float right = gapAt(spine, place - beside);
  vec2 outside = place + (left > right ? beside : -beside);
  float here = min(max(left, right) / height, 1.0);

  // Along the outline: the weight changes gradually where what lies behind it does, and an accent grows towards that place.
  float paper = paperness(here);
  float sum = 1.0;
  float accent = 0.0;
  float stride = ACCENT_REACH * outlineWidth / float(ACCENT_STEPS);
  for (int side = -1; side <= 1; side += 2) {
    float last = here;
    for (int i = 1; i <= ACCENT_STEPS; i++) {
      vec2 there = outside + float(side * i) * stride * spine.along;
      float gap = min(gapAt(spine, there) / height, 1.0);
      if (min(gap, last) < LEAST_JUMP || !isInView(there)) break;
      float nearness = 1.0 - (float(i) - 0.5) / float(ACCENT_STEPS);
      accent = max(accent, nearness * smoothstep(LEAST_JUMP, FULL_JUMP, abs(gap - last)));
      paper += nearness * paperness(gap);
      sum += nearness;
      last = gap;
    }
  }
  return vec2(paper / sum, accent);
}

// Half the width at a place. halves: before the paper, and before a surface.
float halfWidthAs(const in vec2 standing, const in vec2 halves) {
  return mix(halves.y, halves.x, standing.x) * (1.0 + vContour * accents * standing.y);
}
