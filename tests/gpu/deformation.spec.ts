import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './deformingPage.js';
import { sharedModel, sparseMorphModel } from './gltfContent.js';
import { at, covered, difference, differing } from './pixels.js';
import { kindsOfTechnique, techniques } from './techniques.js';

/** Meshes with skins and morph targets: the layout `pull`, the pre-pass, and strokes that stay on the surface. */

for (const technique of ['triangle', 'adjacency'] as const) {
  test(
    `the layouts pull and corner draw the same pixels: ${technique}`,
    quickIf(technique === 'adjacency'),
    async ({ page }) => {
      const pictures = await page.evaluate(async (technique) => {
        const { THREE, HatchingMaterial, prepareHatchingGeometry, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } =
          window.toolkit;
        const renderer = makeRenderer();
        const sheet = new THREE.PlaneGeometry(2, 2, 9, 9);
        for (let i = 0; i < 100; i++) sheet.attributes.position.setZ(i, 0.4 * Math.sin(5 * i));
        sheet.deleteAttribute('normal');
        const grouped = new THREE.BoxGeometry(1, 1, 1, 3, 3, 3).toNonIndexed();
        const tonalArtMap = stripedMap();
        const pictures: number[][][] = [];
        for (const source of [new THREE.TorusKnotGeometry(0.6, 0.25, 80, 14), sheet, grouped]) {
          for (const toneNormal of ['face', 'smooth'] as const) {
            const material = new HatchingMaterial({
              tonalArtMap,
              technique,
              toneNormal,
              tilesPerUnit: 2,
              side: THREE.DoubleSide,
            });
            const pair: number[][] = [];
            for (const layout of ['corner', 'pull'] as const) {
              const geometry = await prepareHatchingGeometry(source, { layout });
              const mesh = new THREE.Mesh(geometry, source === grouped ? source.groups.map(() => material) : material);
              mesh.rotation.set(0.4, 0.7, 0);
              pair.push(pixelsOf(sceneOf(mesh, sun()), renderer));
            }
            pictures.push(pair);
          }
        }
        return pictures;
      }, technique);
      expect(pictures).toHaveLength(6);
      for (const [corner, pull] of pictures) {
        expect(covered(corner!)).toBeGreaterThan(1500);
        expect(new Set(corner!).size).toBeGreaterThan(10);
        expect(difference(corner!, pull!)).toBe(0);
      }
    },
  );
}

test('the pre-pass writes what three.js computes on the processor: skin, morph targets and both', async ({ page }) => {
  const worst = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const { tubeGeometry, addMorphTargets, onBones, deviation } = window.deforming;
    const renderer = makeRenderer();
    const material = new HatchingMaterial({ tonalArtMap: greyMap() });
    const results: Record<string, ReturnType<typeof deviation>> = {};
    const show = (name: string, mesh: Parameters<typeof deviation>[1]) => {
      pixelsOf(sceneOf(mesh, sun()), renderer);
      results[name] = deviation(renderer, mesh);
    };
    for (const kind of ['skin', 'relative targets', 'absolute targets', 'skin and targets'] as const) {
      const source = tubeGeometry();
      if (kind !== 'skin') addMorphTargets(source, kind !== 'absolute targets');
      const geometry = await prepareHatchingGeometry(source, { adjacency: true });
      const isSkinned = kind.startsWith('skin');
      const mesh = isSkinned ? onBones(geometry, material) : new THREE.Mesh(geometry, material);
      if (isSkinned) (mesh as ReturnType<typeof onBones>).skeleton.bones[1].rotation.set(0.3, 0.2, 1.1);
      if (kind !== 'skin') mesh.morphTargetInfluences!.splice(0, 2, 0.7, -0.4);
      show(kind, mesh);
    }
    return results;
  });
  expect(Object.keys(worst)).toHaveLength(4);
  for (const [kind, { position, normal, moved }] of Object.entries(worst)) {
    expect(moved, `${kind}: movement`).toBeGreaterThan(0.05);
    expect(position, `${kind}: position`).toBeLessThanOrEqual(1e-5);
    expect(normal, `${kind}: normal`).toBeLessThanOrEqual(1e-5);
  }
});

function reportDrift(rest: number, deformed: number): void {
  const description = `rest ${rest.toExponential(1)}, deformed ${deformed.toExponential(1)} tiles per frame`;
  test.info().annotations.push({ type: 'drift', description });
}

