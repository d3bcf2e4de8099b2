import {
  type DepthModes,
  EqualDepth,
  GreaterDepth,
  GreaterEqualDepth,
  type IUniform,
  LessDepth,
  LessEqualDepth,
  type Material,
  NeverDepth,
  NoBlending,
  NormalBlending,
  NotEqualDepth,
} from 'three';

/** The share of the ink that the opacity of a material leaves, by the rules of three.js: what is not blended is opaque. */
export function opacityOf(material: Material): number {
  const { opacity, transparent, blending, alphaHash, alphaTest, alphaToCoverage } = material;
  if (opacity < alphaTest) return 0;
  const isBlended = blending !== NormalBlending && blending !== NoBlending;
  return transparent || alphaHash || alphaToCoverage || isBlended ? Math.min(Math.max(opacity, 0), 1) : 1;
}

/** Whether anything is seen of a surface with this material. */
export const isShown = (material: Material): boolean =>
  material.visible && material.colorWrite && material.depthFunc !== NeverDepth && opacityOf(material) > 0;

/** What says for each pixel whether a material is drawn there, and how much of it is seen. */
const NAMES = [
  'opacity',
  'depthTest',
  'depthFunc',
  'stencilWrite',
  'stencilFunc',
  'stencilRef',
  'stencilFuncMask',
  'polygonOffset',
  'polygonOffsetFactor',
  'polygonOffsetUnits',
  'clippingPlanes',
  'clipIntersection',
] as const satisfies (keyof Material)[];

export type DrawState = Pick<Material, (typeof NAMES)[number]>;

/** Whether a material has clipping planes of its own. */
export const isClipped = ({ clippingPlanes }: Material): boolean =>
  clippingPlanes !== null && clippingPlanes.length > 0;

/** Whether a material is tested as every new one is. */
function isTestedAsUsual(material: Material): boolean {
  const { depthTest, depthFunc, stencilWrite, polygonOffset } = material;
  return depthTest && depthFunc === LessEqualDepth && !stencilWrite && !polygonOffset && !isClipped(material);
}

export const drawStateOf = (material: Material): DrawState =>
  Object.fromEntries(NAMES.map((name) => [name, material[name]])) as unknown as DrawState;

/** The modes in which what lies nearer is drawn. Outlines lie before their surface, so that all three are one to them. */
const NEARER: readonly DepthModes[] = [LessDepth, LessEqualDepth, EqualDepth];

/**
 * Has the material of outlines fade as a surface does, and pass its tests beside those of its own. Outlines never write to the stencil for
 * a surface: they would widen what it marks.
 *
 * @returns the state that it had before; null if nothing changes. Allocates nothing then.
 */
export function takeDrawState(material: Material, surface: Material): DrawState | null {
  const opacity = opacityOf(surface);
  if (opacity === 1 && isTestedAsUsual(surface)) return null;
  const before = drawStateOf(material);
  material.opacity *= opacity;
  material.depthTest &&= surface.depthTest;
  if (!NEARER.includes(surface.depthFunc)) material.depthFunc = surface.depthFunc;
  if (surface.stencilWrite && !material.stencilWrite) {
    material.stencilWrite = true;
    material.stencilFunc = surface.stencilFunc;
    material.stencilRef = surface.stencilRef;
    material.stencilFuncMask = surface.stencilFuncMask;
  }
  if (surface.polygonOffset && !material.polygonOffset) {
    material.polygonOffset = true;
    material.polygonOffsetFactor = surface.polygonOffsetFactor;
    material.polygonOffsetUnits = surface.polygonOffsetUnits;
  }
  if (isClipped(surface) && !isClipped(material)) {
    material.clippingPlanes = surface.clippingPlanes;
    material.clipIntersection = surface.clipIntersection;
  }
  return before;
}

/** Whether surfaces that lie nearer do not hide what a material draws. */
export const isDrawnBefore = ({ depthTest, depthFunc }: Material): boolean =>
  !depthTest || depthFunc === GreaterDepth || depthFunc === GreaterEqualDepth || depthFunc === NotEqualDepth;

/** How many slopes to a pixel nearer than it lies a surface is drawn. */
const pullOf = ({ polygonOffset, polygonOffsetFactor }: Material): number =>
  polygonOffset ? Math.max(0, -polygonOffsetFactor) : 0;

/** Writes to the uniforms of outlines what their material has taken of a surface. A number that is stored is allocated. */
export function writeDrawState(material: Material, u: Record<string, IUniform>): void {
  if (u.opacity.value !== material.opacity) u.opacity.value = material.opacity;
  const pull = pullOf(material);
  if (u.pull.value !== pull) u.pull.value = pull;
  u.isDrawnBefore.value = isDrawnBefore(material);
}

/** Whether two materials give their outlines the same look. */
export const looksAlike = (a: Material, b: Material): boolean =>
  a === b ||
  (opacityOf(a) === opacityOf(b) &&
    ((isTestedAsUsual(a) && isTestedAsUsual(b)) || NAMES.every((name) => name === 'opacity' || a[name] === b[name])));
