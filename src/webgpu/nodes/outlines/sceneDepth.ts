/** Counterpart of shaders/outlines/sceneDepth.glsl: the depth of the opaque objects drawn before the outlines, copied by three.js. */
import {
  DepthFormat,
  DepthStencilFormat,
  DepthTexture,
  FloatType,
  REVISION,
  UnsignedInt248Type,
  UnsignedIntType,
} from 'three';
import { type NodeBuilder, WebGPUCoordinateSystem } from 'three/webgpu';
import { isOrthographic } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { type TextureValue, threeNodes, tsl, type Value } from '../base/values.js';

const { abs, cameraFar, cameraNear, cameraProjectionMatrix, clamp, float, floor, int, ivec2, screenSize, select } = tsl;
const { logarithmicDepthToViewZ, orthographicDepthToViewZ, screenUV, viewportDepthTexture } = threeNodes;

export const nearDistance: Value = /* @__PURE__ */ hatchingUniform('nearDistance', 'float');
export const viewport: Value = /* @__PURE__ */ hatchingUniform('viewport', 'vec4');

/** three.js' declaration omits the last parameter. */
const copyOf = viewportDepthTexture as unknown as (uv: unknown, level: null, depth: DepthTexture) => TextureValue;
const copies = /* @__PURE__ */ new Map<string, TextureValue>();

/** Whether three.js renders a reversed depth into float textures: 0.186 uses integer ones. */
const REVERSES_FLOATS = Number.parseInt(REVISION, 10) >= 187;

/** The copy of the depth buffer, in the format of that buffer. */
function sceneDepthFor({ renderer }: NodeBuilder): TextureValue {
  const hasStencil = renderer.getRenderTarget()?.stencilBuffer ?? renderer.stencil;
  const key = `${hasStencil} ${renderer.reversedDepthBuffer}`;
  let copy = copies.get(key);
  if (!copy) {
    const depth = new DepthTexture(1, 1);
    depth.format = hasStencil ? DepthStencilFormat : DepthFormat;
    if (renderer.reversedDepthBuffer && REVERSES_FLOATS) depth.type = FloatType;
    else depth.type = hasStencil ? UnsignedInt248Type : UnsignedIntType;
    copy = copyOf(screenUV, null, depth);
    copies.set(key, copy);
  }
  return copy;
}

/** Farther than anything in a scene. */
export const NOWHERE = 1e30;

/** An element of the projection matrix. */
export const projection = (column: number, row: number): Value => cameraProjectionMatrix.element(column).element(row);

/** Whether the render target has a depth buffer that can be read. */
export function hasSceneDepth({ renderer }: NodeBuilder): boolean {
  const target = renderer.getRenderTarget();
  return target ? target.depthBuffer : renderer.depth;
}

/** Whether a pixel lies in the view, which may be a tile of a picture. Outside, no depth is known. */
export function isInView(pixel: Value): Value {
  const place = pixel.sub(viewport.xy).toVar();
  return place.x
    .greaterThanEqual(0)
    .and(place.y.greaterThanEqual(0))
    .and(place.x.lessThan(viewport.z))
    .and(place.y.lessThan(viewport.w));
}

/** The z in view space of a depth under the current projection. */
function viewZOf(depth: Value, { renderer }: NodeBuilder): Value {
  if (renderer.logarithmicDepthBuffer) {
    const read = { orthographic: orthographicDepthToViewZ, logarithmic: logarithmicDepthToViewZ } as unknown as Record<
      'orthographic' | 'logarithmic',
      (...values: Value[]) => Value
    >;
    return select(
      isOrthographic(),
      read.orthographic(depth, cameraNear, cameraFar),
      read.logarithmic(depth, cameraNear, cameraFar),
    );
  }
  // A reversed depth lies in [0, 1] with WebGL 2 too.
  const isHalf = renderer.coordinateSystem === WebGPUCoordinateSystem || renderer.reversedDepthBuffer;
  const clip = (isHalf ? depth : depth.mul(2).sub(1)).toVar();
  return projection(3, 2)
    .sub(clip.mul(projection(3, 3)))
    .div(clip.mul(projection(2, 3)).sub(projection(2, 2)));
}

/** Distance from the eye to the surface visible in a pixel, or in the nearest pixel of the view; NOWHERE if nothing is drawn there. */
export function depthAt(pixel: Value, builder: NodeBuilder): Value {
  const place = floor(clamp(pixel, viewport.xy, viewport.xy.add(viewport.zw).sub(1))).toVar();
  // three.js flips the rows of render targets.
  const texel = ivec2(int(place.x), int(screenSize.y).sub(1).sub(int(place.y)));
  const depth = float(sceneDepthFor(builder).load(texel)).toVar();
  const isNowhere = builder.renderer.reversedDepthBuffer ? depth.lessThanEqual(0) : depth.greaterThanEqual(1);
  return select(isNowhere, float(NOWHERE), viewZOf(depth, builder).negate());
}

/** Height of the view at a distance from the eye, view units. */
export const viewHeightAt = (away: Value): Value =>
  select(isOrthographic(), float(1), away)
    .mul(2)
    .div(abs(projection(1, 1)));