const models = {
  'sparse morph targets': { content: sparseMorphModel, clip: 0, meshes: 1 },
  SimpleSkin: { content: () => sharedModel('SimpleSkin.gltf'), clip: 0, meshes: 1 },
  Fox: { content: () => sharedModel('Fox.glb'), clip: 1, meshes: 1 },
  CesiumMan: { content: () => sharedModel('CesiumMan.glb'), clip: 0, meshes: 1 },
  MorphStressTest: { content: () => sharedModel('MorphStressTest.gltf'), clip: 2, meshes: 2 },
  AnimatedMorphCube: { content: () => sharedModel('AnimatedMorphCube.gltf'), clip: 0, meshes: 1 },
};

for (const [name, { content, clip, meshes }] of Object.entries(models)) {
  test(
    `the pre-pass writes what three.js computes on the processor: ${name}`,
    quickIf(name === 'sparse morph targets' || name === 'SimpleSkin'),
    async ({ page }) => {
      const text = content();
      test.skip(text === null, 'the models of ../shared/models are not here');
      const worst = await page.evaluate(
        async ({ text, clip }) => {
          const { makeRenderer, pixelsOf } = window.toolkit;
          const model = await window.deforming.hatchedModel(text, clip);
          const renderer = makeRenderer();
          return [0, 0.4, 0.9].map((time) => {
            model.setTime(time);
            pixelsOf(model.scene, renderer);
            return model.meshes.map((mesh) => window.deforming.deviation(renderer, mesh));
          });
        },
        { text: text!, clip },
      );
      expect(worst[0]).toHaveLength(meshes);
      expect(Math.max(...worst.flat().map(({ moved }) => moved))).toBeGreaterThan(0.05);
      const most = Math.max(...worst.flat().map(({ position }) => position));
      test.info().annotations.push({ type: 'deviation', description: `${most.toExponential(1)} of the size` });
      for (const { position, normal } of worst.flat()) {
        expect(position).toBeLessThanOrEqual(1e-5);
        expect(normal).toBeLessThanOrEqual(1e-5);
      }
    },
  );
}

for (const name of ['CesiumMan', 'Fox'] as const) {
  for (const technique of techniques) {
    test(
      `strokes stay on a model that walks: ${name}, ${technique}`,
      quickIf(name === 'Fox' && technique === 'anchored'),
      async ({ page }) => {
        const { content, clip } = models[name];
        const text = content();
        test.skip(text === null, 'the models of ../shared/models are not here');
        const [rest, deformed] = await page.evaluate(
          async ({ text, clip, technique }) => {
            const drifts: ReturnType<typeof window.deforming.drift>[] = [];
            for (const strokeAnchor of ['rest', 'deformed'] as const) {
              const model = await window.deforming.hatchedModel(text, clip, { technique, strokeAnchor });
              const mesh = model.meshes[0] as Parameters<typeof window.deforming.drift>[1];
              drifts.push(window.deforming.drift(model.scene, mesh, (frame) => model.setTime(frame / 24), 12));
            }
            return drifts;
          },
          { text: text!, clip, technique },
        );
        expect(rest!.rigidTriangles).toBeGreaterThan(20);
        expect(rest!.drift, 'largest change from frame to frame, in tiles').toBeLessThanOrEqual(1e-4);
        expect(deformed!.drift).toBeGreaterThan(0.01);
        reportDrift(rest!.drift, deformed!.drift);
      },
    );
  }
}

for (const technique of techniques) {
  test(
    `strokes stay on a tube that bends: ${technique}`,
    quickIf(technique === 'engraved' || technique === 'triangle'),
    async ({ page }) => {
      const [rest, deformed] = await page.evaluate(async (technique) => {
        const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap } = window.toolkit;
        const { tubeGeometry, onBones, drift } = window.deforming;
        const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
        return (['rest', 'deformed'] as const).map((strokeAnchor) => {
          const material = new HatchingMaterial({ tonalArtMap: greyMap(), technique, strokeAnchor });
          const mesh = onBones(geometry, material);
          const scene = new THREE.Scene().add(mesh);
          const bone = mesh.skeleton.bones[1];
          return drift(scene, mesh, (frame) => bone.rotation.set(0.02 * frame, 0.03 * frame, 0.05 * frame), 10);
        });
      }, technique);
      expect(rest!.bones).toBe(2);
      expect(rest!.rigidTriangles).toBeGreaterThan(100);
      expect(rest!.drift, 'largest change from frame to frame, in tiles').toBeLessThanOrEqual(1e-4);
      // The paper to the letter; also shows that the measure sees strokes that swim.
      expect(deformed!.drift).toBeGreaterThan(0.01);
      reportDrift(rest!.drift, deformed!.drift);
    },
  );
}

