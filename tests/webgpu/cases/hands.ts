import { BasicShadowMap, HemisphereLight, PCFShadowMap, SpotLight, VSMShadowMap } from 'three';
import {
  type HatchingMaterialParameters,
  type HatchingShadowMaterialParameters,
  prepareHatchingGeometry,
} from 'three-hatching';
import { type ExampleHandName, exampleHand } from 'three-hatching/hands';
import { type Casting, lamp, onGround, spot } from '../ground.js';
import { type KnotStage, knot } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

const ROWS = { technique: 'pen', composition: { exposure: 1 }, strokeWidth: 2 } as const;

/** A hand with other numbers of its own. */
function handOf(name: ExampleHandName, numbers: object = {}): ReturnType<typeof exampleHand> {
  const hand = exampleHand(name);
  return { ...hand, numbers: { ...hand.numbers, ...numbers } };
}

const drawn = async (kit: Kit, parameters: HatchingMaterialParameters): Promise<KnotStage> =>
  knot(await kit.hatching({ ...ROWS, ...parameters }));

/** The same knot with lines along its form. */
async function formed(kit: Kit, parameters: HatchingMaterialParameters): Promise<KnotStage> {
  const stage = await drawn(kit, { direction: 'form', ...parameters });
  stage.mesh.geometry = await prepareHatchingGeometry(stage.mesh.geometry, { form: true });
  return stage;
}

/** The same scene with fewer or more of its light. */
function lit<Shown extends KnotStage>(stage: Shown, intensity: number): Shown {
  stage.sun.intensity = intensity;
  return stage;
}

/** A knot on a ground, under the sun and another light, which casts a shadow of its own. */
async function underTwo(kit: Kit, parameters: HatchingMaterialParameters, light: Casting): Promise<KnotStage> {
  const stage = await onGround(kit, { ...ROWS, ...parameters });
  stage.scene.add(light);
  return lit(stage, 1.2);
}

/** Whole strokes of hands. */
export const cases: readonly SceneCase[] = [
  { name: 'a brush along the form', show: (kit) => formed(kit, { hand: handOf('brush') }) },
  {
    name: 'bundles across the form, in darks',
    async show(kit) {
      const hand = handOf('finePen', { clustering: 1, crossingFrom: 0.3, crossingAngle: 60 });
      return lit(await formed(kit, { hand, direction: 'acrossForm' }), 0.4);
    },
  },
  {
    name: 'layers along the form that are turned clockwise',
    async show(kit) {
      const hand = handOf('feltTip', { crossingFrom: 0.2, crossingAngle: -50 });
      return lit(await formed(kit, { hand, screenSpaceShare: 1 }), 0.8);
    },
  },
  {
    name: 'bundles across an axis, sized on the screen',
    show: (kit) =>
      drawn(kit, { hand: handOf('reedPen', { clustering: 0.8 }), direction: 'slant', screenSpaceShare: 1 }),
  },
  {
    name: 'strokes beside each other along the form, sized on the screen',
    show: (kit) => formed(kit, { hand: handOf('finePen', { overlap: 0.4 }), screenSpaceShare: 1 }),
  },
  {
    name: 'a needle along an axis, in lights',
    async show(kit) {
      return lit(await drawn(kit, { hand: handOf('etchingNeedle'), direction: 'x', strokeWidth: 1 }), 5);
    },
  },
  {
    name: 'a woodcut towards several lights',
    async show(kit): Promise<Stage> {
      const stage = await drawn(kit, { hand: handOf('woodcut', { crossingFrom: 0.4 }), direction: 'towardsLight' });
      const lamp = new SpotLight(0xffe0c0, 30, 0, 0.5, 0.4);
      lamp.position.set(-2, 1, 3);
      stage.scene.add(lamp, lamp.target, new HemisphereLight(0xffffff, 0x404040, 0.8));
      return stage;
    },
  },
  {
    name: 'strokes that turn in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...ROWS, hand: handOf('quill'), direction: 'light', shadowStrokes: 'reorient' }),
  },
  {
    name: 'a shadow alone',
    shadows: PCFShadowMap,
    async show(kit) {
      const ground: HatchingShadowMaterialParameters = { technique: 'pen', hand: handOf('ballpoint'), strokeWidth: 1 };
      return onGround(kit, { ...ROWS, direction: 'y' }, await kit.shadows(ground));
    },
  },
  {
    name: 'strokes that end at a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...ROWS, hand: handOf('quill'), direction: 'light', shadowStrokes: 'tone' }),
  },
  {
    name: 'bundles along the form that end at two shadows',
    shadows: BasicShadowMap,
    async show(kit) {
      const hand = handOf('reedPen', { clustering: 0.8, crossingFrom: 0.3 });
      const stage = await underTwo(kit, { hand, direction: 'form', shadowStrokes: 'tone' }, lamp());
      stage.mesh.geometry = await prepareHatchingGeometry(stage.mesh.geometry, { form: true });
      return stage;
    },
  },
  {
    name: 'strokes that cross in a shadow and end there',
    shadows: VSMShadowMap,
    show: (kit) => underTwo(kit, { hand: handOf('brush'), direction: 'slant', shadowStrokes: 'cross' }, spot()),
  },
  {
    name: 'another hand in the place of one',
    async show(kit): Promise<Stage> {
      const stage = await drawn(kit, { hand: handOf('brush'), direction: 'light' });
      return {
        ...stage,
        change() {
          Object.assign(stage.mesh.material, { hand: handOf('crayon', { crossingFrom: 0.3 }) });
        },
      };
    },
  },
  {
    name: 'the strokes of the pen in the place of a hand',
    async show(kit): Promise<Stage> {
      // Loads the code of the pen.
      (await kit.hatching(ROWS)).dispose();
      const stage = await drawn(kit, { hand: handOf('brush'), direction: 'light' });
      return {
        ...stage,
        change() {
          Object.assign(stage.mesh.material, { hand: null });
        },
      };
    },
  },
];
