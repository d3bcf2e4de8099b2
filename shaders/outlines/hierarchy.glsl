// The visibility of outlines, and their weight by what lies behind them. Tests are made at the spine, at the point nearest to a pixel ("Two
// fast methods for high-quality line visibility", Cole and Finkelstein, 2010), so that an outline is visible over its whole width or not at
// all.
uniform float outlineWidth; // pixels
uniform float accents; // factor on the width where an outline passes before another, minus 1
uniform bool isDrawnBefore; // whether nearer surfaces do not hide the outline
uniform bool isCutOut; // whether parts of the surface are cut out

// Longest piece, in pixels, that is tested at its ends; longer ones are tested per fragment.
#define SHORT 16.0

struct Spine {
  vec2 start; // pixels
  vec2 along; // unit
  float size; // pixels
};

// Perspective-correct interpolation along a line: the share in space at a share on the screen.
float alongLine(const in float t) {
  return isOrthographic ? t : t * vStart.z / mix(vEnd.z, vStart.z, t);
}

float spineDepth(const in Spine spine, const in vec2 pixel) {
  // A little beyond the ends, where the texels of their pixels may lie.
  float t = clamp(dot(pixel - spine.start, spine.along) / max(spine.size, 1e-3), -0.25, 1.25);
  return mix(-vStart.z, -vEnd.z, alongLine(t));
}

// The distance from the outline back to the surface that is visible in a pixel.
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

// Whether the outline's own surface is cut out at a point: both sides show what lies behind.
bool isCutAway(const in Spine spine, const in vec2 place) {
  if (!isCutOut) return false;
  vec2 beside = BESIDE * vec2(-spine.along.y, spine.along.x);
  float pixel = viewHeightAt(spineDepth(spine, place)) / viewport.w;
  return min(gapAt(spine, place + beside), gapAt(spine, place - beside)) > vTolerance + CUT_SLOPE * pixel;
}

// The share to which a surface counts as paper. gap: its distance behind the outline, as a share of the height of the view.
float paperness(const in float gap) {
  return smoothstep(BEGINS_AS_PAPER, IS_PAPER, gap);
}

// The share of paper in what lies behind an outline at a point on its spine, and the share of an accent.
vec2 lineWeightAt(const in Spine spine, const in vec2 place, const in float halfWidth) {
  float height = viewHeightAt(spineDepth(spine, place));
  vec2 beside = (halfWidth + BEYOND) * vec2(-spine.along.y, spine.along.x);
  float left = gapAt(spine, place + beside);
  float right = gapAt(spine, place - beside);
  vec2 outside = place + (left > right ? beside : -beside);
  float here = min(max(left, right) / height, 1.0);

  // Along the outline the weight changes gradually with what lies behind it, and an accent grows towards such a change.
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

// Half the width at a point. halves: before paper, and before a surface.
float halfWidthAs(const in vec2 lineWeight, const in vec2 halves) {
  return mix(halves.y, halves.x, lineWeight.x) * (1.0 + vContour * accents * lineWeight.y);
}