for (const technique of techniques) {
  test(
    `what turns by its bones is drawn as what turns as an object: ${technique}`,
    quickIf(technique === 'adjacency'),
    async ({ page }) => {
      const [turned, skinned, literal] = await page.evaluate(async (technique) => {
        const { THREE, HatchingMaterial, prepareHatchingGeometry, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } =
          window.toolkit;
        const { tubeGeometry, onBones } = window.deforming;
        const renderer = makeRenderer();
        const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
        const material = new HatchingMaterial({
          tonalArtMap: stripedMap(),
          technique,
          tilesPerUnit: 2,
          side: THREE.DoubleSide,
          // The axis of a light belongs to the mesh, which an object turns and bones do not.
          ...(technique === 'engraved' && { lineField: 'y', lineSpacing: 12 }),
        });
        const light = sun();
        const object = new THREE.Mesh(geometry, material);
        const mesh = onBones(geometry, material);
        for (const thing of [object, mesh.skeleton.bones[0]]) {
          thing.rotation.set(0.5, 0.4, 0.9);
          thing.position.set(0.2, 0.1, -0.1);
          thing.scale.setScalar(1.2);
        }
        const pictures = [object, mesh].map((thing) => pixelsOf(sceneOf(thing, light), renderer));
        material.strokeAnchor = 'deformed';
        return [...pictures, pixelsOf(sceneOf(mesh, light), renderer)];
      }, technique);
      expect(covered(turned!)).toBeGreaterThan(1000);
      // On a hard stripe a rounding shows.
      expect(differing(turned!, skinned!, 8)).toBeLessThan(0.01 * covered(turned!));
      expect(differing(turned!, literal!, 8)).toBeGreaterThan(0.1 * covered(turned!));
    },
  );
}

for (const technique of ['triangle', 'adjacency'] as const) {
  test(
    `what morph targets turn, and stretch in its plane, is drawn as such an object: ${technique}`,
    quickIf(technique === 'triangle'),
    async ({ page }) => {
      const pictures = await page.evaluate(async (technique) => {
        const { THREE, HatchingMaterial, prepareHatchingGeometry, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } =
          window.toolkit;
        const renderer = makeRenderer();
        const material = new HatchingMaterial({ tonalArtMap: stripedMap(), technique, tilesPerUnit: 2 });
        const turn = new THREE.Matrix4().makeRotationX(0.6).multiply(new THREE.Matrix4().makeRotationZ(0.8));
        const cases = [
          [new THREE.TorusGeometry(0.6, 0.3, 14, 24), turn],
          [new THREE.PlaneGeometry(1.2, 1.2, 4, 4), turn.clone().scale(new THREE.Vector3(1.4, 0.6, 1))],
        ] as const;
        const pictures: number[][][] = [];
        for (const [source, matrix] of cases) {
          const position = source.attributes.position as InstanceType<typeof THREE.BufferAttribute>;
          source.morphAttributes.position = [position.clone().applyMatrix4(matrix)];
          const geometry = await prepareHatchingGeometry(source, { adjacency: true });
          const [object, morphed] = [0, 1].map((influence) => {
            const mesh = new THREE.Mesh(geometry, material);
            mesh.morphTargetInfluences![0] = influence;
            if (influence === 0) mesh.applyMatrix4(matrix);
            return pixelsOf(sceneOf(mesh, sun()), renderer);
          });
          pictures.push([object!, morphed!]);
        }
        return pictures;
      }, technique);
      for (const [object, morphed] of pictures) {
        expect(covered(object!)).toBeGreaterThan(800);
        expect(differing(object!, morphed!, 8)).toBeLessThan(0.01 * covered(object!));
      }
    },
  );
}

test('meshes that share a geometry and a material each have a pose of their own', async ({ page }) => {
  const [apart, together] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const { tubeGeometry, onBones } = window.deforming;
    const renderer = makeRenderer();
    const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
    const make = () => new HatchingMaterial({ tonalArtMap: stripedMap(), side: THREE.DoubleSide });
    const shared = make();
    const tubes = (material: () => InstanceType<typeof HatchingMaterial>) =>
      [-1, 0, 1].map((i) => {
        const mesh = onBones(geometry, material());
        mesh.skeleton.bones[1].rotation.z = i;
        mesh.position.x = 0.9 * i;
        mesh.scale.setScalar(0.6);
        return mesh;
      });
    const light = sun();
    const picture = (material: () => InstanceType<typeof HatchingMaterial>) => {
      const scene = sceneOf(light, ...tubes(material));
      // The pre-pass makes three.js forget which material it drew last. Without one, nothing is read again that is not told to be.
      pixelsOf(scene, renderer);
      pixelsOf(scene, renderer);
      return pixelsOf(scene, renderer);
    };
    return [picture(make), picture(() => shared)];
  });
  expect(covered(apart!)).toBeGreaterThan(1000);
  expect(difference(apart!, together!)).toBe(0);
});

