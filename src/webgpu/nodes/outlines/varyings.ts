/** Counterpart of shaders/outlines/varyings.glsl: the piece of outline that a fragment may lie on, constant over its triangle. */
import { tsl, type Value } from '../base/values.js';

const { varyingProperty } = tsl;

/** Start and end on the screen, pixels. */
export const vEnds: Value = /* @__PURE__ */ varyingProperty('vec4', 'vEnds');
/** Half widths of start and end before paper, and of both before a surface, pixels. */
export const vHalfWidths: Value = /* @__PURE__ */ varyingProperty('vec4', 'vHalfWidths');
/** Start in view space, and the distance of its depth, which is nearer. */
export const vStart: Value = /* @__PURE__ */ varyingProperty('vec4', 'vStart');
export const vEnd: Value = /* @__PURE__ */ varyingProperty('vec4', 'vEnd');
/** Lengths of the overshoots at start and end, pixels. */
export const vOvershoots: Value = /* @__PURE__ */ varyingProperty('vec2', 'vOvershoots');
/** Line weights at start and end (hierarchy.ts); negative where they are computed per fragment. */
export const vLineWeights: Value = /* @__PURE__ */ varyingProperty('vec4', 'vLineWeights');
/** The share of an outline that is a contour or a border, not a crease. */
export const vContour: Value = /* @__PURE__ */ varyingProperty('float', 'vContour');
/** Distance by which a surface may lie before its own outline, view units. */
export const vTolerance: Value = /* @__PURE__ */ varyingProperty('float', 'vTolerance');
/** Screen position of the object's origin, pixels; for hidden outlines. */
export const vOrigin: Value = /* @__PURE__ */ varyingProperty('vec2', 'vOrigin');
/** Object space, at rest; for wobble. */
export const vAnchorStart: Value = /* @__PURE__ */ varyingProperty('vec3', 'vAnchorStart');
export const vAnchorEnd: Value = /* @__PURE__ */ varyingProperty('vec3', 'vAnchorEnd');
