import type { Color, Material } from 'three';
import { mirroredShare } from 'three-hatching/facts';

/** The fields of three's materials that tell metal. */
type Surface = Material & {
  metalness?: number;
  roughness?: number;
  metalnessMap?: unknown;
  roughnessMap?: unknown;
  color?: Color;
  specular?: Color;
  shininess?: number;
  map?: unknown;
};

/** The names by which formats without metalness tell polished metal, and those of metals that may be painted or dull. */
const POLISHED = /chrome|inox|stainless/i;
const METAL = /metal|steel|silver|gold|brass|copper|nickel/i;
/** The specular reflection and the exponent of its highlight from which on such a metal is polished. */
const GLOSS = { specular: 0.3, shininess: 50 };

/** How much of a room a material mirrors, from 0 to 1: smooth metal does. Where a map says what is metal, nothing does. */
export function mirroredBy(surface: Surface): number {
  const { metalness, roughness = 1, name, specular, shininess = 0, map } = surface;
  if (surface.metalnessMap || surface.roughnessMap) return 0;
  if (metalness !== undefined) return mirroredShare({ metalness, roughness });
  if (!specular || map) return 0;
  const isGlossy = Math.max(...specular.toArray()) >= GLOSS.specular && shininess >= GLOSS.shininess;
  return Number(POLISHED.test(name) || (METAL.test(name) && isGlossy));
}

/** The colour of a material: that of metal is what it reflects. */
export function reflectedColor(material: Surface): Color | undefined {
  const { color, specular } = material;
  if (!color || !specular || mirroredBy(material) === 0) return color;
  const [r, g, b] = specular.toArray().map((value, i) => Math.min(Math.max(value, color.toArray()[i]), 1));
  return color.clone().setRGB(r, g, b);
}