test('the pre-pass runs once for a pose, whatever is drawn how often, and leaves the renderer as it was', async ({
  page,
}) => {
  const result = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, makeCamera, makeRenderer } =
      window.toolkit;
    const { tubeGeometry, onBones } = window.deforming;
    const source = tubeGeometry();
    const half = source.index!.count / 2;
    source.addGroup(0, half, 0);
    source.addGroup(half, half, 1);
    const geometry = await prepareHatchingGeometry(source, { adjacency: true });
    const materials = [0, 1].map(() => new HatchingMaterial({ tonalArtMap: greyMap() }));
    const mesh = onBones(geometry, materials as never);
    mesh.castShadow = true;
    const light = sun();
    light.castShadow = true;
    const scene = sceneOf(mesh, light);
    const renderer = makeRenderer();
    renderer.shadowMap.enabled = true;
    renderer.info.autoReset = false;
    const camera = makeCamera();
    const target = new THREE.WebGLRenderTarget(64, 64);
    const calls: Record<string, number> = {};
    const render = () => {
      renderer.info.reset();
      renderer.render(scene, camera);
      return renderer.info.render.points;
    };
    const turn = (angle: number) => {
      mesh.skeleton.bones[1].rotation.z = angle;
    };
    const points: number[] = [render(), render()];
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const counted = [
      'compileShader',
      'bufferData',
      'createTexture',
      'createFramebuffer',
      'createBuffer',
      'texSubImage2D',
    ];
    for (const name of counted) {
      const call = (Reflect.get(gl, name) as (...args: unknown[]) => unknown).bind(gl);
      calls[name] = 0;
      Reflect.set(gl, name, (...args: unknown[]) => {
        calls[name]++;
        return call(...args);
      });
    }
    turn(0.5);
    points.push(render(), render());
    const callsOfPose = { ...calls };
    // Into a target, through two cameras in parts of it, after a change of pose.
    turn(0.7);
    const parts = [0, 32].map((x) => Object.assign(makeCamera(), { viewport: new THREE.Vector4(x, 0, 32, 64) }));
    const both = new THREE.ArrayCamera(parts);
    both.position.z = 4;
    for (const part of parts) part.updateMatrixWorld();
    renderer.setRenderTarget(target);
    renderer.info.reset();
    const state = () => [
      renderer.getRenderTarget() === target,
      renderer.getActiveCubeFace(),
      renderer.autoClear,
      renderer.shadowMap.autoUpdate,
      renderer.xr.enabled,
      geometry.drawRange.start,
      geometry.drawRange.count,
    ];
    const before = state();
    const { frame } = renderer.info.render;
    renderer.render(scene, both);
    points.push(renderer.info.render.points);
    const after = state();
    const frames = renderer.info.render.frame - frame;
    const pixels = new Uint8Array(4 * 64 * 64);
    renderer.readRenderTargetPixels(target, 0, 0, 64, 64, pixels);
    const rows = Array.from({ length: 64 }, (_, y) => [...pixels.slice(256 * y, 256 * y + 256)]);
    const halves = [rows.map((row) => row.slice(0, 128)), rows.map((row) => row.slice(128))].map((half) =>
      half.flat().join(),
    );
    return {
      points,
      corners: geometry.attributes.position.count,
      callsOfPose,
      before,
      after,
      frames,
      sameHalves: halves[0] === halves[1],
      seen: new Set(pixels).size,
    };
  });
  expect(result.points).toEqual([result.corners, 0, result.corners, 0, result.corners]);
  expect(result.after).toEqual(result.before);
  expect(result.frames).toBe(1);
  expect(result.sameHalves).toBe(true);
  expect(result.seen).toBeGreaterThan(5);
  // The bone texture is all that goes to the graphics card, once a frame as in three.js.
  expect(result.callsOfPose).toEqual({
    compileShader: 0,
    bufferData: 0,
    createTexture: 0,
    createFramebuffer: 0,
    createBuffer: 0,
    texSubImage2D: 2,
  });
});

