/**
 * The figures of the paper by Suarez et al. that are drawn again, and some of what goes beyond it, as plain data. The page, the
 * documentation and the tests read this table.
 */
import type { HatchingMaterialOptions, HatchingOutlineParameters, PresetName, StrokeStyleName } from 'three-hatching';
import { PRESET_LABELS, PRESET_NAMES } from '../../src/viewer/settings/presetLabels.js';
import type { FigureModelName } from './figureModels.js';

/** The look of a part of a panel's model, where it differs from the rest of the figure. */
export interface Look
  extends Partial<
    Pick<
      HatchingMaterialOptions,
      | 'technique'
      | 'tilesPerObjectUnit'
      | 'strokeAngle'
      | 'toneModel'
      | 'toneSteps'
      | 'shininess'
      | 'toneNormal'
      | 'debugView'
      | 'color'
      | 'ink'
      | 'strokeLayers'
      | 'crossAngle'
      | 'direction'
      | 'lineSpacing'
      | 'screenSpaceShare'
      | 'strokeWidth'
      | 'crossFrom'
    >
  > {
  style?: StrokeStyleName;
  /** A preset of the library, which the other fields of the look change. */
  preset?: PresetName;
  /** Contours, borders and creases, by the parameters that differ from their defaults or from those of the preset; `false` for none. */
  outlines?: HatchingOutlineParameters | false;
}

type Triple = readonly [x: number, y: number, z: number];

export interface PanelLight {
  /** Its position. The centre of the model is the origin. */
  position: Triple;
  /** A directional light (`sun`, the default) or a point light (`lamp`). */
  kind?: 'sun' | 'lamp';
  /** Light that the surroundings reflect, as a share of the light itself. */
  reflected?: number;
}

/** Settings that the panels of a figure share. Each panel may override them. */
interface PanelDefaults {
  model: FigureModelName;
  light: PanelLight;
  look?: Look;
  /** Direction from the model to the eye. */
  view?: Triple;
  /** Size of the picture relative to one that the model just fills. */
  zoom?: number;
}

/** One picture of a figure. */
export interface Panel extends Partial<PanelDefaults> {
  /** Unique within the figure, in the style of a file name. */
  name: string;
  /** The text below it. */
  label: string;
  /** The looks of parts that differ from the rest of the model. */
  parts?: Record<string, Look>;
  /** Rotation of the model about its up axis, in degrees. */
  turned?: number;
}

export interface Row {
  /** The text above the row. */
  label?: string;
  panels: readonly Panel[];
}

export interface Figure extends PanelDefaults {
  /** The number in the paper by Suarez et al., or a letter for a figure that is not in it. */
  number: number | 'A' | 'B' | 'C' | 'D';
  title: string;
  /** One sentence on what the figure shows in the paper by Suarez et al.; undefined for a figure that is not in it. */
  inThePaper?: string;
  /** One sentence on what is shown here. */
  here: string;
  rows: readonly Row[];
  /** Rows are side by side on a wide page. */
  beside?: true;
  /** Width divided by height of each panel. */
  aspect: number;
  /** The axis the light is turned about: up (`y`, the default), or the line of sight (`z`) for flat models. */
  turnAxis?: 'y' | 'z';
  /** Anchored strokes are not offered, because the figure explains the paper's own technique. */
  fixedTechnique?: true;
}

const degrees = (angle: number) => (angle * Math.PI) / 180;

const SIDES = {
  left: { label: 'light from the left', position: [-2, 0.7, 1.1] },
  front: { label: 'from the front', position: [-0.5, 0.9, 2] },
  above: { label: 'from above', position: [0.2, 2.1, 0.7] },
  right: { label: 'from the right', position: [2, 0.7, 1.1] },
} as const satisfies Record<string, { label: string; position: Triple }>;

const flat = { light: { position: [1.5, 1, 1.2], reflected: 0 }, view: [0, 0, 1], turnAxis: 'z' } as const;

