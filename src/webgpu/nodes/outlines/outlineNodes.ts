/** The nodes of an outline material: vertices, colour, clipping and depth. */
import type { Vector4 } from 'three';
import type { Node, NodeBuilder } from 'three/webgpu';
import { lightsOf } from '../base/lights.js';
import { isOrthographic } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { contour, suggestiveContour, suggestiveContours } from './contour.js';
import { coverPiece } from './cover.js';
import { featureEdge } from './featureEdge.js';
import { fragments, type OutlineDefines, onSpine, spinePosition } from './fragments.js';
import { isPiece, measureExtent, noPiece } from './piece.js';
import { eyeOfInstance, flagsOf, isEdge, isScaledToNothing, readPoint, readPrimitive, spacingOf } from './points.js';
import { shade } from './shade.js';
import { vEnd, vStart } from './varyings.js';

const { cameraFar, cameraNear, Discard, dot, float, Fn, If, int, mix, select, vec4, vertexIndex } = tsl;
const { cameraWorldMatrix, renderGroup, uniformArray, viewZToLogarithmicDepth, viewZToOrthographicDepth } = threeNodes;

/**
 * Counterpart of shaders/outlines/outlines.vert. There are three vertices per primitive, which is a triangle of the mesh or an edge. Each
 * primitive has at most one piece of outline, which becomes one screen triangle that covers it with its round ends.
 */

const eye = /* @__PURE__ */ hatchingUniform('eye', 'vec4');

/** The position in clip space. */
export const vertices = (defines: OutlineDefines): Value =>
  Fn((builder) => {
    // Pieces that are not drawn lie outside of clip space.
    const clipPosition = vec4(2, 2, 2, 1).toVar();
    const index = int(vertexIndex).toVar();
    const { primitive, instancePlace } = readPrimitive(index.div(3));
    const seenFrom = eyeOfInstance(eye, instancePlace);
    // Read before the branch, since some devices run both sides of it.
    const a = readPoint(primitive.x, seenFrom);
    const b = readPoint(primitive.y, seenFrom);
    const c = readPoint(primitive.z, seenFrom);
    const d = readPoint(primitive.w, seenFrom);
    const piece = noPiece();
    If(isEdge(primitive), () => {
      featureEdge(piece, flagsOf(primitive).toVar(), [a, b, c, d], defines.HIDDEN);
    }).Else(() => {
      contour(piece, a, b, c);
      If(suggestiveContours.greaterThan(0).and(isPiece(piece).not()), () => {
        suggestiveContour(piece, a, b, c, seenFrom);
      });
      measureExtent(piece, a, b, c, seenFrom);
    });
    If(isPiece(piece).and(isScaledToNothing(instancePlace).not()), () => {
      if (!defines.HIDDEN) shade(piece, instancePlace, lightsOf(builder));
      coverPiece(piece, spacingOf(primitive).toVar(), index.mod(3), instancePlace, clipPosition, defines, builder);
    });
    return clipPosition;
  })();

/**
 * Clips outlines within a ClippingGroup by their spines, as shaders/outlines/surroundings.glsl does. three.js' own node would clip by the
 * triangle that covers the piece.
 */

const planesOf = uniformArray as unknown as (planes: Vector4[]) => { setGroup(group: object): Value };

interface WithClipping {
  /** The planes of the enclosing groups, in view space; missing in three.js' declaration. */
  readonly clippingContext: { readonly unionPlanes: Vector4[]; readonly intersectionPlanes: Vector4[] } | null;
}

/** Whether a position lies beyond each plane. */
function beyond(place: Value, planes: Vector4[]): Value[] {
  const all = planesOf(planes).setGroup(renderGroup);
  return planes.map((_, i) => {
    const plane = all.element(i);
    return dot(place, plane.xyz).greaterThan(plane.w);
  });
}

/** Discards clipped fragments. To be called once the position on the spine is known. */
export function clipSpine(builder: NodeBuilder): void {
  const { camera, clippingContext } = builder as NodeBuilder & WithClipping;
  if (!clippingContext) return;
  const { unionPlanes, intersectionPlanes } = clippingContext;
  // With several cameras the planes are in world space.
  const toWorld = cameraWorldMatrix as unknown as Value;
  const place = camera && 'isArrayCamera' in camera ? toWorld.mul(vec4(spinePosition, 1)).xyz : spinePosition;
  if (unionPlanes.length > 0) Discard(beyond(place, unionPlanes).reduce((one, other) => one.or(other)));
  if (intersectionPlanes.length > 0) Discard(beyond(place, intersectionPlanes).reduce((one, other) => one.and(other)));
}

const depthOf = { logarithmic: viewZToLogarithmicDepth, orthographic: viewZToOrthographicDepth } as unknown as Record<
  'logarithmic' | 'orthographic',
  (z: Value, near: Value, far: Value) => Value
>;

/** The depth of a fragment for a logarithmic depth buffer; otherwise that of the triangle is right. */
export const logarithmicDepth = (defines: OutlineDefines): Value =>
  Fn(() => {
    const { t } = onSpine(defines);
    const share = mix(float(1).div(vStart.w), float(1).div(vEnd.w), t);
    const z = select(isOrthographic(), mix(vStart.w, vEnd.w, t), float(1).div(share))
      .negate()
      .toVar();
    return select(
      isOrthographic(),
      depthOf.orthographic(z, cameraNear, cameraFar),
      depthOf.logarithmic(z, cameraNear, cameraFar),
    );
  })();

/** The nodes of an outline material. */
export interface OutlineNodes {
  /** The defines that they are built for. */
  key: string;
  /** The position in clip space; null for what `place` places. */
  vertex: Node<'vec4'> | null;
  /** Moves the vertex of an object. */
  place?(builder: NodeBuilder): void;
  color: Node<'vec4'>;
  outgoing: Node<'vec3'>;
  /** The z in view space that fog is computed from. */
  viewZ: Node<'float'>;
  /** The depth of fragments for a logarithmic depth buffer; null for what is not tested against it. */
  logarithmicDepth: Node<'float'> | null;
}

const known = new Map<string, OutlineNodes>();

/** The nodes for these defines, shared by all materials. */
export function outlineNodes(defines: OutlineDefines): OutlineNodes {
  const key = JSON.stringify(defines);
  let nodes = known.get(key);
  if (!nodes) {
    nodes = {
      key,
      vertex: vertices(defines) as unknown as Node<'vec4'>,
      color: fragments(defines) as unknown as Node<'vec4'>,
      outgoing: threeNodes.diffuseColor.rgb,
      viewZ: spinePosition.z as unknown as Node<'float'>,
      logarithmicDepth: logarithmicDepth(defines) as unknown as Node<'float'>,
    };
    known.set(key, nodes);
  }
  return nodes;
}