test('the shadow of what deforms moves with it', async ({ page }) => {
  const [straight, bent] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const { tubeGeometry, onBones } = window.deforming;
    const material = new HatchingMaterial({ tonalArtMap: greyMap(), side: THREE.DoubleSide });
    const mesh = onBones(await prepareHatchingGeometry(tubeGeometry(), { adjacency: true }), material);
    mesh.castShadow = true;
    mesh.scale.setScalar(0.4);
    mesh.position.set(1.2, 0, 1.2);
    const floor = new THREE.Mesh(
      await prepareHatchingGeometry(new THREE.PlaneGeometry(3, 3), { adjacency: true }),
      material,
    );
    floor.receiveShadow = true;
    const light = sun(Math.PI, [3, 0, 3]);
    light.castShadow = true;
    light.shadow.camera.near = 0.1;
    light.shadow.camera.far = 12;
    const renderer = makeRenderer();
    renderer.shadowMap.enabled = true;
    const scene = sceneOf(floor, mesh, light);
    return [0, 1.5].map((angle) => {
      mesh.skeleton.bones[1].rotation.x = angle;
      return pixelsOf(scene, renderer);
    });
  });
  // Where the upper half of the tube throws its shadow when it stands, and no longer when it is bent.
  expect(at(straight!, 48, 56)[0]).toBeLessThan(10);
  expect(at(bent!, 48, 56)[0]).toBeGreaterThan(100);
  expect(at(bent!, 48, 44)[0]).toBeLessThan(10);
});

test('a device without float targets moves what deforms, hatched as at rest, and says so, once', async ({
  page,
  pageProblems,
}) => {
  const [rest, bent] = await page.evaluate(async () => {
    const { HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer, whenChecked } =
      window.toolkit;
    const { tubeGeometry, onBones } = window.deforming;
    HatchingMaterial.silent = false;
    const { prototype } = WebGL2RenderingContext;
    const getExtension = prototype.getExtension as (name: string) => unknown;
    Reflect.set(prototype, 'getExtension', function (this: WebGL2RenderingContext, name: string) {
      return name === 'EXT_color_buffer_float' ? null : getExtension.call(this, name);
    });
    const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
    const mesh = onBones(geometry, new HatchingMaterial({ technique: 'adjacency', tonalArtMap: greyMap() }));
    mesh.name = 'tube';
    try {
      const renderer = makeRenderer();
      const scene = sceneOf(mesh, sun());
      const drawn = [0, 1].map((angle) => {
        mesh.skeleton.bones[1].rotation.z = angle;
        return pixelsOf(scene, renderer);
      });
      await whenChecked();
      return drawn;
    } finally {
      Reflect.set(prototype, 'getExtension', getExtension);
    }
  });
  expect(covered(bent!)).toBeGreaterThan(1000);
  expect(differing(rest!, bent!, 8)).toBeGreaterThan(500);
  const problems = pageProblems.splice(0).filter((problem) => problem.includes('HatchingMaterial'));
  expect(problems).toHaveLength(1);
  expect(problems[0]).toMatch(
    /the SkinnedMesh "tube".* is lit and hatched in its rest pose: .*EXT_color_buffer_float.*'anchored'/,
  );
});

test('a layout that cannot deform, and instances that each morph, are named in the console, once', {
  tag: '@all',
}, async ({ page, pageProblems }) => {
  await page.evaluate(async () => {
    const {
      THREE,
      HatchingMaterial,
      prepareHatchingGeometry,
      greyMap,
      sceneOf,
      sun,
      pixelsOf,
      makeRenderer,
      whenChecked,
    } = window.toolkit;
    const { tubeGeometry, addMorphTargets, onBones } = window.deforming;
    HatchingMaterial.silent = false;
    const renderer = makeRenderer();
    const material = new HatchingMaterial({ tonalArtMap: greyMap() });
    const corner = await prepareHatchingGeometry(tubeGeometry(), { layout: 'corner' });
    const source = addMorphTargets(new THREE.CylinderGeometry(0.3, 0.3, 1), true);
    const instanced = new THREE.InstancedMesh(await prepareHatchingGeometry(source, { adjacency: true }), material, 2);
    for (const i of [0, 1]) {
      instanced.setMatrixAt(i, new THREE.Matrix4().makeTranslation(i, 0, 0));
      instanced.setMorphAt(i, { morphTargetInfluences: [i, 0] } as unknown as InstanceType<typeof THREE.Mesh>);
    }
    const bent = onBones(corner, material);
    bent.name = 'bent';
    instanced.name = 'instances';
    const scene = sceneOf(bent, instanced, sun());
    pixelsOf(scene, renderer);
    pixelsOf(scene, renderer);
    await whenChecked();
  });
  const problems = pageProblems.splice(0);
  expect(problems).toHaveLength(2);
  expect(problems.join()).toMatch(/the SkinnedMesh "bent".* is lit and hatched in its rest pose: its layout 'corner'/);
  expect(problems.join()).toMatch(/the InstancedMesh "instances".* is lit and hatched in its rest pose: the instances/);
});

