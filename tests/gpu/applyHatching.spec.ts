import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { at, covered, difference, differing, isGround, SIZE } from './pixels.js';
import { hasSharedModels, NO_MODELS, serveSharedModels } from './sharedModels.js';
import { kindsOfTechnique } from './techniques.js';
import { test } from './toolkitPage.js';

/** Whole scenes in one call: the pictures they give, and what is left on the graphics card. */

test('groups keep their colours, nested meshes their places', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, applyHatching, greyMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const geometry = new THREE.PlaneGeometry(1, 1, 2, 1);
    geometry.clearGroups();
    geometry.addGroup(0, 6, 1);
    geometry.addGroup(6, 6, 0);
    const inner = new THREE.Mesh(
      geometry,
      [0xff0000, 0x0000ff].map((color) => new THREE.MeshStandardMaterial({ color })),
    );
    inner.position.x = 1;
    const outer = new THREE.Group().add(inner);
    outer.position.set(-1, 0, 0);
    outer.scale.setScalar(2);
    outer.position.x = -2;
    await applyHatching(outer, { tonalArtMap: greyMap() });
    return pixelsOf(sceneOf(outer, sun(Math.PI, [0, 0, 1])));
  });
  expect(at(pixels, 30, 48)).toEqual([0, 0, 255]);
  expect(at(pixels, 66, 48)).toEqual([255, 0, 0]);
});

for (const technique of kindsOfTechnique) {
  test(
    `instances and separate meshes give the same pixels: ${technique}`,
    quickIf(technique !== 'hatching'),
    async ({ page }) => {
      const [separate, instanced] = await page.evaluate(async (technique) => {
        const { THREE, applyHatching, stripedMap, sceneOf, sun, pixelsOf } = window.toolkit;
        const geometry = new THREE.TorusGeometry(0.4, 0.2, 12, 20);
        const paint = new THREE.MeshLambertMaterial({ color: 0xffaa88 });
        const matrices = [
          new THREE.Matrix4().makeRotationX(0.7).setPosition(-0.7, 0.3, 0),
          new THREE.Matrix4().makeRotationY(1.1).setPosition(0.6, -0.3, 0.2),
        ];
        const separate = new THREE.Group();
        const instanced = new THREE.InstancedMesh(geometry, paint, 2);
        matrices.forEach((matrix, i) => {
          const one = new THREE.Mesh(geometry, paint);
          one.applyMatrix4(matrix);
          separate.add(one);
          instanced.setMatrixAt(i, matrix);
        });
        const options = { tonalArtMap: stripedMap(), material: { technique } };
        const pictures: number[][] = [];
        for (const root of [separate, instanced]) {
          await applyHatching(root, options);
          // Engraved lines run on from mesh to mesh; instances have lines of their own, and here the meshes shall too.
          root.traverse(({ userData }) => delete userData.hatchingField);
          pictures.push(pixelsOf(sceneOf(sun(), root)));
        }
        return pictures;
      }, technique);
      expect(covered(separate)).toBeGreaterThan(800);
      // Rounding differs between the two ways, and on a hard stripe a rounding shows.
      expect(differing(separate, instanced, 8)).toBeLessThan(0.01 * covered(separate));
    },
  );

  test(
    `strokes are as large on a scaled object as on one modelled in that size: ${technique}`,
    quickIf(technique === 'adjacency'),
    async ({ page }) => {
      const [modelled, scaled, unscaled] = await page.evaluate(async (technique) => {
        const { THREE, applyHatching, stripedMap, sceneOf, sun, pixelsOf } = window.toolkit;
        const show = async (size: number, scale: number, material: object = {}) => {
          const mesh = new THREE.Mesh(new THREE.SphereGeometry(size, 48, 32), new THREE.MeshBasicMaterial());
          const root = new THREE.Group().add(new THREE.Group().add(mesh));
          mesh.scale.setScalar(scale / 4);
          root.scale.setScalar(4);
          await applyHatching(root, {
            tonalArtMap: stripedMap(),
            tilesPerWorldUnit: 2,
            material: { technique, ...material },
          });
          return pixelsOf(sceneOf(root, sun()));
        };
        return [await show(1, 1), await show(0.05, 20), await show(0.05, 20, { tilesPerObjectUnit: 2 })];
      }, technique);
      expect(covered(modelled)).toBeGreaterThan(800);
      // Stripes fall on other pixels where positions are rounded otherwise.
      expect(differing(modelled, scaled, 8)).toBeLessThan(0.03 * covered(modelled));
      expect(differing(modelled, unscaled, 8)).toBeGreaterThan(0.2 * covered(modelled));
    },
  );
}

