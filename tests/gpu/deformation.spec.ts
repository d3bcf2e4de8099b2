import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './deformingPage.js';
import { sharedModel, sparseMorphModel } from './gltfContent.js';
import { at, covered, difference, differing } from './pixels.js';
import { techniques } from './techniques.js';

const models = {
  'sparse morph targets': { content: sparseMorphModel, clip: 0, meshes: 1 },
  SimpleSkin: { content: () => sharedModel('SimpleSkin.gltf'), clip: 0, meshes: 1 },
  Fox: { content: () => sharedModel('Fox.glb'), clip: 1, meshes: 1 },
  CesiumMan: { content: () => sharedModel('CesiumMan.glb'), clip: 0, meshes: 1 },
  MorphStressTest: { content: () => sharedModel('MorphStressTest.gltf'), clip: 2, meshes: 2 },
  AnimatedMorphCube: { content: () => sharedModel('AnimatedMorphCube.gltf'), clip: 0, meshes: 1 },
};

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
              tilesPerObjectUnit: 2,
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
      quickIf(name === 'Fox' && technique === 'hatching'),
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
    quickIf(technique === 'engraving' || technique === 'triangle'),
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
          tilesPerObjectUnit: 2,
          side: THREE.DoubleSide,
          // The axis of a light belongs to the mesh, which an object turns and bones do not.
          ...(technique === 'engraving' && { direction: 'y', lineSpacing: 12 }),
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
      // Rounding shows on a hard stripe.
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
        const material = new HatchingMaterial({ tonalArtMap: stripedMap(), technique, tilesPerObjectUnit: 2 });
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

test('the shadow of a deforming mesh moves with it', async ({ page }) => {
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
  // The upper half of the tube casts its shadow here at rest, but not when bent.
  expect(at(straight!, 48, 56)[0]).toBeLessThan(10);
  expect(at(bent!, 48, 56)[0]).toBeGreaterThan(100);
  expect(at(bent!, 48, 44)[0]).toBeLessThan(10);
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