test('instances share the pose of their mesh', { tag: '@all' }, async ({ page }) => {
  const [separate, instanced] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const { addMorphTargets } = window.deforming;
    const source = addMorphTargets(new THREE.CylinderGeometry(0.3, 0.3, 1, 12, 6), true);
    const geometry = await prepareHatchingGeometry(source, { adjacency: true });
    const material = new HatchingMaterial({ tonalArtMap: greyMap() });
    const matrices = [-0.6, 0.6].map((x) => new THREE.Matrix4().makeRotationZ(x).setPosition(x, 0, 0));
    const meshes = matrices.map((matrix) => {
      const mesh = new THREE.Mesh(geometry, material);
      mesh.applyMatrix4(matrix);
      mesh.morphTargetInfluences![0] = 1;
      return mesh;
    });
    const instanced = new THREE.InstancedMesh(geometry, material, 2);
    instanced.morphTargetInfluences = [1, 0];
    matrices.forEach((matrix, i) => {
      instanced.setMatrixAt(i, matrix);
    });
    return [pixelsOf(sceneOf(sun(), ...meshes)), pixelsOf(sceneOf(sun(), instanced))];
  });
  expect(covered(separate!)).toBeGreaterThan(800);
  expect(differing(separate!, instanced!, 8)).toBeLessThan(0.01 * covered(separate!));
});

for (const what of ['geometry', 'material'] as const) {
  test(
    `disposing of the ${what} gives the pre-pass back, and drawing again brings it back`,
    quickIf(what === 'geometry'),
    async ({ page }) => {
      const [before, during, after, same] = await page.evaluate(async (what) => {
        const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer } =
          window.toolkit;
        const { tubeGeometry, onBones } = window.deforming;
        const renderer = makeRenderer();
        const tonalArtMap = greyMap();
        const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
        const scene = sceneOf(sun());
        const { memory } = renderer.info;
        // The map stays, whatever meshes are added and removed.
        pixelsOf(sceneOf(sun(), new THREE.Mesh(geometry, new HatchingMaterial({ tonalArtMap }))), renderer);
        const before = memory.textures;
        const mesh = onBones(geometry, new HatchingMaterial({ tonalArtMap }));
        mesh.skeleton.bones[1].rotation.z = 1;
        scene.add(mesh);
        const first = pixelsOf(scene, renderer);
        const during = memory.textures;
        mesh[what].dispose();
        const after = memory.textures;
        const again = pixelsOf(scene, renderer);
        return [before, during, after, first.every((x, i) => x === again[i]) && memory.textures === during];
      }, what);
      // Three targets of the pre-pass; bones belong to the skeleton; the textures of the layout to the geometry.
      expect(during).toBe((before as number) + 4);
      expect(after).toBe((during as number) - (what === 'geometry' ? 5 : 3));
      expect(same).toBe(true);
    },
  );
}

