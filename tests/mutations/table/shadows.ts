import type { Mutation } from '../Mutation.js';

export const shadows: readonly Mutation[] = [
  {
    name: 'a shadow on the ground ends where a caster beside it would have it',
    file: 'src/viewer/sceneSetup/groundShadow.ts',
    find: 'Math.max(to - sooner, lowest)',
    replace: 'Math.max(2 * to, lowest)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/sceneSetup/fadeOnSheet.test.ts',
      title: 'has ended at every edge of',
    },
  },
  {
    name: 'only corners of triangles cast shadows that end on the sheet',
    file: 'src/viewer/sceneSetup/groundShadow.ts',
    find: 'for (let i = 0; parts > 1 && i < parts; i++)',
    replace: 'for (let i = 0; parts > 1 && i < 1; i++)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/sceneSetup/castersOf.test.ts',
      title: 'is a post from its foot to its top',
    },
  },
  {
    name: 'shadows of a model reach behind the light',
    file: 'src/scene/lighting/chooseLight.ts',
    find: 'points[i] - height * east',
    replace: 'points[i] + height * east',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/lighting/shadowOnSheet.test.ts',
      title: 'depends on the light, the ground and the sheet, and not on where the world has its origin',
    },
  },
  {
    name: 'points above a lamp cast shadows',
    file: 'src/viewer/sceneSetup/groundShadow.ts',
    find: 'if (dy >= 0) continue;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/sceneSetup/shadowOnGround.test.ts',
      title: 'a lamp casts longer shadows of more distant points, and none of points at its own height',
    },
  },
  {
    name: 'a light sees the wrong sides',
    file: 'src/vector/Bvh.ts',
    find: 'this.setRay(origin, way, CASTS_BACK, CASTS_FRONT);',
    replace: 'this.setRay(origin, way, CASTS_FRONT, CASTS_BACK);',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/vector/Bvh.test.ts',
      title: 'hits that hide a place from an eye at the far end, and hits that shade it',
    },
  },
  {
    name: 'strokes in shadow run as in light',
    file: 'shaders/chunks/lightOrientation.glsl',
    find: 'light.direction = acrossLight(light.direction);',
    replace: '',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/shadows.spec.ts',
      title: 'under one light strokes run across it in its shadow…hatching',
    },
  },
];
