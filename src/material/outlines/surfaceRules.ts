import {
  type BufferGeometry,
  DecrementWrapStencilOp,
  type DepthModes,
  EqualDepth,
  EqualStencilFunc,
  FrontSide,
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
  type Matrix4,
  type Mesh,
  NeverDepth,
  NoBlending,
  NormalBlending,
  NotEqualDepth,
  NotEqualStencilFunc,
  ReplaceStencilOp,
} from 'three';

/** A part of a mesh that is drawn with one material: its corners from `start` up to `end`. */
export interface SurfacePart {
  material: Material;
  start: number;
  end: number;
}

/**
 * The parts of a mesh that three.js draws: within its draw range, by groups if it has several materials, and only those with visible
 * materials.
 */
export function surfaceParts({ geometry, material }: Mesh): SurfacePart[] {
  const { index, attributes, drawRange, groups } = geometry;
  const count = (index ?? attributes.position)?.count ?? 0;
  const first = Math.max(0, drawRange.start);
  const last = Math.min(count, drawRange.start + drawRange.count);
  const parts = Array.isArray(material)
    ? groups.map(({ start, count: size, materialIndex = 0 }) => ({
        material: material[materialIndex],
        start: Math.max(first, start),
        end: Math.min(last, start + size),
      }))
    : [{ material, start: first, end: last }];
  return parts.filter((part) => part.material?.visible && part.end - part.start >= 3);
}

/** Whether a matrix maps everything to one point, which hides an object or an instance. */
export const isScaledToNothing = ({ elements: m }: Matrix4): boolean =>
  m[0] === 0 &&
  m[1] === 0 &&
  m[2] === 0 &&
  m[4] === 0 &&
  m[5] === 0 &&
  m[6] === 0 &&
  m[8] === 0 &&
  m[9] === 0 &&
  m[10] === 0;

/** A cache of the greatest vertex alpha of colour attributes, with their version. */
const alphas = new WeakMap<object, { version: number; most: number }>();

/** The alpha that vertex colours give to a material: that of the most opaque vertex. */
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
 * The share of the ink that the opacity of a material leaves, by three's rules: without blending a material is opaque.
 *
 * @param geometry a geometry whose vertex colours count too
 */
export function opacityOf(material: Material, geometry: BufferGeometry | null = null): number {
  const { transparent, blending, alphaHash, alphaTest, alphaToCoverage } = material;
  const opacity = geometry ? material.opacity * vertexAlpha(material, geometry) : material.opacity;
  if (opacity < alphaTest) return 0;
  const isBlended = blending !== NormalBlending && blending !== NoBlending;
  return transparent || alphaHash || alphaToCoverage || isBlended ? Math.min(Math.max(opacity, 0), 1) : 1;
}

/** Whether a surface with this material can be seen. */
export const isShown = (material: Material, geometry: BufferGeometry | null = null): boolean =>
  material.visible && material.colorWrite && material.depthFunc !== NeverDepth && opacityOf(material, geometry) > 0;

/**
 * Whether parts of a surface may be discarded, so that the depth of the scene decides where its outlines are. A blended surface is
 * drawn later and does not count.
 */
export const isCutOut = ({ alphaHash, alphaTest, depthTest, depthWrite, opacity, transparent }: Material): boolean =>
  (alphaTest > 0 || (alphaHash && opacity >= 1)) && depthTest && depthWrite && !transparent;

/** Whether the back of a surface hides what lies behind it, as its front does. */
export const showsBack = ({ side, transparent }: Material): boolean => side !== FrontSide && !transparent;

/** The properties that decide, for each pixel, whether a material is drawn and how opaque it is. */
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

/** Whether a material has the default depth and stencil tests. */
function isTestedAsUsual(material: Material): boolean {
  const { depthTest, depthFunc, stencilWrite, polygonOffset } = material;
  return depthTest && depthFunc === LessEqualDepth && !stencilWrite && !polygonOffset && !isClipped(material);
}

/** The stencil operations that mark a pixel that was not marked before. */
const MARKS: readonly number[] = [IncrementStencilOp, IncrementWrapStencilOp, DecrementWrapStencilOp, InvertStencilOp];

/**
 * Whether a surface passes the stencil test at unmarked pixels only and marks them, so that each pixel is drawn once. Its outlines,
 * which are drawn after it, would fail everywhere on it.
 */
function isDrawnOnce(surface: Material): boolean {
  const { stencilFunc, stencilFuncMask, stencilRef, stencilWriteMask, stencilZPass } = surface;
  if (!surface.stencilWrite || (stencilWriteMask & stencilFuncMask) === 0) return false;
  if ((stencilRef & stencilFuncMask) === 0) return stencilFunc === EqualStencilFunc && MARKS.includes(stencilZPass);
  return (
    stencilZPass === ReplaceStencilOp && (stencilFunc === NotEqualStencilFunc || stencilFunc === GreaterStencilFunc)
  );
}

/** Copies the draw state of a material, or of a stored state. Allocates nothing once `to` has held one. */
export function copyDrawState(from: DrawState, to: Partial<DrawState>): void {
  for (let i = 0; i < NAMES.length; i++) (to as Record<string, unknown>)[NAMES[i]] = from[NAMES[i]];
}

/**
 * The depth functions that draw what is nearer. Outlines are in front of their surface, so that all three have the same effect on them.
 */
const NEARER: readonly DepthModes[] = [LessDepth, LessEqualDepth, EqualDepth];

/**
 * Gives the material of outlines the opacity of a surface, unless its own is less, and its tests in addition to those of its own. Code
 * that fades all materials below an object fades both, and lines must not fade twice. Outlines never write the stencil of a surface,
 * because they would enlarge what it marks.
 *
 * @param before receives the previous state, if anything changes
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
  material.opacity = Math.min(material.opacity, opacity);
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

/** Whether a material is drawn over nearer surfaces too. */
export const isDrawnBefore = ({ depthTest, depthFunc }: Material): boolean =>
  !depthTest || depthFunc === GreaterDepth || depthFunc === GreaterEqualDepth || depthFunc === NotEqualDepth;

/** The polygon offset of a surface towards the eye, in slopes per pixel. */
const pullOf = ({ polygonOffset, polygonOffsetFactor }: Material): number =>
  polygonOffset ? Math.max(0, -polygonOffsetFactor) : 0;

/**
 * Writes the state that an outline material has taken from a surface to uniforms. Numbers are stored only if they differ, since storing
 * one allocates.
 */
export function writeDrawState(material: Material, u: Record<string, IUniform>): void {
  if (u.opacity.value !== material.opacity) u.opacity.value = material.opacity;
  const pull = pullOf(material);
  if (u.pull.value !== pull) u.pull.value = pull;
  u.isDrawnBefore.value = isDrawnBefore(material);
}

/** Whether two materials have the same tests. */
function isTestedAlike(a: Material, b: Material): boolean {
  if (isTestedAsUsual(a) && isTestedAsUsual(b)) return true;
  // A callback for each name would be allocated in every frame.
  for (let i = 0; i < NAMES.length; i++) if (NAMES[i] !== 'opacity' && a[NAMES[i]] !== b[NAMES[i]]) return false;
  return isDrawnOnce(a) === isDrawnOnce(b);
}

/** Whether the outlines of two materials look alike. */
export const looksAlike = (a: Material, b: Material, geometry: BufferGeometry | null = null): boolean =>
  a === b ||
  (opacityOf(a, geometry) === opacityOf(b, geometry) &&
    isCutOut(a) === isCutOut(b) &&
    showsBack(a) === showsBack(b) &&
    isTestedAlike(a, b));
