import { type BufferGeometry, type Mesh, type PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { HatchingShadowMaterial } from 'three-hatching';
import { describe, expect, test } from 'vitest';
import { NodeSurroundings } from '../../../../src/command/draw/NodeSurroundings.js';
import { settingsFor, setUpScene } from '../../../../src/command/draw/setUpScene.js';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { addTrack, tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';
import { octahedronObj } from '../../../../tools/modelFiles/modelFiles.js';
import { cases } from '../../../selection.mjs';
import { pathsOf, ringsOf } from '../../vector/paths.js';
import { draw, optionsOf, useWorkFolder, work } from './drawing.js';

useWorkFolder();

describe('the stage', () => {
  async function staged(args: readonly string[], link?: string, glb?: Uint8Array<ArrayBuffer>) {
    const options = optionsOf(...args, ...(link ? ['--link', link] : []));
    const content = new Blob([glb ?? octahedronObj]);
    const name = glb ? 'a.glb' : 'a.obj';
    const read = await readModel([{ name, content }], () => {}, new NodeSurroundings(work));
    const { signal } = new AbortController();
    const { model } = await buildModel(read, () => {}, signal);
    const drawnWith = settingsFor(options, options.link, 'y');
    const stage = await setUpScene(model, drawnWith, options, [0], { signal, report: () => {} });
    stage.placeLights();
    return { ...stage, settings: drawnWith.settings };
  }
  const degrees = (place: Vector3): number[] => {
    const { theta, phi } = new Spherical().setFromVector3(place);
    return [(180 * theta) / Math.PI, 90 - (180 * phi) / Math.PI].map((angle) => Math.round(10 * angle) / 10);
  };

  /**
   * A model with a camera above its right side, which sees to its left and right, and with two lights.
   *
   * @param moves so that it stays a scene
   * @param before nodes before those of the camera
   */
  function seenAndLit(moves: boolean, ...before: object[]): Uint8Array<ArrayBuffer> {
    const builder = tetrahedron();
    const { json } = builder;
    const turned = (about: number[], angle: number): number[] => [
      ...about.map((value) => value * Math.sin(angle / 2)),
      Math.cos(angle / 2),
    ];
    const light = (index: number): object => ({ KHR_lights_punctual: { light: index } });
    json.cameras = [{ type: 'perspective', perspective: { yfov: 0.6, znear: 0.1, aspectRatio: 2 } }];
    json.extensions = {
      KHR_lights_punctual: {
        lights: [{ type: 'directional', intensity: 2 }, { type: 'point', intensity: 90 }, { type: 'directional' }],
      },
    };
    json.nodes.push(
      ...before,
      { name: 'side', camera: 0, translation: [9, 0, 0], rotation: turned([0, 1, 0], Math.PI / 2) },
      { rotation: turned([1, 0, 0], -Math.PI / 3), extensions: light(0) },
      { translation: [-3, 0, 0], extensions: light(1) },
      { extensions: light(2) },
    );
    json.scenes[0].nodes = json.nodes.map((_: object, i: number) => i);
    if (moves)
      addTrack(
        builder,
        'translation',
        builder.accessor(Float32Array.of(0, 1), 'SCALAR'),
        builder.accessor(new Float32Array(6), 'VEC3'),
      );
    return builder.glb() as Uint8Array<ArrayBuffer>;
  }

  test.each([false, true])('has the eye and the lights of a glTF file, moving: %s', async (moves) => {
    const glb = seenAndLit(moves);
    const { placed, lights, settings } = await staged(['--camera', 'side', '--sheet', '60x60'], undefined, glb);
    const { camera } = placed as { camera: PerspectiveCamera };
    expect(camera.position.x).toBeCloseTo(9 / Math.sqrt(3), 4);
    expect(placed.target.length()).toBeCloseTo(0, 5);
    // All that it sees to the sides is on a sheet that is as high as wide.
    expect(Math.tan((camera.fov * Math.PI) / 360)).toBeCloseTo(2 * Math.tan(0.3), 5);
    // The lamp of 90 at a distance of √3 radii gives more light than the sun.
    expect([settings.lightKind, settings.secondLight]).toEqual(['point', 'free']);
    expect([degrees(lights.position), degrees(lights.secondPosition)]).toEqual([
      [-90, 0],
      [0, 60],
    ]);
    const { position } = (await staged(['--view', 'auto', '--sheet', '60x60'], undefined, glb)).placed.camera;
    expect(position).toEqual(camera.position);
    const found = await staged(['--no-file-lights', '--view', '0 0'], undefined, glb);
    expect(found.settings.lightKind).toBe('directional');
    const own = await staged(['--light', '10 20'], undefined, glb);
    expect(degrees(own.lights.position)).toEqual([10, 20]);
  });

  test('passes over a camera that sees nothing of the model, and goes on to the views that show it best', async () => {
    const glb = seenAndLit(false, { camera: 0, translation: [9, 0, 0] });
    const positionOf = async (...args: string[]): Promise<number[]> =>
      (await staged(args, undefined, glb)).placed.camera.position.toArray();
    expect(await positionOf()).toEqual(await positionOf('--camera', 'side'));
    const [second, third] = [await positionOf('--view', 'auto2'), await positionOf('--view', 'auto3')];
    expect(second).not.toEqual(await positionOf('--camera', '1'));
    expect(third).not.toEqual(second);
  });

  const views: [string, number[], number[], number[]][] = [
    ['top', [0, 1, 0], [1, 0, 0], [0, 0, -1]],
    ['left', [-1, 0, 0], [0, 0, 1], [0, 1, 0]],
    ['0 -90', [0, -1, 0], [1, 0, 0], [0, 0, 1]],
    ['90 90', [0, 1, 0], [0, 0, -1], [-1, 0, 0]],
  ];
  test.each(cases(views.slice(1, 3), views))(
    'from %s is seen exactly, with and without perspective',
    {
      tags: ['more'],
    },
    async (view, toEye, right, up) => {
      for (const args of [[], ['--orthographic']]) {
        const { placed, scene } = await staged(['--view', view, '--no-shadows', ...args]);
        const { camera, target } = placed;
        camera.updateMatrixWorld();
        scene.updateMatrixWorld();
        const axes = [new Vector3(), new Vector3(), new Vector3()];
        camera.matrixWorld.extractBasis(axes[0], axes[1], axes[2]);
        for (const [i, expected] of [right, up, toEye].entries())
          for (const k of [0, 1, 2]) expect(axes[i].getComponent(k)).toBeCloseTo(expected[k], 6);
        const seen = camera.position.clone().sub(target).normalize();
        for (const k of [0, 1, 2]) expect(seen.getComponent(k)).toBeCloseTo(toEye[k], 6);
      }
    },
  );

  test('chooses the orientation of the sheet by the model, unless an option does', async () => {
    const wide = 'v -3 0 0\nv 3 0 0\nv 0 1 0.2\nv 0 0 -0.3\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n';
    const high = wide.replaceAll(/v (\S+) (\S+)/g, 'v $2 $1');
    const sizeOf = async (content: string, sheet: string): Promise<string> => {
      const { svgs } = await draw('a.obj', content, '--sheet', sheet, '--view', 'front', '--no-shadows', '--dpi', '20');
      return /width="([\d.]+)mm" height="([\d.]+)mm"/.exec(svgs[0])!.slice(1).join(' ');
    };
    expect(await sizeOf(wide, 'A6')).toBe('148 105');
    expect(await sizeOf(high, 'A6')).toBe('105 148');
    expect(await sizeOf(wide, 'A6 portrait')).toBe('105 148');
    expect(await sizeOf(high, '5x3in')).toBe('127 76.2');
  });

  test('has a shadow that ends on the sheet where it would be cut, and as the look says elsewhere', async () => {
    const fadeOf = async (...args: string[]): Promise<number> => {
      const { scene } = await staged(['--view', '0 20', ...args]);
      return (scene.getObjectByName('ground') as Mesh<BufferGeometry, HatchingShadowMaterial>).material.shadowFade;
    };
    const usual = await fadeOf('--light', '30 70');
    expect(usual).toBe(0.65);
    for (const lens of [[], ['--orthographic']]) {
      expect(await fadeOf('--light', '80 12', ...lens)).toBeGreaterThan(1.2 * usual);
      expect(await fadeOf('--light', '-80 6', ...lens)).toBeGreaterThan(1.2 * usual);
    }
  });

  test('has a shadow that has no line at the margins, however low the light, seen as one likes', {
    tags: ['all'],
  }, async () => {
    const post = (x: number, width: number, height: number): number[][] =>
      [0, 1].flatMap((up) =>
        [
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([dx, dz]) => [x + dx * width, up * height, dz * width]),
      );
    const corners = [...post(0, 0.05, 3), ...post(0, 0.3, 0.1)];
    const faces = [
      [0, 1, 2, 3],
      [7, 6, 5, 4],
      [0, 4, 5, 1],
      [1, 5, 6, 2],
      [2, 6, 7, 3],
      [3, 7, 4, 0],
    ];
    const lamp = [
      ...corners.map((corner) => `v ${corner.join(' ')}`),
      ...[0, 8].flatMap((first) => faces.map((face) => `f ${face.map((i) => first + i + 1).join(' ')}`)),
    ].join('\n');
    const views = [[], ['--view', '30 50'], ['--orthographic']];
    for (const [i, sheet] of ['60x40', '40x60'].entries())
      for (const [k, light] of ['90 8', '-90 8', '0 8', '135 25'].entries()) {
        const view = views[(i + k) % 3];
        const { svgs } = await draw('lamp.obj', lamp, '--sheet', sheet, '--margin', '4', '--light', light, ...view);
        const [width, height] = sheet.split('x').map(Number);
        const points = pathsOf(svgs[0]).flatMap(ringsOf).flat();
        expect(points.length).toBeGreaterThan(500);
        const near = points.filter((place, i) => Math.min(place - 4, (i % 2 === 0 ? width : height) - 4 - place) < 0.2);
        expect(near, `${sheet} ${light} ${view}`).toEqual([]);
      }
  });

  test('places eye and light by the options', async () => {
    const { placed, lights } = await staged(['--view', '25 8', '--light', '-45 40']);
    expect(degrees(placed.camera.position.clone().sub(placed.target))).toEqual([25, 8]);
    expect(degrees(lights.position)).toEqual([-45, 40]);
  });

  test('lights the model for its view if no option or link places the light', async () => {
    const [front, back] = [await staged(['--view', '0 10']), await staged(['--view', '180 10'])];
    expect(front.lights.position.z).toBeGreaterThan(0);
    expect(back.lights.position.z).toBeLessThan(0);
  });

  test('shows all of the model, with and without perspective, on any sheet', {
    tags: ['all'],
  }, async () => {
    for (const args of [[], ['--orthographic'], ['--sheet', '50x200'], ['--sheet', '200x50', '--orthographic']]) {
      const { placed, scene } = await staged([...args, '--no-shadows']);
      placed.camera.updateMatrixWorld();
      scene.updateMatrixWorld();
      const corners = [0, 1, 2].flatMap((axis) => [-1, 1].map((sign) => new Vector3().setComponent(axis, sign)));
      const reach = Math.max(
        ...corners.flatMap((corner) => {
          const { x, y } = corner.project(placed.camera);
          return [Math.abs(x), Math.abs(y)];
        }),
      );
      expect(reach).toBeLessThan(1);
      expect(reach).toBeGreaterThan(0.9);
    }
  });

  test('takes look, view and light from a link, but not its model', async () => {
    const link = 'model=dragon1&technique=engraving&lineSpacing=9&lightAzimuth=12&camera=3,1,2,0.5,0,0&ink=%23203080';
    const { placed, lights, settings } = await staged([], link);
    expect(placed.camera.position.toArray()).toEqual([3, 1, 2]);
    expect(placed.target.toArray()).toEqual([0.5, 0, 0]);
    expect(degrees(lights.position)).toEqual([12, 38]);
    expect(settings).toMatchObject({ model: 'file', lineSpacing: 9, ink: '#203080', shadows: 'off' });
    const other = await staged(['--view', '0 0', '--light', '5 6', '--preset', 'banknote', '--shadows'], link);
    expect(degrees(other.placed.camera.position.clone().sub(other.placed.target))).toEqual([0, 0]);
    expect(other.settings).toMatchObject({ lightAzimuth: 5, lightElevation: 6, shadows: 'on', ink: '#18332f' });
  });

  test('has the hatched field behind it that a link asks for', async () => {
    const link = 'technique=engraving&shadows=off&background=on';
    const { svgs } = await draw('a.obj', octahedronObj, '--link', link, '--sheet', '50x50', '--kind', 'pen');
    expect(svgs[0]).toContain('background"');
  });

  test('uses the up axis of the options or of the link', () => {
    const upAxis = (args: readonly string[], link?: string): string =>
      settingsFor(optionsOf(...args), link, 'z').settings.upAxis;
    expect(upAxis([])).toBe('z');
    expect(upAxis(['--up', '-x'])).toBe('-x');
    expect(upAxis([], 'technique=engraving')).toBe('z');
    expect(upAxis([], 'technique=engraving&upAxis=y')).toBe('y');
  });

  test('has no shadow on the ground without shadows', () => {
    expect(settingsFor(optionsOf('--no-shadows'), undefined, 'y').settings).toMatchObject({
      shadows: 'off',
      ground: 'none',
    });
    expect(settingsFor(optionsOf(), undefined, 'y').settings).toMatchObject({ shadows: 'on', ground: 'shadow' });
  });
});
