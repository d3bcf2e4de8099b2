import type { BufferGeometry } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { familyOf } from '../look/presetParameters.js';
import { type ResolvedLook, resolveLook } from '../look/queries.js';
import { isFormed } from '../material/geometry/formGeometry.js';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import { hasRoomForForm } from './deviceLimits.js';
import { dotLayerOf, handCodeOf } from './fetchedCode.js';
import { directedLights, lightsOf } from './nodes/base/lights.js';
import { pixelFromBelow } from './nodes/base/maths.js';
import { hatchingUniform } from './nodes/base/uniforms.js';
import { tsl, type Value } from './nodes/base/values.js';
import { emitAnchor } from './nodes/chunks/anchor.js';
import { hatchInShadow } from './nodes/chunks/crossedTones.js';
import { followsForm } from './nodes/chunks/lightOrientation.js';
import { emitOcclusion } from './nodes/chunks/occlusion.js';
import { hasShadows } from './nodes/chunks/shadows.js';
import type { HatchingSurface } from './nodes/chunks/tone.js';
import { deformVertex, placeInstance } from './nodes/chunks/vertex.js';
import { emitLines } from './nodes/lines/emit.js';
import { type DirectionChoices, turnsWithLight } from './nodes/lines/fields.js';
import { hatchLayer, type Printing as LinePrinting, shadowLayer as shadowFamilies } from './nodes/lines/hatchLayer.js';
import { read } from './nodes/lines/read.js';
import { ruledLines } from './nodes/lines/ruledLines.js';
import { emitStrokes } from './nodes/strokes/emit.js';
import { hatch, shadowLayer } from './nodes/strokes/layers.js';
import { type HatchingParameters, readHatchingParameters } from './nodes/strokes/read.js';
import { type StrokeDefines, hatchLayer as strokeLayer } from './nodes/strokes/strokes.js';

type Look = HatchingMaterialProperties;

const { float } = tsl;

/** 0 while strokes have no map. */
const inked = /* @__PURE__ */ hatchingUniform('inked', 'float');

/** Whether a look draws strokes or dots; all others are drawn as lines. */
const drawsStrokes = ({ technique }: Look): boolean => familyOf(technique) === 'strokes';

/** The look as resolved for the mesh for which nodes are built. */
const resolvedFor = (look: Look, builder: NodeBuilder): ResolvedLook =>
  resolveLook(look, isFormed(builder.geometry as BufferGeometry) && hasRoomForForm(builder, drawsStrokes(look)));

function directionOf({ direction, shadowStrokes, runsAway }: ResolvedLook, builder: NodeBuilder): DirectionChoices {
  const field = { direction, runsAway, reorients: false };
  const reorients = shadowStrokes === 'reorient' && hasShadows(builder, lightsOf(builder));
  return { ...field, reorients: reorients && turnsWithLight(field) };
}

/** Positions the vertex as three.js' materials do, and writes the varyings of strokes. */
export function emitVertex(look: Look, builder: NodeBuilder): void {
  const resolved = resolvedFor(look, builder);
  const isOfForm = followsForm(resolved.direction);
  // Lines that follow the form are fixed to the surface at rest, whatever `strokeAnchor` is.
  const isAtRest = look.strokeAnchor === 'rest' || (isOfForm && !drawsStrokes(look));
  const deformed = deformVertex(builder);
  const place = placeInstance(builder);
  emitOcclusion(builder);
  const anchor = emitAnchor(builder, deformed, place, isAtRest);
  if (drawsStrokes(look)) emitStrokes(anchor, { isOfForm, isAtRest });
  else emitLines(builder, anchor, { field: directionOf(resolved, builder), isAtRest, lights: lightsOf(builder) });
}

/** The tones of a surface. */
interface Tones {
  /** Of strokes that end at shadows, two: without the shadows that are read along strokes, and in all of them. */
  tone: Value;
  /** The tone without shadows; null where shadows only darken. */
  unshadowed: Value | null;
}

/** The darkness of the hatch of a surface. */
export function darknessOf(look: Look, surface: HatchingSurface, tones: Tones, builder: NodeBuilder): Value {
  const darkness = drawsStrokes(look) ? strokesIn(look, surface, builder) : linesIn(look, surface, builder);
  return hatchInShadow(tones.tone, tones.unshadowed, darkness.hatch, darkness.shadowLayer);
}

/** The functions that print a tone: as the hatch of a surface, and as that of its shadows. */
type Printing = Record<'hatch' | 'shadowLayer', (tone: Value) => Value>;

function linesIn(
  look: Look,
  { castShadows, receivedShadows, shadowLeft }: HatchingSurface,
  builder: NodeBuilder,
): Printing {
  const resolved = resolvedFor(look, builder);
  const { technique } = resolved;
  const h = read(builder, directionOf(resolved, builder), technique, {
    castShadows,
    receivedShadows,
    shadowLeft,
    lights: lightsOf(builder),
  });
  const printing: LinePrinting = {
    isPen: technique === 'pen',
    printFamily: handCodeOf(look)?.printer ?? ((...family) => ruledLines(...family, technique)),
  };
  return {
    hatch: (tone) => hatchLayer(h, tone, printing),
    shadowLayer: (tone) => shadowFamilies(h, tone, printing),
  };
}

/** Blank paper, until the code of a technique is loaded. */
const noLayer = (): Value => float(0);

function strokesIn(look: Look, { receivedShadows }: HatchingSurface, builder: NodeBuilder): Printing {
  const { technique, direction, strokeLayers } = resolvedFor(look, builder);
  const lights = lightsOf(builder);
  const several = directedLights(lights).length > 1;
  const parameters = readHatchingParameters(builder, lights, direction, receivedShadows);
  const layers = strokeLayers === 'lights' && !several ? 'single' : strokeLayers;
  const defines: StrokeDefines = {
    isSizedOnScreen: look.screenSpaceShare > 0,
    isUpToSign: several || followsForm(direction),
    technique,
    pixel: pixelFromBelow(),
  };
  const dotLayer = dotLayerOf(look) ?? noLayer;
  const layer = (h: HatchingParameters, printed: Value): Value =>
    technique === 'stipple' ? dotLayer(h, printed, builder) : strokeLayer(h, printed, defines);
  return {
    hatch: (tone) => hatch(parameters, tone, layers, layer).mul(inked),
    shadowLayer: (tone) => shadowLayer(parameters, tone, layer).mul(inked),
  };
}
