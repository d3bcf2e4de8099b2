import adjacencyPrimitive from '../../shaders/chunks/adjacencyPrimitive.glsl?raw';
import anchorAttributes from '../../shaders/chunks/anchorAttributes.glsl?raw';
import anchoredHatch from '../../shaders/chunks/anchoredHatch.glsl?raw';
import debugViews from '../../shaders/chunks/debugViews.glsl?raw';
import deformedToRest from '../../shaders/chunks/deformedToRest.glsl?raw';
import deformVertex from '../../shaders/chunks/deformVertex.glsl?raw';
import emitHatchingParameters from '../../shaders/chunks/emitHatchingParameters.glsl?raw';
import hatch from '../../shaders/chunks/hatch.glsl?raw';
import hatchingFragmentParameters from '../../shaders/chunks/hatchingFragmentParameters.glsl?raw';
import hatchingParameters from '../../shaders/chunks/hatchingParameters.glsl?raw';
import hatchingVaryings from '../../shaders/chunks/hatchingVaryings.glsl?raw';
import lightOrientation from '../../shaders/chunks/lightOrientation.glsl?raw';
import printedColor from '../../shaders/chunks/printedColor.glsl?raw';
import pulledVertices from '../../shaders/chunks/pulledVertices.glsl?raw';
import radiance from '../../shaders/chunks/radiance.glsl?raw';
import simplexLattice from '../../shaders/chunks/simplexLattice.glsl?raw';
import strokeLayers from '../../shaders/chunks/strokeLayers.glsl?raw';
import thresholdMap from '../../shaders/chunks/thresholdMap.glsl?raw';
import tonalArtMap from '../../shaders/chunks/tonalArtMap.glsl?raw';
import tone from '../../shaders/chunks/tone.glsl?raw';
import toneCurve from '../../shaders/chunks/toneCurve.glsl?raw';
import toneNormals from '../../shaders/chunks/toneNormals.glsl?raw';
import triangleGeometry from '../../shaders/chunks/triangleGeometry.glsl?raw';
import turns from '../../shaders/chunks/turns.glsl?raw';
import deformationFragmentSource from '../../shaders/deformation.frag?raw';
import deformationVertexSource from '../../shaders/deformation.vert?raw';
import fragmentSource from '../../shaders/hatching.frag?raw';
import vertexSource from '../../shaders/hatching.vert?raw';
import { resolveIncludes } from './resolveIncludes.js';
import { conventionsChunk, cornerAttributesChunk } from './shaderConventions.js';

const chunks = {
  adjacencyPrimitive,
  anchorAttributes,
  anchoredHatch,
  conventions: conventionsChunk,
  cornerAttributes: cornerAttributesChunk,
  debugViews,
  deformedToRest,
  deformVertex,
  emitHatchingParameters,
  hatch,
  hatchingFragmentParameters,
  hatchingParameters,
  hatchingVaryings,
  lightOrientation,
  printedColor,
  pulledVertices,
  radiance,
  simplexLattice,
  strokeLayers,
  thresholdMap,
  tonalArtMap,
  tone,
  toneCurve,
  toneNormals,
  triangleGeometry,
  turns,
};

/** Our chunks resolved; three resolves its own when it compiles. */
export const hatchingVertexShader: string = resolveIncludes(vertexSource, chunks);
export const hatchingFragmentShader: string = resolveIncludes(fragmentSource, chunks);
export const deformationVertexShader: string = resolveIncludes(deformationVertexSource, chunks);
export const deformationFragmentShader: string = deformationFragmentSource;