test('a geometry behind a proxy, as by ref of Vue, draws the same with the same pre-pass', { tag: '@all' }, async ({
  page,
}) => {
  const [plain, proxied, before, after] = await page.evaluate(async () => {
    const { HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const { tubeGeometry, onBones, reactive } = window.deforming;
    const renderer = makeRenderer();
    const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
    const mesh = onBones(geometry, new HatchingMaterial({ tonalArtMap: greyMap() }));
    mesh.skeleton.bones[1].rotation.z = 1;
    const scene = sceneOf(mesh, sun());
    pixelsOf(scene, renderer);
    const plain = pixelsOf(scene, renderer);
    const before = renderer.info.memory.textures;
    mesh.geometry = reactive(geometry);
    return [plain, pixelsOf(scene, renderer), before, renderer.info.memory.textures] as const;
  });
  expect(covered(plain)).toBeGreaterThan(1000);
  expect(difference(plain, proxied)).toBe(0);
  expect(after).toBe(before);
});

test('a material behind a proxy draws the same, with the same textures: meshes that deform, and in an environment', {
  tag: '@all',
}, async ({ page }) => {
  const { pictures, textures } = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const { tubeGeometry, onBones, reactive } = window.deforming;
    const sky = new THREE.DataTexture(
      new Float32Array(64 * 32 * 4).fill(0.3),
      64,
      32,
      THREE.RGBAFormat,
      THREE.FloatType,
    );
    sky.mapping = THREE.EquirectangularReflectionMapping;
    sky.needsUpdate = true;
    const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
    const map = greyMap();
    const pictures: number[][][] = [];
    const textures: number[][] = [];
    for (const environment of [null, sky]) {
      const renderer = makeRenderer();
      const mesh = onBones(geometry, new HatchingMaterial({ tonalArtMap: map }));
      mesh.skeleton.bones[1].rotation.z = 1;
      const still = new THREE.Mesh(geometry, mesh.material);
      still.position.x = 0.7;
      const scene = sceneOf(mesh, still, sun());
      scene.environment = environment;
      const show = () => {
        // The bone texture, made in the first frame, is a new pose in the second.
        pixelsOf(scene, renderer);
        return { pixels: pixelsOf(scene, renderer), textures: renderer.info.memory.textures };
      };
      const plain = show();
      mesh.material = still.material = reactive(new HatchingMaterial({ tonalArtMap: map }));
      const proxied = show();
      pictures.push([plain.pixels, proxied.pixels]);
      textures.push([plain.textures, proxied.textures]);
    }
    return { pictures, textures };
  });
  for (const [plain, proxied] of pictures) {
    expect(covered(plain)).toBeGreaterThan(1000);
    expect(difference(plain, proxied)).toBe(0);
  }
  for (const [plain, proxied] of textures) expect(proxied).toBe(plain);
});

test('two renderers deform the same mesh, and a lost context comes back', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  const collect = await page.context().newCDPSession(page);
  const [a, b, restored] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, stripedMap, sceneOf, sun, pixelsOf, makeRenderer } =
      window.toolkit;
    const { tubeGeometry, onBones } = window.deforming;
    const material = new HatchingMaterial({ tonalArtMap: stripedMap(), side: THREE.DoubleSide });
    const mesh = onBones(await prepareHatchingGeometry(tubeGeometry(), { adjacency: true }), material);
    mesh.skeleton.bones[1].rotation.z = 1;
    const scene = sceneOf(mesh, sun());
    const renderer = makeRenderer();
    // The bone texture, made in the first frame, is a new pose in the second.
    pixelsOf(scene, renderer);
    const a = pixelsOf(scene, renderer);
    const b = pixelsOf(scene, makeRenderer());
    const canvas = renderer.domElement;
    const heard = (name: string) => new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
    const lost = heard('webglcontextlost');
    renderer.forceContextLoss();
    await lost;
    const back = heard('webglcontextrestored');
    setTimeout(() => renderer.forceContextRestore(), 0);
    await back;
    const restored = pixelsOf(scene, renderer);
    // The mesh is released here. What was made for it in the lost context must not be freed in the restored one.
    const collected = { is: false, registry: new FinalizationRegistry(() => Object.assign(collected, { is: true })) };
    collected.registry.register(mesh, undefined);
    Object.assign(window, { collected, renderer });
    return [a, b, restored];
  });
  await expect
    .poll(async () => {
      await collect.send('HeapProfiler.collectGarbage');
      return page.evaluate(() => (window as unknown as { collected: { is: boolean } }).collected.is);
    })
    .toBe(true);
  expect(covered(a!)).toBeGreaterThan(1000);
  expect(difference(a!, b!)).toBe(0);
  expect(difference(a!, restored!)).toBe(0);
  expect(pageProblems.splice(0).filter((problem) => !/context (lost|restored)/i.test(problem))).toEqual([]);
});

