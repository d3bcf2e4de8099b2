import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { at, centre, covered, differing, isGround } from './pixels.js';
import { kindsOfTechnique } from './techniques.js';
import { test } from './toolkitPage.js';

/** The material in scenes of applications: features of three.js that besideLambert.spec.ts does not compare. */

for (const technique of kindsOfTechnique) {
  test(
    `an InstancedMesh gives the pixels of separate meshes, whatever the instance matrix: ${technique}`,
    quickIf(technique === 'hatching'),
    async ({ page }) => {
      const [separate, instanced] = await page.evaluate(async (technique) => {
        const { THREE, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf } = window.toolkit;
        const mesh = await hatchedMesh(new THREE.TorusGeometry(0.4, 0.2, 12, 20), {
          tonalArtMap: stripedMap(),
          technique,
        });
        const matrices = [
          new THREE.Matrix4().makeRotationX(0.7).setPosition(-0.7, 0.3, 0),
          new THREE.Matrix4()
            .makeRotationY(1.1)
            .scale(new THREE.Vector3(0.8, 0.8, 0.8))
            .setPosition(0.6, -0.3, 0.2),
        ];
        const meshes = matrices.map((matrix) => {
          const one = new THREE.Mesh(mesh.geometry, mesh.material);
          one.applyMatrix4(matrix);
          return one;
        });
        const instancedMesh = new THREE.InstancedMesh(mesh.geometry, mesh.material, 2);
        matrices.forEach((matrix, i) => {
          instancedMesh.setMatrixAt(i, matrix);
        });
        return [pixelsOf(sceneOf(sun(), ...meshes)), pixelsOf(sceneOf(sun(), instancedMesh))];
      }, technique);
      expect(covered(separate)).toBeGreaterThan(800);
      // Rounding differs between the two ways, and on a hard stripe a rounding shows.
      expect(differing(separate, instanced, 8)).toBeLessThan(0.01 * covered(separate));
    },
  );
}

