// The end of a function that returns the light that passes to a point, and the share of its shadow's tone that is left.
//
// PLACE(distance): the position on the map of the point at a distance along the central ray, whose derivatives to both sides are `across`.
// DEPTH(distance): the depth of that point. PASSES(place, depth): the light that passes a depth at a position on the map.
//
// A comparison sampler only tells whether an occluder lies before a depth. So the map is sampled at rings around the point, from narrow to
// wide, within a cone from the point to the lamp or somewhat beyond. Where one is dark, bisection finds the distance of the occluder, and
// the width of the cone there is that of the soft edge.
float opening = 0.5 * shadowSoftness;
float texel = rays.width / texels;
float lift = LIFT * texel;
float thinnest = max(radius, THINNEST) * texel;
MAP_PLACE darkPlace = PLACE(0.0);
float middle = PASSES(darkPlace, DEPTH(lift));
float darkest = middle;
float lit = middle;
// Occluders lie no farther away than the lamp. Near a lamp the cone widens fast on the map.
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
// The last step is never taken: at the greatest distance the shadow has dissolved.
float left = max(1.0 - shadowFade * caster / (rays.width * (1.0 - LAST_STEP)), 0.0);
if (lit < 1e-3 || left == 0.0 || shadowSoftness == 0.0) return vec2(min(lit, 1.0), left);
// Samples all over the cone in a sunflower pattern, outermost first. Occluders nearer than the one found hide the lamp too.
caster += span;
float edge = max(opening * caster, thinnest);
MAP_PLACE centre = PLACE(caster);
float open = 0.0;
for (int i = 0; i < EDGE_SAMPLES; i++) {
  // A rim as dark as the middle means no edge.
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