/** Shows the blend factors of c. Its neighbour is drawn without blending. */
const contributions = { centre: { debugView: 'blendFactors' }, others: { technique: 'triangle' } } as const;

const liveries = {
  cafe: { shell: { color: '#c9573f' }, legs: { color: '#c79a62' }, cushion: { style: 'stippling', color: '#f0dfb4' } },
  garden: {
    shell: { style: 'crossHatching', color: '#93ac86' },
    legs: { color: '#a9a49a' },
    cushion: { style: 'stippling', color: '#dcc48a' },
  },
} as const satisfies Record<string, Record<string, Look>>;

export const FIGURES: readonly Figure[] = [
  {
    ...flat,
    number: 4,
    title: 'Four triangles',
    inThePaper:
      'Four adjacent triangles with different normals break the strokes at their edges (a); blended, they fade over (b).',
    here: 'The same: without blending every edge shows; with it strokes run out into grey before the edge.',
    model: 'fourTriangles',
    aspect: 1.1,
    look: { tilesPerObjectUnit: 1.2 },
    rows: [
      {
        panels: [
          { name: 'a', label: '(a) without blending', look: { technique: 'triangle' } },
          { name: 'b', label: '(b) with blending' },
        ],
      },
    ],
  },
  {
    ...flat,
    number: 8,
    title: 'Contributions',
    inThePaper:
      'What each neighbour contributes to the triangle in the middle, what that does to the strokes, and the sum.',
    here: 'The same, a neighbour a row: its contribution in colour, the two triangles blended, and at the right none, one and all.',
    model: 'fourTriangles',
    aspect: 1.1,
    fixedTechnique: true,
    look: { tilesPerObjectUnit: 1.2 },
    rows: [
      {
        panels: [
          { name: 'alpha-factor', label: 'contribution of α', model: 'cAndAlpha', parts: contributions },
          { name: 'alpha', label: 'applied', model: 'cAndAlpha' },
          { name: 'none', label: 'without blending', look: { technique: 'triangle' } },
        ],
      },
      {
        panels: [
          { name: 'beta-factor', label: 'of β', model: 'cAndBeta', parts: contributions },
          { name: 'beta', label: 'applied', model: 'cAndBeta' },
          { name: 'centre', label: 'blended in the middle only', parts: { others: { technique: 'triangle' } } },
        ],
      },
      {
        panels: [
          { name: 'gamma-factor', label: 'of γ', model: 'cAndGamma', parts: contributions },
          { name: 'gamma', label: 'applied', model: 'cAndGamma' },
          { name: 'all', label: 'blended everywhere' },
        ],
      },
    ],
  },
  {
    number: 9,
    title: 'Lighting techniques',
    inThePaper: 'The number of the texture is determined per fragment, with different lighting techniques.',
    here: 'Tone as grey and the strokes that it asks for, for four techniques: bands are hard with toon, soft with the rest.',
    model: 'teapot',
    aspect: 1.45,
    beside: true,
    light: { position: [-1.6, 1.3, 1.3], reflected: 0 },
    view: [0.1, 0.3, 1],
    look: { tilesPerObjectUnit: 2, toneNormal: 'smooth' },
    rows: (
      [
        ['lambert', 'Lambert', {}],
        ['halfLambert', 'half Lambert', {}],
        ['phong', 'Phong', { shininess: 24 }],
        ['toon', 'toon, four tones', { toneSteps: 4 }],
      ] as const
    ).map(([toneModel, label, look]) => ({
      panels: [
        { name: `${toneModel}-tone`, label, look: { ...look, toneModel, debugView: 'tone' } },
        { name: toneModel, label: 'its strokes', look: { ...look, toneModel } },
      ],
    })),
  },
  {
    number: 10,
    title: 'All effects on a head',
    inThePaper:
      'A face under every effect: strokes turned about the normal, scaled, lit from several places, and the model turned.',
    here: 'Suzanne stands in for the face; the lamp of the third row is near, so its strokes spread from it, and the last row is in colour.',
    model: 'suzanne',
    aspect: 1,
    light: { position: [1, 1.2, 1.5] },
    view: [0.05, 0.1, 1],
    look: { tilesPerObjectUnit: 1.3 },
    rows: [
      {
        label: 'Strokes turned about the normal of each triangle',
        panels: [0, 30, 60, 90].map((angle) => ({
          name: `rotation-${angle}`,
          label: `${angle}°`,
          // The paper turns strokes clockwise.
          look: { strokeAngle: degrees(-angle) },
        })),
      },
      {
        label: 'Strokes scaled',
        panels: [0.3, 0.6, 1.2, 2.4].map((tilesPerObjectUnit) => ({
          name: `scale-${tilesPerObjectUnit}`,
          label: `${tilesPerObjectUnit} tiles to a unit`,
          look: { tilesPerObjectUnit },
        })),
      },
      {
        label: 'Light in several places',
        panels: Object.entries(SIDES).map(([name, { label, position }]) => ({
          name: `light-${name}`,
          label,
          light: { kind: 'lamp', position },
        })),
      },
      {
        label: 'Model turned, light fixed',
        panels: [-50, -20, 20, 50].map((angle) => ({
          name: `model-${angle}`,
          label: `${angle < 0 ? '−' : ''}${Math.abs(angle)}°`,
          turned: angle,
          zoom: 0.84,
          look: { color: '#e0a878', ink: '#4a1f14' },
        })),
      },
    ],
  },
  {
    number: 11,
    title: 'Fine geometry',
    inThePaper: 'A hand under several lights: geometric details are always visible.',
    here: 'A hand of 2,314 triangles from the WebXR input profiles: knuckles, fingers and thumb stay legible from every side.',
    model: 'hand',
    aspect: 0.8,
    light: { position: SIDES.left.position },
    view: [0.1, 0.05, 1],
    look: { tilesPerObjectUnit: 1.6, strokeAngle: degrees(90) },
    rows: [
      {
        panels: Object.entries(SIDES).map(([name, { label, position }]) => ({ name, label, light: { position } })),
      },
    ],
  },
  {
    number: 12,
    title: 'Materials as maps',
    inThePaper: 'The Stanford dragon with several lights and maps that represent different materials.',
    here: 'The same scan in 47,794 triangles: a style a row, a light a column.',
    model: 'dragon',
    aspect: 1.3,
    light: { position: SIDES.left.position },
    look: { tilesPerObjectUnit: 1.6, strokeAngle: degrees(90) },
    rows: (
      [
        ['hatching', 'Pen'],
        ['crossHatching', 'Cross-hatching'],
        ['stippling', 'Stippling'],
        ['woodcut', 'Woodcut'],
        ['charcoal', 'Charcoal'],
      ] as const
    ).map(([style, label]) => ({
      label,
      panels: (['left', 'above', 'right'] as const).map((side) => ({
        name: `${style}-${side}`,
        label: SIDES[side].label,
        light: { position: SIDES[side].position },
        look: { style },
      })),
    })),
  },
  {
    number: 13,
    title: 'Maps and colour',
    inThePaper:
      'A chair whose parts have maps and colours of their own, under several lights; the first column is not blended.',
    here: 'A shell chair made by code, in two liveries: unblended, strokes stop at every triangle of the shell; blended, they run on.',
    model: 'chair',
    aspect: 0.8,
    light: { position: SIDES.left.position },
    view: [0.75, 0.5, 1],
    look: { tilesPerObjectUnit: 1.2 },
    rows: Object.entries(liveries).map(([name, parts]) => ({
      panels: [
        {
          name: `${name}-unblended`,
          label: 'without blending',
          parts,
          look: { technique: 'triangle' },
        },
        ...(['left', 'above', 'right'] as const).map((side) => ({
          name: `${name}-${side}`,
          label: SIDES[side].label,
          light: { position: SIDES[side].position },
          parts,
        })),
      ],
    })),
  },
  {
    number: 14,
    title: 'Orientation',
    inThePaper: 'The Stanford bunny with strokes towards the light, and tangent to its direction.',
    here: 'The same: on the left strokes point at the light, on the right they run around it.',
    model: 'bunny',
    aspect: 1.1,
    light: { position: [-1.2, 1.4, 1.2] },
    view: [0, 0.1, 1],
    look: { tilesPerObjectUnit: 1.6 },
    rows: [
      {
        panels: [
          { name: 'towards', label: 'towards the light', look: { strokeAngle: degrees(90) } },
          { name: 'tangent', label: 'tangent to it', look: { strokeAngle: 0 } },
        ],
      },
    ],
  },
  {
    number: 'A',
    title: 'Anchored strokes',
    here: 'Strokes anchored to the object instead of to triangles stay whole on a scan of 47,794 triangles; crossed, they draw darks that stay open.',
    model: 'dragon',
    aspect: 1.3,
    fixedTechnique: true,
    light: { position: SIDES.left.position },
    look: { tilesPerObjectUnit: 1.8, strokeAngle: degrees(90) },
    rows: [
      {
        panels: [
          { name: 'adjacency', label: 'as in the paper' },
          { name: 'hatching', label: 'anchored to the dragon', look: { technique: 'hatching', tilesPerObjectUnit: 3 } },
          {
            name: 'crossed',
            label: 'crossing by tone',
            look: { technique: 'hatching', tilesPerObjectUnit: 3, strokeLayers: 'tone', crossFrom: 0.35 },
          },
        ],
      },
    ],
  },
  {
    number: 'B',
    title: 'Engraved lines',
    here: 'Lines that never break and swell with the tone: cut around the light, towards it, and across an axis of the hand, where they stay while the light turns.',
    model: 'hand',
    aspect: 0.8,
    fixedTechnique: true,
    light: { position: SIDES.left.position, reflected: 0 },
    view: [0.1, 0.05, 1],
    look: { preset: 'engraving', direction: 'light' },
    rows: [
      {
        panels: [
          { name: 'light', label: 'around the light' },
          { name: 'towards', label: 'towards it', look: { direction: 'towardsLight' } },
          { name: 'fixed', label: 'fixed on the hand', look: { direction: 'y' } },
          { name: 'crossed', label: 'crossing early, at 90°', look: { crossFrom: 0.2, crossAngle: degrees(90) } },
        ],
      },
    ],
  },
  {
    number: 'C',
    title: 'Contours and creases',
    here: 'The same engraving without outlines, with contours that are heavier in the shade, and with suggestive contours drawn by a freer hand.',
    model: 'suzanne',
    aspect: 1.1,
    fixedTechnique: true,
    light: { position: SIDES.left.position, reflected: 0 },
    view: [0.3, 0.1, 1],
    look: { preset: 'engraving' },
    rows: [
      {
        panels: [
          { name: 'none', label: 'none', look: { outlines: false } },
          { name: 'contours', label: 'contours and creases' },
          {
            name: 'suggestive',
            label: 'suggestive',
            look: { outlines: { weights: { suggestiveContours: 0.6 }, wobble: 4 } },
          },
        ],
      },
    ],
  },
  {
    number: 'D',
    title: 'Presets',
    here: 'One hand under one light in the ten presets of the library: material, outlines and map in one object each.',
    model: 'hand',
    aspect: 0.8,
    fixedTechnique: true,
    light: { position: SIDES.left.position, reflected: 0 },
    view: [0.1, 0.05, 1],
    rows: [PRESET_NAMES.slice(0, 5), PRESET_NAMES.slice(5)].map((names) => ({
      panels: names.map((preset) => ({ name: preset, label: PRESET_LABELS[preset], look: { preset } })),
    })),
  },
];