for (const technique of kindsOfTechnique) {
  test(
    `a CubeCamera, whose pictures are turned, sees the strokes and outlines that others see: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const [plain, turned] = await page.evaluate(async (technique) => {
        const { THREE, applyHatching, sceneOf, sun, makeRenderer } = window.toolkit;
        const size = 160;
        const renderer = makeRenderer();
        const knot = new THREE.Mesh(new THREE.TorusKnotGeometry(0.8, 0.3, 96, 16), new THREE.MeshLambertMaterial());
        const box = new THREE.Mesh(new THREE.BoxGeometry(0.8, 0.8, 0.8), new THREE.MeshLambertMaterial());
        box.position.set(0.9, 0.9, 0.8);
        const scene = sceneOf(sun(), knot, box);
        await applyHatching(scene, { material: { technique }, outlines: {} });
        const eye = new THREE.Vector3(0, 0, 2.5);
        const camera = new THREE.PerspectiveCamera(90, 1, 0.1, 50);
        camera.position.copy(eye);
        const target = new THREE.WebGLRenderTarget(size, size);
        renderer.setRenderTarget(target);
        renderer.render(scene, camera);
        const pixels = [0, 1].map(() => new Uint8Array(4 * size * size));
        renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels[0]);
        renderer.setRenderTarget(null);
        const cube = new THREE.WebGLCubeRenderTarget(size);
        const cubeCamera = new THREE.CubeCamera(0.1, 50, cube);
        cubeCamera.position.copy(eye);
        cubeCamera.update(renderer, scene);
        renderer.readRenderTargetPixels(cube, 0, 0, size, size, pixels[1], 5);
        const reds = pixels.map((of) => Array.from({ length: size * size }, (_, i) => of[4 * i]));
        return [reds[0], reds[1].reverse()];
      }, technique);
      expect(plain.filter((red) => red < 60).length).toBeGreaterThan(400);
      const different = plain.filter((red, i) => Math.abs(red - turned[i]) > 60).length;
      expect(different / plain.length).toBeLessThan(0.005);
    },
  );
}

test('a BatchedMesh gives the pixels of separate meshes', async ({ page }) => {
  const [separate, batched] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const { geometry, material } = await hatchedMesh(new THREE.SphereGeometry(0.5, 16, 12));
    const matrices = [
      new THREE.Matrix4().makeRotationX(0.7).setPosition(-0.7, 0.3, 0),
      new THREE.Matrix4().makeRotationY(1.1).setPosition(0.6, -0.3, 0.2),
    ];
    const meshes = matrices.map((matrix) => {
      const one = new THREE.Mesh(geometry, material);
      one.applyMatrix4(matrix);
      return one;
    });
    const batch = new THREE.BatchedMesh(2, geometry.attributes.position.count, 0, material);
    const id = batch.addGeometry(geometry);
    for (const matrix of matrices) batch.setMatrixAt(batch.addInstance(id), matrix);
    return [pixelsOf(sceneOf(sun(), ...meshes)), pixelsOf(sceneOf(sun(), batch))];
  });
  expect(covered(separate)).toBeGreaterThan(800);
  expect(differing(separate, batched, 8)).toBeLessThan(0.01 * covered(separate));
});

test('does not receive shadows without receiveShadow', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const floor = await hatchedMesh(new THREE.PlaneGeometry(3, 3));
    const blocker = await hatchedMesh(new THREE.BoxGeometry(0.5, 0.5, 0.2));
    blocker.position.set(1.2, 0, 1.2);
    blocker.castShadow = true;
    const light = sun(Math.PI, [3, 0, 3]);
    light.castShadow = true;
    const renderer = makeRenderer();
    renderer.shadowMap.enabled = true;
    return pixelsOf(sceneOf(floor, blocker, light), renderer);
  });
  expect(centre(pixels)[0]).toBeGreaterThan(150);
});

test('lights may be added, switched off and removed between frames', async ({ page }) => {
  const frames = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const floor = await hatchedMesh(new THREE.PlaneGeometry(3, 3));
    const scene = sceneOf(floor);
    const frame = () => pixelsOf(scene, renderer);
    const dark = frame();
    const light = sun(Math.PI / 2, [0, 0, 1]);
    scene.add(light);
    const half = frame();
    const ambient = new THREE.AmbientLight(0xffffff, Math.PI / 4);
    scene.add(ambient);
    const more = frame();
    light.visible = false;
    const ambientOnly = frame();
    scene.remove(ambient);
    return [dark, half, more, ambientOnly, frame()];
  });
  expect(frames.map((pixels) => centre(pixels)[0])).toEqual([0, 128, 191, 64, 0].map((x) => expect.closeTo(x, -0.3)));
});

test('a material without fog stays as it is in a fog', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), { fog: false });
    const scene = sceneOf(mesh, sun());
    scene.fog = new THREE.Fog(0x0000ff, 1, 3);
    return pixelsOf(scene);
  });
  expect(centre(pixels)[0]).toBeGreaterThan(100);
});

test('clipping planes of the material cut', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2));
    const renderer = makeRenderer();
    renderer.localClippingEnabled = true;
    mesh.material.clippingPlanes = [new THREE.Plane(new THREE.Vector3(1, 0, 0), 0)];
    return pixelsOf(sceneOf(mesh, sun()), renderer);
  });
  expect(isGround(at(pixels, 30, 48))).toBe(true);
  expect(isGround(at(pixels, 66, 48))).toBe(false);
});

for (const depth of ['logarithmicDepthBuffer', 'reversedDepthBuffer'] as const) {
  test(`hides and is hidden rightly with ${depth}`, async ({ page }) => {
    const pixels = await page.evaluate(async (depth) => {
      const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
      const hatched = await hatchedMesh(new THREE.PlaneGeometry(1, 2));
      hatched.position.set(-0.2, 0, 0);
      const plain = (x: number, z: number) => {
        const mesh = new THREE.Mesh(
          new THREE.PlaneGeometry(0.6, 0.6),
          new THREE.MeshBasicMaterial({ color: 0xff0000 }),
        );
        mesh.position.set(x, 0, z);
        return mesh;
      };
      const scene = sceneOf(hatched, plain(-0.7, -0.001), plain(0.2, 0.001), sun(Math.PI, [0, 0, 1]));
      return pixelsOf(scene, makeRenderer({ [depth]: true }));
    }, depth);
    // The plain square is slightly behind the hatched square on the left, and slightly in front of it on the right.
    expect(at(pixels, 33, 48)).toEqual([255, 255, 255]);
    expect(at(pixels, 53, 48)).toEqual([255, 0, 0]);
  });
}

test('colour space and tone mapping are the renderer’s', async ({ page }) => {
  const [linear, srgb, mapped, target] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer, makeCamera, SIZE } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), { toneMapped: true });
    const scene = sceneOf(mesh, sun(Math.PI / 2, [0, 0, 1]));
    const renderer = makeRenderer();
    const linear = pixelsOf(scene, renderer);
    renderer.outputColorSpace = THREE.SRGBColorSpace;
    const srgb = pixelsOf(scene, renderer);
    const renderTarget = new THREE.WebGLRenderTarget(SIZE, SIZE);
    renderer.setRenderTarget(renderTarget);
    renderer.render(scene, makeCamera());
    const bytes = new Uint8Array(SIZE * SIZE * 4);
    renderer.readRenderTargetPixels(renderTarget, 0, 0, SIZE, SIZE, bytes);
    renderer.setRenderTarget(null);
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    renderer.toneMapping = THREE.ReinhardToneMapping;
    return [linear, srgb, pixelsOf(scene, renderer), [...bytes]];
  });
  expect(centre(linear)[0]).toBeCloseTo(128, -0.3);
  expect(centre(srgb)[0]).toBeCloseTo(188, -0.3);
  // Reinhard: x / (1 + x) of one half.
  expect(centre(mapped)[0]).toBeCloseTo(85, -0.3);
  expect(centre(target)[0]).toBeCloseTo(128, -0.3);
});

test('groups draw with their own materials', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, greyMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const source = new THREE.PlaneGeometry(2, 2, 2, 1);
    source.clearGroups();
    source.addGroup(0, 6, 1);
    source.addGroup(6, 6, 0);
    const tonalArtMap = greyMap();
    const materials = [0xff0000, 0x0000ff].map((color) => new HatchingMaterial({ tonalArtMap, color }));
    const mesh = new THREE.Mesh(await prepareHatchingGeometry(source, { adjacency: true }), materials);
    return pixelsOf(sceneOf(mesh, sun(Math.PI, [0, 0, 1])));
  });
  expect(at(pixels, 30, 48)).toEqual([0, 0, 255]);
  expect(at(pixels, 66, 48)).toEqual([255, 0, 0]);
});

test('front, back and both sides are shaded by the side that is seen', async ({ page }) => {
  const brightness = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, SIZE } = window.toolkit;
    const results: number[][] = [];
    for (const side of [THREE.FrontSide, THREE.BackSide, THREE.DoubleSide]) {
      for (const toneNormal of ['face', 'smooth'] as const) {
        for (const turned of [0, Math.PI]) {
          const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), { side, toneNormal });
          mesh.rotation.y = turned;
          const pixels = pixelsOf(sceneOf(mesh, sun(Math.PI, [0, 0, 1])));
          results.push(pixels.slice(4 * (SIZE / 2) * (SIZE + 1), 4 * (SIZE / 2) * (SIZE + 1) + 3));
        }
      }
    }
    return results;
  });
  const [lit, ground] = [
    [255, 255, 255],
    [0, 255, 0],
  ];
  expect(brightness).toEqual([lit, ground, lit, ground, ground, lit, ground, lit, lit, lit, lit, lit]);
});

test('a transparent double-sided mesh draws both its sides', async ({ page }) => {
  const pixels = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.BoxGeometry(1, 1, 1), {
      side: THREE.DoubleSide,
      transparent: true,
      opacity: 0.5,
    });
    return pixelsOf(sceneOf(mesh, sun(Math.PI, [0, 0, 1])));
  });
  // The inside of the back wall faces the light: white over green, and white again.
  expect(centre(pixels)).toEqual([192, 255, 192]);
});

test('a material comes back from its JSON', async ({ page }) => {
  const [drawn, drawnAgain] = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, hatchedMesh, sceneOf, sun, pixelsOf } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.TorusGeometry(1, 0.4), {
      ink: '#a02030',
      toneModel: 'phong',
      perTriangle: { sharpInk: true },
    });
    const scene = sceneOf(mesh, sun());
    const drawn = pixelsOf(scene);
    const { tonalArtMap } = mesh.material;
    mesh.material = HatchingMaterial.fromJSON(JSON.parse(JSON.stringify(mesh.material.toJSON())));
    mesh.material.tonalArtMap = tonalArtMap;
    return [drawn, pixelsOf(scene)];
  });
  expect(new Set(drawn).size).toBeGreaterThan(5);
  expect(drawnAgain).toEqual(drawn);
});
