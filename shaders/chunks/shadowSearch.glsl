// The end of a function that gives what is left of a shadow at a point. PASSES(distance, away): how much light passes what lies beyond
// that distance, a share of the reach of the shadow, at a place so far from the point in radii of the soft edge.
//
// A sampler that compares does not tell the depth of what casts a shadow, only whether that lies before a depth: the distance is found
// by halving. The outer half of a soft edge lies beside its caster, so what is darkest near the point decides.
vec2 away = vec2(0.0);
float passing = PASSES(0.0, away);
for (int i = 0; i < 4; i++) {
  vec2 corner = vec2(i < 2 ? -1.0 : 1.0, i % 2 == 0 ? -1.0 : 1.0);
  float there = PASSES(0.0, corner);
  if (there < passing - 1e-3) {
    passing = there;
    away = corner;
  }
}
float most = 0.5 + 0.5 * passing;
float before = 0.0;
float span = 0.5;
for (int i = 0; i < HALVINGS; i++) {
  if (PASSES(before + span, away) < most) before += span;
  span *= 0.5;
}
#undef PASSES
return 1.0 - before / (1.0 - LAST_STEP);
