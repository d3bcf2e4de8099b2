// The light that passes a shadow map to a point, and the share of its shadow's tone that is left. SHADOW_MAP: the type of the map.
//
// A comparison sampler only tells whether an occluder lies before a depth. So the map is sampled at rings around the point, from narrow to
// wide, within a cone from the point to the lamp or somewhat beyond. Where one is dark, bisection finds the distance of the occluder, and
// the width of the cone there is that of the soft edge.
vec2 shadowSearch(SHADOW_MAP map, const in ShadowMapFacts facts, const in Rays rays) {
  float opening = 0.5 * shadowSoftness;
  float texel = rays.width / facts.texels;
  float lift = LIFT * texel;
  float thinnest = max(facts.radius, THINNEST) * texel;
  vec4 darkPlace = rays.at;
  float middle = passes(map, facts, darkPlace, depthAlong(rays, lift));
  float darkest = middle;
  float lit = middle;
  // Occluders lie no farther away than the lamp. Near a lamp the cone widens fast on the map.
  float farthest = min(rays.farthest, TOWARDS_LAMP / max(rays.nearing, 1e-6));
  float opened = farthest / (1.0 - rays.nearing * farthest) / 27.0;
  vec2 way = vec2(1.0, 0.0);
  for (int i = 0; i < 4; i++) {
    float ring = opened / (1.0 + rays.nearing * opened);
    vec4 centre = rays.at + ring * rays.towards;
    vec4 aside = rays.across * (max(opening * ring, thinnest) * way);
    vec4 beside = rays.across * (max(opening * ring, thinnest) * vec2(-way.y, way.x));
    float depth = depthAlong(rays, max(WITHIN * ring, lift));
    vec4 there = vec4(
      passes(map, facts, centre + aside, depth), passes(map, facts, centre - aside, depth),
      passes(map, facts, centre + beside, depth), passes(map, facts, centre - beside, depth)
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
    if (passes(map, facts, darkPlace, depthAlong(rays, max(caster + span, lift))) < most) caster += span;
    span *= 0.5;
  }
  // The last step is never taken: at the greatest distance the shadow has dissolved.
  float left = max(1.0 - shadowFade * caster / (rays.width * (1.0 - LAST_STEP)), 0.0);
  if (lit < 1e-3 || left == 0.0 || shadowSoftness == 0.0) return vec2(min(lit, 1.0), left);
  // Samples all over the cone in a sunflower pattern, outermost first. Occluders nearer than the one found hide the lamp too.
  caster += span;
  float edge = max(opening * caster, thinnest);
  vec4 centre = rays.at + caster * rays.towards;
  float open = 0.0;
  for (int i = 0; i < EDGE_SAMPLES; i++) {
    // A rim as dark as the middle means no edge.
    if (i == RIM_SAMPLES && open + middle < 1e-3) return vec2(0.0, left);
    float outward = sqrt((float(EDGE_SAMPLES - i) - 0.5) / float(EDGE_SAMPLES));
    open += passes(map, facts, centre + rays.across * (edge * outward * way), depthAlong(rays, max(WITHIN * outward * caster, lift)));
    way = vec2(-0.73736888 * way.x - 0.67549029 * way.y, 0.67549029 * way.x - 0.73736888 * way.y);
  }
  return vec2(open / float(EDGE_SAMPLES), left);
}
#undef SHADOW_MAP
