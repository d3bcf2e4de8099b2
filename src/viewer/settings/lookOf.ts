import type { HatchingMaterialParameters } from 'three-hatching';
import { needsMap } from 'three-hatching/facts';
import { backgroundLook } from './compositionLook.js';
import { type SHADOW_NUMBERS, shadowNumbers } from './groundShadow.js';
import { type Lighting, lightingOf } from './lighting.js';
import { materialLook, materialSizes } from './materialLook.js';
import { type OutlineLook, outlineLook } from './outlineLook.js';
import { SETTING_KEYS, SETTINGS, type Settings } from './settings.js';
import { UPRIGHT } from './settingValues.js';
import { withBoldnessAndDensity } from './withBoldnessAndDensity.js';

/** Values of settings that materials of nodes do not draw, and what that is in words. */
const LACKS: readonly { [Key in keyof Settings]: [Key, readonly Settings[Key][], string] }[keyof Settings][] = [
  ['technique', ['adjacency', 'adjacencyCrisp', 'triangle'], 'this technique'],
  ['debugView', ['blendFactors', 'tone', 'frames'], 'views for checking'],
  ['background', ['on'], 'a hatched background'],
];

/** What of a drawing materials of nodes do not draw yet, in words; undefined if they draw all of it. */
export function lackOfNodes(settings: Settings): string | undefined {
  if (settings.compare !== 'none') return 'a comparison';
  return LACKS.find(([key, values]) => values.some((value) => value === settings[key]))?.[2];
}

/** What settings say of a drawing, in the units of the library and of three.js. It is worked out once for each change. */
export interface Look {
  /** The parameters of the materials, without their sizes. */
  readonly drawn: HatchingMaterialParameters;
  /** The same for the technique that is compared with it; undefined if none is. */
  readonly compared: HatchingMaterialParameters | undefined;
  /** The sizes of the materials. Those that are measured in pixels are in CSS pixels. */
  readonly sizes: HatchingMaterialParameters;
  /** The parameters of outlines, in CSS pixels. */
  readonly outlines: OutlineLook;
  readonly showsOutlines: boolean;
  /** Whether surfaces have the colours and pictures of the model, and not those of paper. */
  readonly showsSurfaceColors: boolean;
  /** What the model stands on, and whether that is to be seen: debug views look at the model. */
  readonly ground: Settings['ground'];
  readonly showsGround: boolean;
  /** The properties of a ground that shows shadows alone. */
  readonly groundShadow: Readonly<
    Required<Pick<HatchingMaterialParameters, 'toneModel' | (typeof SHADOW_NUMBERS)[number]>>
  >;
  /** The properties of the background, in CSS pixels; undefined if there is none to be seen. */
  readonly background: ReturnType<typeof backgroundLook>;
  /** The colour of what nothing is drawn on. */
  readonly paper: string;
  /** Rotations about x, y and z, in radians, that turn the model's up axis to the top. */
  readonly upright: readonly [number, number, number];
  readonly lights: Lighting;
  readonly needsMap: boolean;
  /** What of it materials of nodes do not draw yet, as {@link lackOfNodes} says. */
  readonly lackOfNodes: string | undefined;
  /** A key of the programs that draw it: looks that differ in numbers and colours only have the same. */
  readonly programs: string;
}

/** The settings that programs depend on are among those that are chosen from a list. */
const CHOICES = SETTING_KEYS.filter((name) => SETTINGS[name].kind === 'choice');

/** The look that settings ask for. */
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
    // Both sides of a comparison have them, so that only the strokes differ. In debug views they would hide what is looked for.
    showsOutlines: shown.outlines === 'on' && !isDebugView,
    showsSurfaceColors: shown.surfaceColors === 'shown',
    ground,
    showsGround: ground !== 'none' && !isDebugView,
    groundShadow: { toneModel: 'shadow', ...shadowNumbers(shown) },
    background: isDebugView ? undefined : backgroundLook(shown),
    paper,
    upright: UPRIGHT[upAxis],
    lights: lightingOf(shown),
    needsMap: needsMap(drawn) || (compared !== undefined && needsMap(compared)),
    lackOfNodes: lackOfNodes(shown),
    programs: CHOICES.map((name) => shown[name]).join(),
  };
}