for (const technique of kindsOfTechnique) {
  test(`after compileAsync the first frame builds no program, whatever the layout: ${technique}`, {
    tag: '@all',
  }, async ({ page, pageProblems }) => {
    const counts = await page.evaluate(async (technique) => {
      const { THREE, applyHatching, greyMap, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
      const { tubeGeometry, addMorphTargets, onBones } = window.deforming;
      type Hatched = Parameters<typeof onBones>[1];
      const paint = () => new THREE.MeshStandardMaterial() as unknown as Hatched;
      const models = {
        corner: new THREE.Mesh(new THREE.BoxGeometry(), paint()),
        pull: new THREE.Mesh(new THREE.BoxGeometry(), paint()),
        skinned: onBones(tubeGeometry(), paint()),
        morphed: new THREE.Mesh(addMorphTargets(new THREE.CylinderGeometry(0.3, 0.3, 1), true), paint()),
        both: onBones(addMorphTargets(tubeGeometry(), true), paint()),
      };
      const counts: Record<string, number[]> = {};
      for (const [name, mesh] of Object.entries(models)) {
        const renderer = makeRenderer();
        const layout = name === 'pull' ? ('pull' as const) : ('auto' as const);
        await applyHatching(mesh, { tonalArtMap: greyMap(), layout, material: { technique } });
        const scene = sceneOf(mesh, sun(), new THREE.AmbientLight());
        // The background has a program of its own.
        scene.background = null;
        await renderer.compileAsync(scene, makeCamera());
        const compiled = renderer.info.programs!.length;
        const first = pixelsOf(scene, renderer);
        counts[name] = [compiled, renderer.info.programs!.length];
        // What was prepared early is drawn anew in the pose of the frame.
        const again = pixelsOf(scene, renderer);
        const fresh = pixelsOf(scene);
        counts[name].push(first.filter((x, i) => x !== again[i] || x !== fresh[i]).length);
      }
      return counts;
    }, technique);
    const prePass = technique === 'adjacency' ? 1 : 0;
    expect(counts).toEqual({
      corner: [1, 1, 0],
      pull: [1, 1, 0],
      skinned: [1 + prePass, 1 + prePass, 0],
      morphed: [1 + prePass, 1 + prePass, 0],
      both: [1 + prePass, 1 + prePass, 0],
    });
    // three.js reports when it must wait for programs.
    expect(pageProblems.splice(0).filter((problem) => !/KHR_parallel_shader_compile/.test(problem))).toEqual([]);
  });
}

test('a mesh that is let go takes its pre-pass with it', async ({ page }) => {
  const collect = await page.context().newCDPSession(page);
  await page.evaluate(async () => {
    const { HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const { tubeGeometry, onBones } = window.deforming;
    const renderer = makeRenderer();
    const geometry = await prepareHatchingGeometry(tubeGeometry(), { adjacency: true });
    const material = new HatchingMaterial({ tonalArtMap: greyMap() });
    const draw = () => {
      const mesh = onBones(geometry, material);
      pixelsOf(sceneOf(mesh, sun()), renderer);
      mesh.skeleton.dispose();
    };
    draw();
    const one = renderer.info.memory.textures;
    draw();
    draw();
    // Kept alive, as an application would.
    Object.assign(window, { kept: { renderer, geometry, material, one, before: renderer.info.memory.textures } });
  });
  const textures = () =>
    page.evaluate(() => {
      const { renderer, one, before } = (
        window as unknown as {
          kept: { renderer: { info: { memory: { textures: number } } }; one: number; before: number };
        }
      ).kept;
      return { now: renderer.info.memory.textures, one, before };
    });
  expect((await textures()).before).toBe((await textures()).one + 6);
  await expect
    .poll(async () => {
      await collect.send('HeapProfiler.collectGarbage');
      const { now, one } = await textures();
      return now <= one;
    })
    .toBe(true);
});

test('rays and bounds follow the pose', async ({ page }) => {
  const [straight, bent] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const { tubeGeometry, onBones } = window.deforming;
    const mesh = onBones(await prepareHatchingGeometry(tubeGeometry(), { adjacency: true }), new HatchingMaterial());
    const ray = new THREE.Raycaster(new THREE.Vector3(0, 0.8, 5), new THREE.Vector3(0, 0, -1));
    return [0, Math.PI / 2].map((angle) => {
      mesh.skeleton.bones[1].rotation.z = angle;
      mesh.updateMatrixWorld(true);
      mesh.computeBoundingBox();
      mesh.computeBoundingSphere();
      const { x, y } = mesh.boundingBox!.getSize(new THREE.Vector3());
      return { hits: ray.intersectObject(mesh).length, x, y, radius: mesh.boundingSphere!.radius };
    });
  });
  expect(straight!.hits).toBeGreaterThan(0);
  expect(bent!.hits).toBe(0);
  expect(bent!.x).toBeGreaterThan(straight!.x + 0.3);
  expect(bent!.y).toBeLessThan(straight!.y - 0.3);
  expect(bent!.radius).toBeLessThan(2);
});
