import {
  type BufferGeometry,
  DecrementWrapStencilOp,
  type DepthModes,
  EqualDepth,
  EqualStencilFunc,
  GreaterDepth,
  GreaterEqualDepth,
  GreaterStencilFunc,
  IncrementStencilOp,
  IncrementWrapStencilOp,
  InvertStencilOp,
  type IUniform,
  LessDepth,
  LessEqualDepth,
  type Material,
  NeverDepth,
  NoBlending,
  NormalBlending,
  NotEqualDepth,
  NotEqualStencilFunc,
  ReplaceStencilOp,
} from 'three';

/** The alpha of the most opaque vertex, for attributes of colours and their version. */
const alphas = new WeakMap<object, { version: number; most: number }>();

/** The alpha that colours of vertices give to a material: that of the most opaque one. */
function vertexAlpha({ vertexColors }: Material, { attributes: { color } }: BufferGeometry): number {
  if (!vertexColors || color?.itemSize !== 4) return 1;
  const version = 'version' in color ? color.version : color.data.version;
  const known = alphas.get(color);
  if (known?.version === version) return known.most;
  let most = 0;
  for (let vertex = 0; vertex < color.count; vertex++) most = Math.max(most, color.getW(vertex));
  alphas.set(color, { version, most });
  return most;
}

/**
 * The share of the ink that the opacity of a material leaves, by the rules of three.js: what is not blended is opaque.
 *
 * @param geometry whose colours of vertices count too
 */
export function opacityOf(material: Material, geometry: BufferGeometry | null = null): number {
  const { transparent, blending, alphaHash, alphaTest, alphaToCoverage } = material;
  const opacity = geometry ? material.opacity * vertexAlpha(material, geometry) : material.opacity;
  if (opacity < alphaTest) return 0;
  const isBlended = blending !== NormalBlending && blending !== NoBlending;
  return transparent || alphaHash || alphaToCoverage || isBlended ? Math.min(Math.max(opacity, 0), 1) : 1;
}

/** Whether anything is seen of a surface with this material. */
export const isShown = (material: Material, geometry: BufferGeometry | null = null): boolean =>
  material.visible && material.colorWrite && material.depthFunc !== NeverDepth && opacityOf(material, geometry) > 0;

/**
 * Whether parts of a surface may not be drawn, so that the depth of the scene says where its outlines are. That of a blended surface does not:
 * it is drawn later.
 */
export const isCutOut = ({ alphaHash, alphaTest, depthTest, depthWrite, opacity, transparent }: Material): boolean =>
  (alphaTest > 0 || (alphaHash && opacity >= 1)) && depthTest && depthWrite && !transparent;

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

/** What marks a pixel of the stencil that nothing has marked before. */
const MARKS: readonly number[] = [IncrementStencilOp, IncrementWrapStencilOp, DecrementWrapStencilOp, InvertStencilOp];

/**
 * Whether a surface passes the test of the stencil where nothing is marked, and fails it where it has marked that: so it is drawn once to a
 * pixel. Its outlines, which are drawn after it, would fail everywhere on it.
 */
function isDrawnOnce(surface: Material): boolean {
  const { stencilFunc, stencilFuncMask, stencilRef, stencilWriteMask, stencilZPass } = surface;
  if (!surface.stencilWrite || (stencilWriteMask & stencilFuncMask) === 0) return false;
  if ((stencilRef & stencilFuncMask) === 0) return stencilFunc === EqualStencilFunc && MARKS.includes(stencilZPass);
  return (
    stencilZPass === ReplaceStencilOp && (stencilFunc === NotEqualStencilFunc || stencilFunc === GreaterStencilFunc)
  );
}

/** Makes the state of a material, or of what was kept of one, that of another. Allocates nothing once `to` has had one. */
export function copyDrawState(from: DrawState, to: Partial<DrawState>): void {
  for (let i = 0; i < NAMES.length; i++) (to as Record<string, unknown>)[NAMES[i]] = from[NAMES[i]];
}

/** The modes in which what lies nearer is drawn. Outlines lie before their surface, so that all three are one to them. */
const NEARER: readonly DepthModes[] = [LessDepth, LessEqualDepth, EqualDepth];

/**
 * Has the material of outlines fade as a surface does, and pass its tests beside those of its own. Outlines never write to the stencil for
 * a surface: they would widen what it marks.
 *
 * @param before gets the state that it had before, if anything changes
 * @returns whether anything changes
 */
export function takeDrawState(
  material: Material,
  surface: Material,
  geometry: BufferGeometry | null,
  before: Partial<DrawState>,
): boolean {
  const opacity = opacityOf(surface, geometry);
  if (opacity === 1 && isTestedAsUsual(surface)) return false;
  copyDrawState(material, before);
  material.opacity *= opacity;
  material.depthTest &&= surface.depthTest;
  if (!NEARER.includes(surface.depthFunc)) material.depthFunc = surface.depthFunc;
  if (surface.stencilWrite && !material.stencilWrite && !isDrawnOnce(surface)) {
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
  return true;
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

/** Whether materials are tested alike. */
function isTestedAlike(a: Material, b: Material): boolean {
  if (isTestedAsUsual(a) && isTestedAsUsual(b)) return true;
  // A function for each name would be allocated in every frame.
  for (let i = 0; i < NAMES.length; i++) if (NAMES[i] !== 'opacity' && a[NAMES[i]] !== b[NAMES[i]]) return false;
  return isDrawnOnce(a) === isDrawnOnce(b);
}

/** Whether two materials give their outlines the same look. */
export const looksAlike = (a: Material, b: Material, geometry: BufferGeometry | null = null): boolean =>
  a === b || (opacityOf(a, geometry) === opacityOf(b, geometry) && isCutOut(a) === isCutOut(b) && isTestedAlike(a, b));
