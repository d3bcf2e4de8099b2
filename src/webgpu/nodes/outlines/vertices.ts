/**
 * Counterpart of shaders/outlines/outlines.vert. There are three vertices per primitive, which is a triangle of the mesh or an edge. Each
 * primitive has at most one piece of outline, which becomes one screen triangle that covers it with its round ends.
 */
import type { Light } from 'three';
import type { LightsNode, NodeBuilder } from 'three/webgpu';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { contour } from './contour.js';
import { clearVaryings, coverPiece } from './cover.js';
import { featureEdge } from './featureEdge.js';
import type { OutlineDefines } from './OutlineDefines.js';
import { isPiece, measureExtent, noPiece } from './piece.js';
import { readPoint } from './points.js';
import { eyeOfInstance, flagsOf, isEdge, isScaledToNothing, readPrimitive } from './primitives.js';
import { shade } from './shade.js';
import { suggestiveContour, suggestiveContours } from './suggestiveContour.js';

const { Fn, If, int, vec4, vertexIndex } = tsl;

/** The eye in object space; for an orthographic camera w is 0 and xyz the direction to it. */
const eye = /* @__PURE__ */ hatchingUniform('eye', 'vec4');

function lightsOf(builder: NodeBuilder): readonly Light[] {
  const { lightsNode } = builder as NodeBuilder & { lightsNode: LightsNode | null };
  return lightsNode ? lightsNode.getLights() : [];
}

/** The position in clip space. */
export const vertices = (defines: OutlineDefines): Value =>
  Fn((builder) => {
    // Pieces that are not drawn lie outside of clip space.
    const clipPosition = vec4(2, 2, 2, 1).toVar();
    clearVaryings(defines);
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
      coverPiece(piece, index.mod(3), instancePlace, clipPosition, defines, builder);
    });
    return clipPosition;
  })();
