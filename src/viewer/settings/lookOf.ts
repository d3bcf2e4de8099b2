import { MathUtils } from 'three';
import type { HatchingMaterialParameters } from 'three-hatching';
import { needsMap } from 'three-hatching/facts';
import {
  backgroundLook,
  groundShadowLook,
  materialLook,
  materialSizes,
  type OutlineLook,
  outlineLook,
} from './materialLook.js';
import { SETTING_KEYS, SETTINGS, type Settings } from './settings.js';
import { type LightPlace, placeOfLight, placeOfSecondLight, UPRIGHT } from './settingValues.js';

/** Values of settings that the node materials do not draw, with a description of each. */
const LACKS: readonly { [Key in keyof Settings]: [Key, readonly Settings[Key][], string] }[keyof Settings][] = [
  ['technique', ['adjacency', 'adjacencyCrisp', 'triangle'], 'this technique'],
  ['debugView', ['blendFactors', 'tone', 'frames'], 'views for checking'],
  ['background', ['on'], 'a hatched background'],
];

/** Describes what the node materials do not draw yet of these settings; undefined if they draw all of it. */
export function lackOfNodes(settings: Settings): string | undefined {
  if (settings.compare !== 'none') return 'a comparison';
  return LACKS.find(([key, values]) => values.some((value) => value === settings[key]))?.[2];
}

/** A drawing in the units of the library and of three.js, derived from settings once per change. */
export interface Look {
  /** The parameters of the materials, without sizes. */
  readonly drawn: HatchingMaterialParameters;
  /** The same for the compared technique; undefined without a comparison. */
  readonly compared: HatchingMaterialParameters | undefined;
  /** The sizes of the materials. Those in pixels are in CSS pixels. */
  readonly sizes: HatchingMaterialParameters;
  /** The parameters of outlines, in CSS pixels. */
  readonly outlines: OutlineLook;
  readonly showsOutlines: boolean;
  /** Whether surfaces have the model's colours and pictures instead of plain paper. */
  readonly showsSurfaceColors: boolean;
  /** The kind of ground; none in debug views. */
  readonly ground: Settings['ground'];
  readonly showsGround: boolean;
  /** The properties of a ground that shows shadows alone. */
  readonly groundShadow: Readonly<ReturnType<typeof groundShadowLook>>;
  /** The parameters of the background, in CSS pixels; undefined if it is hidden. */
  readonly background: ReturnType<typeof backgroundLook>;
  /** The colour of the empty paper. */
  readonly paper: string;
  /** Rotations about x, y and z, in radians, that turn the model's up axis to +y. */
  readonly upright: readonly [number, number, number];
  readonly lights: Lighting;
  readonly needsMap: boolean;
  /** What the node materials do not draw yet, from {@link lackOfNodes}. */
  readonly lackOfNodes: string | undefined;
  /** Identifies the shader programs: looks that differ only in numbers and colours have the same key. */
  readonly programs: string;
}

/** Settings that shader programs can depend on: all with a list of choices. */
const CHOICES = SETTING_KEYS.filter((name) => SETTINGS[name].kind === 'choice');

/** Derives the look from settings. */
export function lookOf(settings: Settings): Look {
  const shown = withBoldnessAndDensity(settings);
  const { compare, ground, paper, upAxis } = shown;
  const isDebugView = shown.debugView !== 'none';
  const drawn = materialLook(shown);
  const compared = compare === 'none' ? undefined : materialLook(shown, compare);
  return {
    drawn,
    compared,
    sizes: materialSizes(shown),
    outlines: outlineLook(shown),
    // Both sides of a comparison have outlines, so that only the strokes differ. Debug views have none.
    showsOutlines: shown.outlines === 'on' && !isDebugView,
    showsSurfaceColors: shown.surfaceColors === 'shown',
    ground,
    showsGround: ground !== 'none' && !isDebugView,
    groundShadow: groundShadowLook(shown),
    background: isDebugView ? undefined : backgroundLook(shown),
    paper,
    upright: UPRIGHT[upAxis],
    lights: lightingOf(shown),
    needsMap: needsMap(drawn) || (compared !== undefined && needsMap(compared)),
    lackOfNodes: lackOfNodes(shown),
    programs: CHOICES.map((name) => shown[name]).join(),
  };
}

/** The lights of a drawing. Intensities are in three.js's units, angles in radians. */
export interface Lighting {
  readonly kind: Settings['lightKind'];
  readonly place: LightPlace;
  readonly intensity: number;
  /** Angle between the axis of a spot light and the edge of its cone. */
  readonly spotAngle: number;
  /** The soft share of a spot light's cone (three.js's `penumbra`). */
  readonly spotPenumbra: number;
  readonly second: { readonly place: LightPlace; readonly intensity: number } | undefined;
  readonly castsShadows: boolean;
  /** Whether the lights move with the viewer instead of staying with the model. */
  readonly isWithViewer: boolean;
}

/**
 * At an intensity of π, a white surface that faces the light has tone 0: bare paper.
 *
 * @param strength percent of that intensity
 */
const intensityOf = (strength: number): number => (Math.PI * strength) / 100;

/** The lights for some settings. */
function lightingOf(settings: Settings): Lighting {
  const second = placeOfSecondLight(settings);
  return {
    kind: settings.lightKind,
    place: placeOfLight(settings),
    intensity: intensityOf(settings.lightStrength),
    spotAngle: MathUtils.degToRad(settings.spotAngle) / 2,
    spotPenumbra: settings.spotSoftness / 100,
    second: second && { place: second, intensity: intensityOf(settings.secondStrength) },
    castsShadows: settings.shadows === 'on',
    isWithViewer: settings.lightFollows === 'viewer',
  };
}

/**
 * Applies the controls Boldness and Density to the settings that they scale. Bolder strokes are wider and farther apart, so that coverage
 * stays the same; density changes coverage as the strength of the light would.
 */
export function withBoldnessAndDensity(settings: Settings): Settings {
  const size = settings.boldness / 100;
  const cover = settings.density / 100;
  if (size === 1 && cover === 1) return settings;
  return {
    ...settings,
    strokeWidth: settings.strokeWidth * size,
    lineSpacing: settings.lineSpacing * size,
    outlineWidth: settings.outlineWidth * size,
    tilesPerObjectUnit: settings.tilesPerObjectUnit / size,
    lightStrength: settings.lightStrength / cover,
    secondStrength: settings.secondStrength / cover,
  };
}