test('a mirrored object is lit and covered as one modelled mirrored', async ({ page }) => {
  const [mirrored, modelled] = await page.evaluate(async () => {
    const { THREE, applyHatching, greyMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const shape = () => new THREE.ConeGeometry(0.7, 1.6, 24).rotateZ(0.5).translate(0.3, 0, 0);
    const mirror = new THREE.Mesh(shape(), new THREE.MeshStandardMaterial({ color: 0xddeeff }));
    mirror.scale.x = -1;
    const geometry = shape().scale(-1, 1, 1);
    const { array } = geometry.index!;
    for (let i = 0; i < array.length; i += 3) [array[i], array[i + 1]] = [array[i + 1], array[i]];
    const model = new THREE.Mesh(geometry, mirror.material);
    const pictures: number[][] = [];
    for (const mesh of [mirror, model]) {
      await applyHatching(mesh, { tonalArtMap: greyMap(), material: { technique: 'adjacency' } });
      pictures.push(pixelsOf(sceneOf(mesh, sun())));
    }
    return pictures;
  });
  expect(covered(mirrored)).toBeGreaterThan(800);
  expect(differing(mirrored, modelled, 2)).toBeLessThan(0.005 * covered(mirrored));
});

test('a batch is hatched as it is by anchored', { tag: '@all' }, async ({ page }) => {
  const [batched, separate] = await page.evaluate(async () => {
    const { THREE, applyHatching, greyMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const geometry = new THREE.SphereGeometry(0.5, 16, 12);
    const paint = new THREE.MeshBasicMaterial();
    const batch = new THREE.BatchedMesh(2, 400, 2000, paint);
    const id = batch.addGeometry(geometry);
    const group = new THREE.Group();
    for (const x of [-0.6, 0.6]) {
      const matrix = new THREE.Matrix4().makeTranslation(x, 0, 0);
      batch.setMatrixAt(batch.addInstance(id), matrix);
      const mesh = new THREE.Mesh(geometry, paint);
      mesh.applyMatrix4(matrix);
      group.add(mesh);
    }
    const pictures: number[][] = [];
    for (const root of [batch, group]) {
      await applyHatching(root, { tonalArtMap: greyMap(), tilesPerWorldUnit: 2, material: { technique: 'hatching' } });
      pictures.push(pixelsOf(sceneOf(root, sun())));
    }
    return pictures;
  });
  expect(covered(batched)).toBeGreaterThan(800);
  expect(differing(batched, separate, 8)).toBeLessThan(0.01 * covered(batched));
});

for (const technique of kindsOfTechnique) {
  test(
    `restore brings the picture back, dispose leaves nothing on the graphics card: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const { before, hatched, restored, memory } = await page.evaluate(async (technique) => {
        const { THREE, TonalArtMap, applyHatching, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
        const renderer = makeRenderer();
        const map = new THREE.DataTexture(new Uint8Array([200, 100, 100, 255]), 1, 1);
        map.needsUpdate = true;
        const morphed = new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshStandardMaterial({ map }));
        morphed.geometry.morphAttributes.position = [morphed.geometry.attributes.position.clone()];
        morphed.updateMorphTargets();
        morphed.position.x = -0.8;
        const plain = new THREE.Mesh(new THREE.SphereGeometry(0.6), new THREE.MeshStandardMaterial({ color: 'teal' }));
        plain.position.x = 0.8;
        const root = new THREE.Group().add(morphed, plain);
        const scene = sceneOf(root, sun());
        const use = () => ({ ...renderer.info.memory, programs: renderer.info.programs!.length });
        const before = pixelsOf(scene, renderer);
        const memory = [use()];
        // Lines sized on the object would fade into their tone in such a small picture.
        const sized = technique === 'hatching' ? { screenSpaceShare: 0 } : {};
        const handle = await applyHatching(root, { material: { technique, ...sized } });
        const hatched = pixelsOf(scene, renderer);
        memory.push(use());
        handle.restore();
        const restored = pixelsOf(scene, renderer);
        handle.dispose();
        // The map of the style, which is everybody's.
        TonalArtMap.shared().dispose();
        memory.push(use());
        return { before, hatched, restored, memory };
      }, technique);
      expect(differing(before, hatched, 8)).toBeGreaterThan(500);
      expect(difference(before, restored)).toBe(0);
      expect(memory[1].geometries).toBe(memory[0].geometries + 2);
      expect(memory[1].textures).toBeGreaterThan(memory[0].textures);
      expect(memory[1].programs).toBeGreaterThan(memory[0].programs);
      // Resources shared by all hatching materials, such as the blank texel, may stay.
      expect(memory[2].geometries).toBe(memory[0].geometries);
      expect(memory[2].programs).toBe(memory[0].programs);
      expect(memory[2].textures - memory[0].textures).toBeLessThanOrEqual(1);
    },
  );
}

test.describe('loaded glTF', () => {
  test.skip(!hasSharedModels(), NO_MODELS);

  for (const [name, meshes, materials] of [
    ['Lantern.gltf', 3, 1],
    ['VertexColorTest.glb', 2, 2],
    ['CesiumMan.glb', 1, 1],
  ] as const) {
    test(
      `${name} is drawn in its colours, in ink, where it was drawn before`,
      quickIf(name === 'VertexColorTest.glb'),
      async ({ page }) => {
        await serveSharedModels(page);
        const [before, after, counts] = await page.evaluate(async (name) => {
          const { THREE, GLTFLoader, applyHatching, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
          const { scene: root } = await new GLTFLoader().loadAsync(`models/${name}`);
          const box = new THREE.Box3().setFromObject(root, true);
          const { center, radius } = box.getBoundingSphere(new THREE.Sphere());
          const holder = new THREE.Group().add(root);
          root.position.sub(center);
          holder.scale.setScalar(1.3 / radius);
          const renderer = makeRenderer();
          const scene = sceneOf(holder, sun(Math.PI, [2, 1, 1]));
          const before = pixelsOf(scene, renderer);
          const { materials, skipped } = await applyHatching(holder, {
            material: { ink: 'magenta', technique: 'hatching' },
          });
          let meshes = 0;
          holder.traverse((object) => {
            if ('isMesh' in object) meshes++;
          });
          return [before, pixelsOf(scene, renderer), { meshes, materials: materials.length, skipped: skipped.length }];
        }, name);
        expect(counts).toEqual({ meshes, materials, skipped: 0 });
        expect(covered(before)).toBeGreaterThan(400);
        expect(covered(after) / covered(before)).toBeCloseTo(1, 1);
        let [ink, coloured] = [0, 0];
        for (let y = 0; y < SIZE; y++) {
          for (let x = 0; x < SIZE; x++) {
            const [r, g, b] = at(after, x, y) as [number, number, number];
            if (r > 180 && g < 60 && b > 180) ink++;
            else if (!isGround([r, g, b]) && Math.abs(r - b) > 40) coloured++;
          }
        }
        expect(ink).toBeGreaterThan(20);
        expect(coloured).toBeGreaterThan(40);
      },
    );
  }
});

test('outlines come with a scene, go with it, and leave nothing on the graphics card', { tag: '@all' }, async ({
  page,
}) => {
  const result = await page.evaluate(async () => {
    const { THREE, applyHatching, greyMap, sceneOf, sun, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    const root = new THREE.Group();
    const paint = new THREE.MeshLambertMaterial();
    const torus = new THREE.Mesh(new THREE.TorusGeometry(0.5, 0.2, 12, 24), paint);
    torus.layers.set(1);
    const boxes = new THREE.InstancedMesh(new THREE.BoxGeometry(0.3, 0.3, 0.3), paint, 2);
    boxes.setMatrixAt(1, new THREE.Matrix4().makeTranslation(0.8, 0, 0));
    root.add(torus, boxes);
    const scene = sceneOf(sun(), root);
    const camera = makeCamera();
    camera.layers.enable(1);
    renderer.render(scene, camera);
    const before = { ...renderer.info.memory, children: torus.children.length };
    const hatched = await applyHatching(root, {
      tonalArtMap: greyMap(),
      outlines: { outlineWidth: 3, creaseLength: 0 },
    });
    renderer.compile(scene, camera);
    renderer.render(scene, camera);
    const [first] = hatched.outlines;
    const during = {
      outlines: hatched.outlines.length,
      onTorus: torus.children[0] === first,
      layers: first.layers.mask === torus.layers.mask,
      width: first.material.outlineWidth,
      drawn: hatched.outlines.every(({ geometry }) => geometry.drawRange.count > 0),
      textures: renderer.info.memory.textures,
    };
    // A clone of the scene has outlines of its own, on its own meshes.
    const clone = root.clone();
    const clonedMesh = clone.children[0];
    const rebound = (clonedMesh.children[0] as typeof first).mesh === clonedMesh;
    hatched.restore();
    const restored = { children: torus.children.length, material: torus.material === paint };
    hatched.dispose();
    renderer.render(scene, camera);
    const after = { ...renderer.info.memory, children: torus.children.length };
    return { before, during, rebound, restored, after };
  });
  const { before, during, rebound, restored, after } = result;
  expect(during).toMatchObject({ outlines: 2, onTorus: true, layers: true, width: 3, drawn: true });
  expect(during.textures).toBeGreaterThan(before.textures);
  expect(rebound).toBe(true);
  expect(restored).toEqual({ children: 0, material: true });
  expect(after.textures).toBeLessThanOrEqual(during.textures - 4);
  expect(after.geometries).toBe(before.geometries);
});

test('outlines that cannot be are refused before anything changes', async ({ page }) => {
  const messages = await page.evaluate(async () => {
    const { THREE, applyHatching } = window.toolkit;
    const mesh = new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshBasicMaterial());
    const { geometry } = mesh;
    const tried = [{ outlines: 3 }, { outlines: { outlineWidth: 0 } }, { outlines: { featureAngle: 7 } }];
    const messages: string[] = [];
    for (const options of tried) {
      await applyHatching(mesh, options as object).catch((error: Error) => messages.push(error.message));
    }
    if (mesh.geometry !== geometry || mesh.children.length > 0) throw new Error('the mesh was changed');
    return messages;
  });
  expect(messages).toEqual([
    expect.stringMatching(/outlines must be true, false or an object/),
    expect.stringMatching(/outlineWidth: 0 is not a number in \(0, ∞\)/),
    expect.stringMatching(/outlines\.featureAngle is 7/),
  ]);
});

test('with a renderer, geometries with morph targets are uploaded ahead, too', async ({ page, pageProblems }) => {
  const outcome = await page.evaluate(async () => {
    const { THREE, applyHatching, greyMap, sceneOf, sun, makeRenderer, makeCamera } = window.toolkit;
    const geometry = new THREE.BoxGeometry();
    geometry.morphAttributes.position = [geometry.getAttribute('position').clone()];
    const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial());
    sceneOf(mesh, sun());
    const options = { renderer: makeRenderer(), camera: makeCamera(), tonalArtMap: greyMap() };
    const hatched = await applyHatching(mesh, { ...options, material: { technique: 'hatching' } });
    return hatched.materials.length;
  });
  expect(outcome).toBe(1);
  expect(pageProblems.splice(0).filter((problem) => !/KHR_parallel_shader_compile/.test(problem))).toEqual([]);
});

test('with a renderer and a camera nothing is left to compile or upload for the first frame', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  const result = await page.evaluate(async () => {
    const { THREE, applyHatching, greyMap, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    const camera = makeCamera();
    const ball = new THREE.Mesh(new THREE.SphereGeometry(0.5, 64, 32), new THREE.MeshStandardMaterial());
    // Lights below the root count once.
    ball.add(new THREE.PointLight());
    const boxes = new THREE.InstancedMesh(new THREE.BoxGeometry(0.2, 0.2, 0.2), new THREE.MeshStandardMaterial(), 2);
    const root = new THREE.Group().add(ball, boxes);
    const scene = sceneOf(root, sun());
    scene.background = null;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const calls: string[] = [];
    const progress: number[] = [];
    const { material } = ball;
    const hatched = await applyHatching(root, {
      renderer,
      camera,
      tonalArtMap: greyMap(),
      material: { technique: 'hatching' },
      outlines: true,
      onProgress: (value) => {
        progress.push(value);
        // The scene is hidden until everything is ready.
        if (ball.material !== material) calls.push('changed early');
      },
    });
    const programs = renderer.info.programs!.length;
    const [link, upload] = [gl.linkProgram, gl.bufferData];
    gl.linkProgram = (program) => {
      calls.push('linkProgram');
      link.call(gl, program);
    };
    gl.bufferData = ((target: number, data: ArrayBufferView<ArrayBuffer>, usage: number) => {
      if (data?.byteLength > 4000) calls.push(`bufferData of ${data.byteLength}`);
      upload.call(gl, target, data, usage, 0);
    }) as typeof gl.bufferData;
    const first = pixelsOf(scene, renderer, camera);
    Object.assign(gl, { linkProgram: link, bufferData: upload });
    const fresh = pixelsOf(scene, makeRenderer(), camera);
    const differing = first.filter((value, i) => value !== fresh[i]).length;
    const ink = first.filter((value, i) => i % 4 < 3 && value < 128 && first[i - (i % 4) + 3] > 0).length;
    const used = programs > 0 && renderer.info.programs!.length === programs;
    hatched.dispose();
    return { calls, differing, ink, used, progress, programs: renderer.info.programs!.length };
  });
  expect(result).toMatchObject({ calls: [], differing: 0, used: true });
  expect(result.ink).toBeGreaterThan(100);
  expect(result.programs).toBeLessThanOrEqual(1);
  expect(result.progress.at(-1)).toBeCloseTo(1);
  expect(result.progress).toEqual([...result.progress].sort((a, b) => a - b));
  expect(pageProblems.splice(0).filter((problem) => !/KHR_parallel_shader_compile/.test(problem))).toEqual([]);
});
