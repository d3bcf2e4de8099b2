/** The twin of shaders/outlines/varyings.glsl: the same at all three vertices, what the fragments need to know of the piece of outline they may lie on. */
import { tsl, type Value } from '../base/values.js';

const { varyingProperty } = tsl;

/** Start and end on the screen, pixels. */
export const vEnds: Value = /* @__PURE__ */ varyingProperty('vec4', 'vEnds');
/** Of start and end before the paper, of both before a surface, pixels. */
export const vHalfWidths: Value = /* @__PURE__ */ varyingProperty('vec4', 'vHalfWidths');
/** View space, and the distance that its depth has, nearer than it lies. */
export const vStart: Value = /* @__PURE__ */ varyingProperty('vec4', 'vStart');
export const vEnd: Value = /* @__PURE__ */ varyingProperty('vec4', 'vEnd');
/** By how much the outline runs on beyond start and end, pixels. */
export const vOvershoots: Value = /* @__PURE__ */ varyingProperty('vec2', 'vOvershoots');
/** How start and end stand before what lies behind them (hierarchy.ts); negative where fragments find out. */
export const vStandings: Value = /* @__PURE__ */ varyingProperty('vec4', 'vStandings');
/** The share of an outline that is a contour or a border, and not only a crease. */
export const vContour: Value = /* @__PURE__ */ varyingProperty('float', 'vContour');
/** How far the surface may lie before its own outline, view units. */
export const vTolerance: Value = /* @__PURE__ */ varyingProperty('float', 'vTolerance');
/** Of the object on the screen, pixels. Where hidden outlines are drawn. */
export const vOrigin: Value = /* @__PURE__ */ varyingProperty('vec2', 'vOrigin');
/** Object space, at rest. Where there is a wobble. */
export const vAnchorStart: Value = /* @__PURE__ */ varyingProperty('vec3', 'vAnchorStart');
export const vAnchorEnd: Value = /* @__PURE__ */ varyingProperty('vec3', 'vAnchorEnd');
