import type { Mutation } from '../Mutation.js';

/** Surface properties of files that change the drawing. */
export const meaning: readonly Mutation[] = [
  {
    name: 'blended surfaces hide what is behind them',
    file: 'src/viewer/files/scenes/resolveAlpha.ts',
    find: 'if (opacity < OPAQUE_ALPHA) Object',
    replace: 'if (opacity < 0) Object',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/scenes/resolveAlpha.test.ts',
      title: 'in a merged scene, glass has its own ranges, and invisible parts are ignored',
    },
  },
  {
    name: 'glass casts shadows',
    file: 'src/viewer/drawing/HatchedModel.ts',
    find: 'mesh.castShadow = shadows && !isGlass(mesh)',
    replace: 'mesh.castShadow = shadows',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/drawing/glass.test.ts',
      title: 'is glass: it lightens what is behind it, and casts and receives no shadow',
    },
  },
  {
    name: 'polygons are fans over their notches',
    file: 'src/viewer/files/mesh/triangulatePolygon.ts',
    find: 'if (!(turn > least)) return false;',
    replace: 'if (!(turn > -Infinity)) return false;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/mesh/triangulatePolygon.test.ts',
      title: 'with a hole that a slit joins to its outline keeps the hole open',
    },
  },
  {
    name: 'corners in the middle of sides are left out of polygons',
    file: 'src/viewer/files/mesh/triangulatePolygon.ts',
    find: 'if (side === -1) return [triangle];',
    replace: 'if (side >= -1) return [triangle];',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/mesh/triangulatePolygon.test.ts',
      title: 'keeps corners in the middle of its sides, so that neighbours meet it edge to edge',
    },
  },
  {
    name: 'smoothing groups of OBJ do not count',
    file: 'src/viewer/files/formats/writeFaces.ts',
    find: 'group = groupOf(line.slice(1).trim());',
    replace: 'group = -1;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/formats/readObj.test.ts',
      title: 'has edges between groups, whatever the materials, and groups last until the next one',
    },
  },
  {
    name: 'displaced meshes stay flat',
    file: 'src/scene/Displacer.ts',
    find: 'places.setXYZ(vertex, place.x, place.y, place.z);',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/displacement.test.ts',
      title: 'heights of a map are in the geometry that is hatched, with the slopes they make, and gone with the look',
    },
  },
];
