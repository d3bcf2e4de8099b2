import type { HatchingMaterialOptions, HatchingOutlineParameters, PresetName, TonalArtMap } from 'three-hatching';

type LineSetting = 'outlineWidth' | 'weights' | 'wobble' | 'overshoot';

type Triple = readonly [x: number, y: number, z: number];

/** The models a scenario can show; each is centred and has a bounding radius of 1. */
export type ScenarioModel = 'patch' | 'floor' | 'suzanne' | 'bunny' | 'dragon' | 'chair' | SceneModel;

/** Models of many meshes in colours of their own. They are drawn with a preset. */
export type SceneModel = 'stairs' | 'room' | 'fox' | 'street';

/** A light of the scene. Intensities are three's: π gives a directional light the N·L of Suarez et al. */
export interface ScenarioLight {
  type: 'directional' | 'point' | 'spot';
  position: Triple;
  intensity: number;
}

/** A complete description of a picture: the same scenario gives the same pixels. */
export interface Scenario {
  /** The golden's file name. */
  name: string;
  /** The number of the figure in Suarez et al.; 0 if there is none. */
  figure: number;
  /** Description of the picture. */
  sentence: string;
  model: ScenarioModel;
  /** Radians about x, y and z, applied in this order. */
  modelRotation?: Triple;
  /** The camera, which looks at the origin by default. */
  camera: { position: Triple; fov: number; target?: Triple };
  lights: readonly ScenarioLight[];
  tonalArtMap: Pick<NonNullable<Parameters<typeof TonalArtMap.generate>[0]>, 'style' | 'seed' | 'size' | 'tones'>;
  /** Draws the model as `applyHatching` does with this preset, in the place of map, material and outlines. */
  preset?: PresetName;
  /** The anisotropy of the map, if the card has that filter. */
  anisotropy?: number;
  material: Partial<
    Pick<
      HatchingMaterialOptions,
      | 'technique'
      | 'perTriangle'
      | 'tilesPerObjectUnit'
      | 'strokeAngle'
      | 'screenSpaceShare'
      | 'debugView'
      | 'toneModel'
      | 'toneSteps'
      | 'color'
      | 'toneCurve'
      | 'reflectedLight'
      | 'strokeLayers'
      | 'crossFrom'
      | 'direction'
      | 'direction'
      | 'irregularity'
    >
  >;
  /** Parameters of the outlines, if any. */
  outlines?: Pick<HatchingOutlineParameters, LineSetting>;
  /** Pixels. */
  size: readonly [width: number, height: number];
}

const QUARTER_TURN = Math.PI / 2;

const sun = (...position: Triple): ScenarioLight[] => [{ type: 'directional', position, intensity: Math.PI }];

const common = {
  tonalArtMap: { style: 'hatching', seed: 1, size: 256, tones: 8 },
  size: [400, 300],
} as const;

const patch = {
  ...common,
  model: 'patch',
  camera: { position: [0, 0, 3.1], fov: 30 },
  lights: sun(1.5, 1, 1.2),
} as const;

const face = {
  ...common,
  figure: 10,
  model: 'suzanne',
  camera: { position: [0, 0, 3.6], fov: 28 },
  lights: sun(1, 1.2, 1.5),
} as const;

const dragon = { ...common, size: [560, 420], model: 'dragon', camera: { position: [0, 0.5, 4], fov: 28 } } as const;

const chair = {
  ...common,
  size: [300, 360],
  model: 'chair',
  camera: { position: [2.5, 1.7, 3.4], fov: 28 },
  lights: sun(-2, 0.7, 1.1),
} as const;

const bunny = {
  ...common,
  model: 'bunny',
  camera: { position: [0, 0.4, 4.2], fov: 29 },
  lights: sun(-1.2, 1.4, 1.2),
} as const;

const twoSuns: ScenarioLight[] = [
  { type: 'directional', position: [-2, 0.6, 1], intensity: 2.2 },
  { type: 'directional', position: [0.3, 2, 0.7], intensity: 1.6 },
];

const floor = {
  ...common,
  figure: 0,
  model: 'floor',
  camera: { position: [0, 0.12, 1.15], fov: 34 },
  lights: sun(1, 1.2, 0.4),
} as const;

