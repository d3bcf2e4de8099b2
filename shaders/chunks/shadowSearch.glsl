// The end of a function that tells of a shadow at a point: how much light passes, and how much of the tone is left.
//
// PLACE(distance): where the ray to the middle of the lamp is at a distance, as the map has it, and `across` how it changes to either side.
// DEPTH(distance): the depth there. PASSES(place, depth): how much passes what lies beyond a depth, where the map shows a place.
//
// A sampler that compares does not tell the depth of what casts a shadow, only whether that lies before a depth. So the map is asked at
// rings around the point, from narrow to wide: they lie within a cone whose top is the point and whose base is the lamp, or somewhat
// outside of it. Where one of them is dark, the distance of what casts the shadow is found by halving. As wide as the cone is there, so
// wide is the soft edge.
float opening = 0.5 * shadowSoftness;
float texel = rays.width / texels;
float lift = LIFT * texel;
float thinnest = max(radius, THINNEST) * texel;
MAP_PLACE darkPlace = PLACE(0.0);
float middle = PASSES(darkPlace, DEPTH(lift));
float darkest = middle;
float lit = middle;
// Distances are found up to that of the lamp; a cone to a lamp opens on the map the faster the nearer it comes.
float farthest = min(rays.farthest, TOWARDS_LAMP / max(rays.nearing, 1e-6));
float opened = farthest / (1.0 - rays.nearing * farthest) / 27.0;
vec2 way = vec2(1.0, 0.0);
for (int i = 0; i < 4; i++) {
  float ring = opened / (1.0 + rays.nearing * opened);
  MAP_PLACE centre = PLACE(ring);
  MAP_PLACE aside = across * (max(opening * ring, thinnest) * way);
  MAP_PLACE beside = across * (max(opening * ring, thinnest) * vec2(-way.y, way.x));
  float depth = DEPTH(max(WITHIN * ring, lift));
  vec4 there = vec4(
    PASSES(centre + aside, depth), PASSES(centre - aside, depth), PASSES(centre + beside, depth), PASSES(centre - beside, depth)
  );
  lit += dot(there, vec4(1.0));
  vec2 darker = min(there.xy, there.zw);
  if (min(darker.x, darker.y) < darkest - 1e-3) {
    darkest = min(darker.x, darker.y);
    darkPlace = centre + (there.x == darkest ? aside : there.y == darkest ? -aside : there.z == darkest ? beside : -beside);
  }
  opened *= 3.0;
  way = vec2(way.x - way.y, way.x + way.y) * 0.70710678;
}
if (lit > 16.999) return vec2(1.0);
float most = 0.5 + 0.5 * darkest;
float caster = 0.0;
float span = 0.5 * farthest;
for (int i = 0; i < HALVINGS; i++) {
  if (PASSES(darkPlace, DEPTH(max(caster + span, lift))) < most) caster += span;
  span *= 0.5;
}
// The last step is never taken: what lies as far as is looked for has dissolved.
float left = max(1.0 - shadowFade * caster / (rays.width * (1.0 - LAST_STEP)), 0.0);
if (lit < 1e-3 || left == 0.0 || shadowSoftness == 0.0) return vec2(min(lit, 1.0), left);
// Places all over the cone, as seeds lie in a flower, the outermost first. What lies nearer than the caster hides the lamp too.
caster += span;
float edge = max(opening * caster, thinnest);
MAP_PLACE centre = PLACE(caster);
float open = 0.0;
for (int i = 0; i < EDGE_SAMPLES; i++) {
  // There is no edge if the rim is as dark as the middle.
  if (i == RIM_SAMPLES && open + middle < 1e-3) return vec2(0.0, left);
  float outward = sqrt((float(EDGE_SAMPLES - i) - 0.5) / float(EDGE_SAMPLES));
  open += PASSES(centre + across * (edge * outward * way), DEPTH(max(WITHIN * outward * caster, lift)));
  way = vec2(-0.73736888 * way.x - 0.67549029 * way.y, 0.67549029 * way.x - 0.73736888 * way.y);
}
#undef MAP_PLACE
#undef PLACE
#undef DEPTH
#undef PASSES
return vec2(open / float(EDGE_SAMPLES), left);