const flat = { ...common, figure: 0, material: {} } as const;

/** The paper's figures that this library redraws, as pictures small enough to keep. */
export const scenarios: readonly Scenario[] = [
  {
    ...patch,
    name: 'figure-04-a-triangle',
    figure: 4,
    sentence: 'Four adjacent triangles with different normals, without blending: strokes break at every shared edge.',
    material: { technique: 'triangle', tilesPerObjectUnit: 1.2 },
  },
  {
    ...patch,
    name: 'figure-04-b-adjacency',
    figure: 4,
    sentence: 'The same triangles blended with their neighbours: strokes fade into each other across the edges.',
    material: { technique: 'adjacency', tilesPerObjectUnit: 1.2 },
  },
  {
    ...patch,
    name: 'figure-08-blend-factors',
    figure: 8,
    sentence: 'What each neighbour contributes: red, green and blue stand for the triangles across edges 0, 1 and 2.',
    material: { technique: 'adjacency', tilesPerObjectUnit: 1.2, debugView: 'blendFactors' },
  },
  ...(['lambert', 'halfLambert', 'phong', 'toon'] as const).map((toneModel) => ({
    ...face,
    name: `figure-09-${toneModel}`,
    figure: 9,
    sentence: `Texture numbers by the lighting technique ${toneModel}.`,
    material: { tilesPerObjectUnit: 1.5, toneModel, toneSteps: 4 },
  })),
  ...[0, 45, 90].map((degrees) => ({
    ...face,
    name: `figure-10-rotation-${degrees}`,
    sentence: `Strokes turned by ${degrees} degrees about the normal of each triangle, clockwise.`,
    material: { tilesPerObjectUnit: 1.5, strokeAngle: (-degrees * Math.PI) / 180 },
  })),
  // Smaller scales than elsewhere: from about 0.6 on the levels of the map keep strokes as wide as they are drawn.
  ...Object.entries({ coarse: 0.15, medium: 0.3, fine: 0.6 }).map(([name, tilesPerObjectUnit]) => ({
    ...face,
    name: `figure-10-scale-${name}`,
    sentence: `Strokes at ${tilesPerObjectUnit} tiles per unit of the model.`,
    material: { tilesPerObjectUnit },
  })),
  ...Object.entries({ left: sun(-2, 0.5, 1), above: sun(0, 2, 1), right: sun(2, 0.5, 1) }).map(([side, lights]) => ({
    ...face,
    name: `figure-10-light-${side}`,
    sentence: side === 'above' ? 'Light from above.' : `Light from the ${side}.`,
    lights,
    material: { tilesPerObjectUnit: 1.5 },
  })),
  ...[-40, 0, 40].map((degrees) => ({
    ...face,
    name: `figure-10-model-${degrees < 0 ? `minus-${-degrees}` : degrees}`,
    sentence: `The model turned by ${degrees} degrees under a light that stays where it is.`,
    modelRotation: [0, (degrees * Math.PI) / 180, 0] as const,
    material: { tilesPerObjectUnit: 1.5 },
  })),
  ...Object.entries({ left: sun(-2, 0.6, 1), above: sun(0, 2, 0.7), right: sun(2, 0.6, 1) }).map(([side, lights]) => ({
    ...dragon,
    name: `figure-11-light-${side}`,
    figure: 11,
    sentence: `Details of the form stay visible with the light ${side === 'above' ? 'above' : `on the ${side}`}.`,
    lights,
    material: { tilesPerObjectUnit: 1.5 },
  })),
  ...(['hatching', 'crossHatching', 'stippling'] as const).map((style) => ({
    ...dragon,
    name: `figure-12-${style}`,
    figure: 12,
    sentence: `The dragon drawn with the map ${style}.`,
    lights: sun(-2, 0.6, 1),
    tonalArtMap: { ...common.tonalArtMap, style },
    material: { tilesPerObjectUnit: 1.5, strokeAngle: QUARTER_TURN },
  })),
  ...Object.entries({ without: 'triangle', with: 'adjacency' } as const).map(([blending, technique]) => ({
    ...chair,
    name: `figure-13-${blending}-blending`,
    figure: 13,
    sentence: `A coloured chair ${blending} blending between its triangles.`,
    material: { technique, tilesPerObjectUnit: 1.2, color: '#c9573f' },
  })),
  {
    ...bunny,
    name: 'figure-14-towards',
    figure: 14,
    sentence: 'Strokes drawn towards the light.',
    material: { tilesPerObjectUnit: 1.5, strokeAngle: QUARTER_TURN },
  },
  {
    ...bunny,
    name: 'figure-14-tangent',
    figure: 14,
    sentence: 'Strokes drawn tangent to the direction of the light.',
    material: { tilesPerObjectUnit: 1.5, strokeAngle: 0 },
  },
  {
    ...bunny,
    name: 'beyond-anchored',
    figure: 0,
    sentence: 'Anchored strokes, sized on the object: continuous, black and white.',
    material: { technique: 'hatching', tilesPerObjectUnit: 2 },
  },
  {
    ...dragon,
    name: 'beyond-anchored-screen',
    figure: 0,
    sentence: 'Anchored strokes, sized on the screen.',
    lights: sun(1.2, 1, 1),
    material: { technique: 'hatching', strokeAngle: QUARTER_TURN, screenSpaceShare: 1 },
  },
  {
    ...dragon,
    name: 'beyond-anchored-form',
    figure: 0,
    sentence: 'Anchored strokes along the form, sized on the screen, crossed by others in the darks.',
    lights: sun(-1, 1.5, 1.2),
    material: {
      technique: 'hatching',
      direction: 'form',
      screenSpaceShare: 1,
      reflectedLight: 0.3,
      strokeLayers: 'tone',
      crossFrom: 0.4,
    },
  },
  {
    ...dragon,
    name: 'outlines-dragon',
    figure: 0,
    sentence: 'Contours, heavier in the shade, over strokes that leave the lit side white.',
    lights: sun(-1, 1.5, 1.2),
    material: { technique: 'hatching', toneCurve: 'perceptual', reflectedLight: 0.3, screenSpaceShare: 1 },
    outlines: { outlineWidth: 2 },
  },
  {
    ...chair,
    name: 'outlines-chair',
    figure: 0,
    sentence: 'Borders and creases by an unsteady hand that runs on past corners.',
    material: { technique: 'hatching', toneCurve: 'perceptual', reflectedLight: 0.3, screenSpaceShare: 1 },
    outlines: { outlineWidth: 2, wobble: 1.5, overshoot: 5 },
  },
  {
    ...face,
    name: 'outlines-face',
    figure: 0,
    sentence: 'Suggestive contours beside contours.',
    material: { technique: 'hatching', toneCurve: 'perceptual', reflectedLight: 0.3, screenSpaceShare: 1 },
    outlines: { outlineWidth: 2, weights: { suggestiveContours: 0.6 } },
  },
  {
    ...dragon,
    name: 'engraving-dragon',
    figure: 0,
    sentence: 'Engraved around the light, crossed in the darks, with contours.',
    lights: sun(-1, 1.5, 1.2),
    material: { technique: 'engraving', reflectedLight: 0.12, screenSpaceShare: 1 },
    outlines: { outlineWidth: 2 },
  },
  {
    ...bunny,
    name: 'engraving-fixed',
    figure: 0,
    sentence: 'Lines cut across an axis of the object by a ruling machine; only their width answers the light.',
    material: { technique: 'engraving', direction: 'y', irregularity: 0, screenSpaceShare: 1 },
  },
  {
    ...bunny,
    name: 'beyond-crisp',
    figure: 0,
    sentence: "The paper's frames and weights, with thresholds blended instead of greys.",
    material: { technique: 'adjacency', perTriangle: { sharpInk: true }, tilesPerObjectUnit: 1.5 },
  },
  {
    ...bunny,
    name: 'tone-linear',
    figure: 0,
    sentence: 'As much ink as there is shade: the side turned away is black.',
    material: { technique: 'hatching', tilesPerObjectUnit: 2, strokeAngle: QUARTER_TURN },
  },
  {
    ...bunny,
    name: 'tone-perceptual',
    figure: 0,
    sentence: 'Half the paper is covered where the light looks half as light as white.',
    material: { technique: 'hatching', tilesPerObjectUnit: 2, strokeAngle: QUARTER_TURN, toneCurve: 'perceptual' },
  },
  {
    ...bunny,
    name: 'tone-reflected-light',
    figure: 0,
    sentence: 'The surroundings reflect half the light: shade is darkest where it begins and opens up behind.',
    material: { technique: 'hatching', tilesPerObjectUnit: 2, strokeAngle: QUARTER_TURN, reflectedLight: 0.5 },
  },
  {
    ...bunny,
    name: 'second-layer-adjacency',
    figure: 0,
    sentence: 'Two lights: where they disagree, a second layer of strokes crosses the first.',
    lights: twoSuns,
    material: { tilesPerObjectUnit: 1.5, strokeAngle: QUARTER_TURN, strokeLayers: 'lights' },
  },
  {
    ...bunny,
    name: 'second-layer-anchored',
    figure: 0,
    sentence: 'The same two lights and layers, in anchored strokes.',
    lights: twoSuns,
    material: { technique: 'hatching', tilesPerObjectUnit: 2, strokeAngle: QUARTER_TURN, strokeLayers: 'lights' },
  },
  {
    ...bunny,
    name: 'layers-by-tone-anchored',
    figure: 0,
    sentence: 'Strokes cross in the darks: a second layer at 60°, and a third.',
    material: {
      technique: 'hatching',
      screenSpaceShare: 1,
      strokeAngle: QUARTER_TURN,
      reflectedLight: 0.4,
      strokeLayers: 'tone',
      crossFrom: 0.35,
    },
  },
  {
    ...floor,
    name: 'levels-floor-derivatives',
    sentence:
      'A long floor, its level by screen derivatives: strokes are never too fine, but wide where the floor slants.',
    material: { tilesPerObjectUnit: 10 },
  },
  {
    ...floor,
    name: 'levels-floor-depth',
    sentence: 'The same floor, its level by depth as in the paper: strokes as wide as drawn from near to far.',
    material: { tilesPerObjectUnit: 10, perTriangle: { levelRule: 'depth' } },
  },
  {
    ...floor,
    name: 'levels-floor-anisotropic',
    sentence:
      'By derivatives with anisotropic filtering: strokes keep their place on the floor and turn grey far away.',
    anisotropy: 8,
    material: { tilesPerObjectUnit: 10 },
  },
  ...Object.entries({ near: 1.2, middle: 2.4, far: 4.8 }).map(([name, distance]) => ({
    ...common,
    name: `levels-zoom-${name}`,
    figure: 0,
    sentence: `The dragon from a distance of ${distance}: more strokes the nearer, each as wide as before.`,
    model: 'dragon' as const,
    camera: { position: [0, 0.1 * distance, distance] as const, fov: 28 },
    lights: sun(1.2, 1, 1),
    material: { tilesPerObjectUnit: 2, strokeAngle: QUARTER_TURN, perTriangle: { levelRule: 'depth' } as const },
  })),
  {
    ...flat,
    name: 'flat-stairs',
    sentence: 'A staircase with the pen: lit treads stay nearly blank, and walls have one tone.',
    model: 'stairs',
    preset: 'pen',
    size: [360, 340],
    camera: { position: [1.8, 1.2, 3.45], fov: 27 },
    lights: sun(-0.55, 0.9, 1),
  },
  {
    ...flat,
    name: 'flat-room',
    sentence: 'A room from inside in cross-hatching: walls, ceiling and floor are told apart.',
    model: 'room',
    preset: 'crossHatching',
    camera: { position: [0.1, 0.06, 1.9], fov: 36, target: [0, -0.03, -0.7] },
    lights: sun(-0.5, 0.7, 1),
  },
  {
    ...flat,
    name: 'flat-fox',
    sentence: 'A fox of flat triangles as a woodcut: each has a tone of its own.',
    model: 'fox',
    preset: 'woodcut',
    size: [280, 340],
    camera: { position: [1.95, 1.1, 3.15], fov: 26 },
    lights: sun(1, 0.9, 0.35),
  },
  {
    ...flat,
    name: 'flat-street',
    sentence: 'A street to the horizon, engraved: lines stay apart far away.',
    model: 'street',
    preset: 'engraving',
    camera: { position: [0.03, -0.24, 1.15], fov: 40, target: [-0.02, -0.2, 0] },
    lights: sun(-0.5, 0.9, 0.8),
  },
];
