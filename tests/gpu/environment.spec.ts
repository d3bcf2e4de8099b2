import { expect } from '../browser/test.js';
import { at, centre, difference, SIZE } from './pixels.js';
import { techniques } from './techniques.js';
import { test } from './toolkitPage.js';

/** Light from the scene's environment, against three's own Lambert material in the same scene. */

/** Luminance of a pixel; it is compared inside the silhouette. */
const luminance = ([r, g, b]: number[]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

function worst(tone: number[], lambert: number[]): { difference: number; compared: number; spread: number } {
  const inside: [number, number][] = [];
  for (let y = 1; y < SIZE - 1; y++) {
    for (let x = 1; x < SIZE - 1; x++) {
      const near = [at(lambert, x - 1, y), at(lambert, x + 1, y), at(lambert, x, y - 1), at(lambert, x, y + 1)];
      if (near.some(([r, g]) => r === 0 && g === 255)) continue;
      inside.push([at(tone, x, y)[0], luminance(at(lambert, x, y))]);
    }
  }
  const wanted = inside.map(([, value]) => value);
  return {
    difference: Math.max(...inside.map(([shown, value]) => Math.abs(shown - value))),
    compared: inside.length,
    spread: Math.max(...wanted) - Math.min(...wanted),
  };
}

test(
  "a room lights as it lights three's Lambert, alone and with a sun",
  { tag: '@all' },
  async ({ page }, testInfo) => {
    // A software rasterizer takes its time over blurring the room: once for both.
    test.slow();
    const shown = await page.evaluate(async (techniques) => {
      const { THREE, RoomEnvironment, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
      const renderer = makeRenderer();
      const geometry = new THREE.SphereGeometry(1, 48, 32);
      const environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
      const compared: Record<string, [number[], number[]]> = {};
      for (const light of ['alone', 'with a sun'] as const) {
        const scene = sceneOf(new THREE.Group());
        scene.environment = environment;
        scene.environmentIntensity = light === 'alone' ? 0.7 : 0.3;
        scene.environmentRotation.set(0.5, 1.2, -0.4);
        if (light === 'with a sun') scene.add(sun(1.5));
        const show = (mesh: InstanceType<typeof THREE.Mesh>) => {
          scene.add(mesh);
          const pixels = pixelsOf(scene, renderer);
          scene.remove(mesh);
          return pixels;
        };
        for (const toneNormal of ['face', 'smooth'] as const) {
          // `besideLambert` has the case without a sun, by smooth normals.
          if (light === 'alone' && toneNormal === 'smooth') continue;
          const flatShading = toneNormal === 'face';
          const lambert = show(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ flatShading })));
          for (const technique of techniques) {
            // No blending with neighbours of another tone.
            const blendAngle = technique === 'adjacency' ? { perTriangle: { blendAngle: 0 } } : {};
            const tone = show(await hatchedMesh(geometry, { technique, toneNormal, debugView: 'tone', ...blendAngle }));
            compared[`${light}, ${technique}, ${toneNormal}`] = [tone, lambert];
          }
        }
      }
      return compared;
    }, techniques);
    expect(Object.keys(shown)).toHaveLength(3 * techniques.length);
    for (const [name, [tone, lambert]] of Object.entries(shown)) {
      const found = worst(tone, lambert);
      testInfo.annotations.push({ type: name, description: JSON.stringify(found) });
      expect(found.compared, name).toBeGreaterThan(1500);
      expect(found.spread, name).toBeGreaterThan(30);
      expect(found.difference, name).toBeLessThanOrEqual(6);
    }
  },
);

test("cube textures and render targets light as they light three's Lambert", { tag: '@all' }, async ({ page }) => {
  // A software rasterizer takes its time over blurring four of them.
  test.slow();
  const shown = await page.evaluate(async () => {
    const { THREE, RoomEnvironment, hatchedMesh, sceneOf, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const faces = ['#f66', '#6f6', '#fff', '#333', '#99f', '#aaa'].map((color) => {
      const canvas = document.createElement('canvas');
      canvas.width = canvas.height = 16;
      const context = canvas.getContext('2d');
      if (!context) throw new Error('There is no canvas to draw on.');
      context.fillStyle = color;
      context.fillRect(0, 0, 16, 16);
      return canvas;
    });
    const cube = new THREE.CubeTexture(faces);
    cube.needsUpdate = true;

    const target = new THREE.WebGLCubeRenderTarget(16, { type: THREE.HalfFloatType });
    new THREE.CubeCamera(0.1, 100, target).update(renderer, new RoomEnvironment());

    const hatched = await hatchedMesh(new THREE.SphereGeometry(1, 24, 16), {
      technique: 'hatching',
      debugView: 'tone',
    });
    const lambert = new THREE.Mesh(hatched.geometry, new THREE.MeshLambertMaterial());
    const scene = sceneOf(hatched, lambert);
    scene.environmentIntensity = 0.6;
    scene.environmentRotation.y = 1;
    return [cube, target.texture].map((environment) => {
      scene.environment = environment;
      return [hatched, lambert].map((mesh) => {
        hatched.visible = mesh === hatched;
        lambert.visible = mesh === lambert;
        return pixelsOf(scene, renderer);
      });
    });
  });
  for (const [tone, lambert] of shown) {
    const found = worst(tone, lambert);
    expect(found.spread).toBeGreaterThan(20);
    expect(found.difference).toBeLessThanOrEqual(6);
  }
});

test('an environment builds one program when it comes, none when it turns, dims or goes, and its blur is freed with it', {
  tag: '@all',
}, async ({ page, pageProblems }) => {
  const { shown, linked, textures, allocated } = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2));
    const scene = sceneOf(mesh);
    const environment = new THREE.DataTexture(null, 0, 0, THREE.RGBAFormat, THREE.FloatType);
    environment.mapping = THREE.EquirectangularReflectionMapping;
    const gl = renderer.getContext();
    let linked = 0;
    const link = gl.linkProgram.bind(gl);
    gl.linkProgram = (program) => {
      linked++;
      link(program);
    };
    await renderer.compileAsync(scene, makeCamera());
    const links: number[] = [linked];
    const shown: number[][] = [];
    const textures: number[] = [];
    const show = () => {
      linked = 0;
      shown.push(pixelsOf(scene, renderer));
      links.push(linked);
      textures.push(renderer.info.memory.textures);
    };
    show();
    scene.environment = environment;
    show();
    const image = { data: new Float32Array(64 * 32 * 4).fill(0.5), width: 64, height: 32 };
    Object.assign(environment, { image, needsUpdate: true });
    show();
    scene.environmentIntensity = 0.5;
    scene.environmentRotation.x = 2;
    linked = 0;
    show();
    let allocated = 0;
    const create = gl.createTexture.bind(gl);
    gl.createTexture = () => {
      allocated++;
      return create();
    };
    for (let i = 0; i < 3; i++) show();
    scene.environment = null;
    show();
    environment.dispose();
    textures.push(renderer.info.memory.textures);
    return {
      shown: shown.map((pixels) => pixels.slice(4 * (48 * 96 + 48), 4 * (48 * 96 + 48) + 3)),
      linked: links,
      textures,
      allocated,
    };
  });
  // A software rasterizer compiles while one waits.
  expect(pageProblems.splice(0).filter((problem) => !problem.includes('KHR_parallel_shader_compile'))).toEqual([]);
  const near = (pixel: number[], value: number) => expect(Math.abs(pixel[0] - value)).toBeLessThanOrEqual(2);
  const [dark, loading, bright, ...dimmed] = shown;
  const gone = dimmed.pop();
  expect(dark).toEqual([0, 0, 0]);
  expect(loading).toEqual([0, 0, 0]);
  near(bright, 128);
  for (const pixel of dimmed) near(pixel, 64);
  expect(gone).toEqual([0, 0, 0]);
  // The first frame builds one program. The frame with an environment builds another, and three's PMREMGenerator its own.
  expect(linked[0]).toBe(1);
  expect(linked[3]).toBeGreaterThan(1);
  expect(linked.filter((_, i) => i > 0 && i !== 3).every((count) => count === 0)).toBe(true);
  expect(allocated).toBe(0);
  expect(textures[textures.length - 1]).toBeLessThan(textures[textures.length - 2]);
});

test('after compileAsync the first frame in an environment links no program', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  const counts = await page.evaluate(async () => {
    const { THREE, RoomEnvironment, applyHatching, greyMap, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } =
      window.toolkit;
    const sky = new THREE.DataTexture(
      new Float32Array(64 * 32 * 4).fill(0.5),
      64,
      32,
      THREE.RGBAFormat,
      THREE.FloatType,
    );
    sky.mapping = THREE.EquirectangularReflectionMapping;
    sky.needsUpdate = true;
    const counts: Record<string, number[]> = {};
    for (const name of ['sky', 'blurred'] as const) {
      // Blurred once for all techniques, whose programs are not shared.
      const renderer = makeRenderer();
      const gl = renderer.getContext();
      let linked = 0;
      const link = gl.linkProgram.bind(gl);
      gl.linkProgram = (program) => {
        linked++;
        link(program);
      };
      const environment =
        name === 'sky' ? sky : new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
      for (const technique of ['adjacency', 'hatching', 'engraving'] as const) {
        const root = new THREE.Group().add(
          new THREE.Mesh(new THREE.SphereGeometry(), new THREE.MeshStandardMaterial()),
        );
        await applyHatching(root, { tonalArtMap: greyMap(), material: { technique } });
        // It is added to the scene only now, as a model after loading.
        const scene = sceneOf(root, sun());
        scene.background = null;
        scene.environment = environment;
        linked = 0;
        await renderer.compileAsync(scene, makeCamera());
        const compiled = linked;
        linked = 0;
        const first = pixelsOf(scene, renderer);
        const inFirst = linked;
        const again = pixelsOf(scene, renderer);
        scene.environment = null;
        const without = pixelsOf(scene, renderer);
        const differing = (pixels: number[]) => first.filter((x, i) => x !== pixels[i]).length;
        counts[`${name}, ${technique}`] = [
          Number(compiled > 0),
          inFirst,
          differing(again),
          Number(differing(without) > 1000),
        ];
      }
    }
    return counts;
  });
  expect(counts).toEqual({
    'sky, adjacency': [1, 0, 0, 1],
    'sky, hatching': [1, 0, 0, 1],
    'sky, engraving': [1, 0, 0, 1],
    'blurred, adjacency': [1, 0, 0, 1],
    'blurred, hatching': [1, 0, 0, 1],
    'blurred, engraving': [1, 0, 0, 1],
  });
  // A software rasterizer compiles while one waits.
  expect(pageProblems.splice(0).filter((problem) => !problem.includes('KHR_parallel_shader_compile'))).toEqual([]);
});

test('an environment is blurred again after a lost context, and its former blur is not touched', {
  tag: '@all',
}, async ({ page, pageProblems }) => {
  const [before, after] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2));
    const scene = sceneOf(mesh);
    const data = new Float32Array(64 * 32 * 4).fill(0.5);
    const environment = new THREE.DataTexture(data, 64, 32, THREE.RGBAFormat, THREE.FloatType);
    environment.mapping = THREE.EquirectangularReflectionMapping;
    environment.needsUpdate = true;
    scene.environment = environment;
    const before = pixelsOf(scene, renderer);
    const lost = new Promise((resolve) => {
      // In its own task: a context cannot be restored while the event of its loss is dispatched.
      renderer.domElement.addEventListener('webglcontextlost', () => setTimeout(resolve));
    });
    const restored = new Promise((resolve) => {
      renderer.domElement.addEventListener('webglcontextrestored', resolve);
    });
    renderer.forceContextLoss();
    await lost;
    renderer.forceContextRestore();
    await restored;
    const after = pixelsOf(scene, renderer);
    environment.dispose();
    // Disposing deletes objects of the lost context, which is an error of WebGL; it is cleared here.
    renderer.getContext().getError();
    return [before, after];
  });
  expect(Math.abs(centre(before)[0] - 128)).toBeLessThanOrEqual(2);
  expect(difference(before, after)).toBe(0);
  // three.js deletes the texture itself in both contexts, as any other texture: the lost context still holds it.
  expect(pageProblems.splice(0).filter((problem) => !/context (lost|restored)/i.test(problem))).toEqual([
    expect.stringContaining('delete: object does not belong to this context'),
  ]);
});

test('a surface under half a bright sky shows as much of it as it faces', async ({ page }) => {
  const shown = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, pixelsOf, makeRenderer, SIZE } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2));
    const renderer = makeRenderer();
    // White in front of the surface, black behind it.
    const [width, height] = [64, 32];
    const data = new Float32Array(4 * width * height);
    for (let i = 0; i < width * height; i++) {
      const longitude = (((i % width) + 0.5) / width - 0.5) * 2 * Math.PI;
      data.fill(longitude > 0 ? 1 : 0, 4 * i, 4 * i + 4);
    }
    const sky = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.FloatType);
    sky.mapping = THREE.EquirectangularReflectionMapping;
    sky.needsUpdate = true;
    const scene = sceneOf(mesh);
    scene.environment = sky;
    // Turned, not made anew: three's blur of a sky takes a software rasterizer seconds.
    const quarter = Math.PI / 2;
    return [
      [0, 0, 0],
      [quarter, 0, 0],
      [0, quarter, 0],
      [0, 2 * quarter, 0],
    ].map(([x, y, z]) => {
      scene.environmentRotation.set(x, y, z);
      const pixels = pixelsOf(scene, renderer);
      return pixels[4 * (SIZE / 2) * (SIZE + 1)];
    });
  });
  // (1 + n · axis) / 2 of the light of the whole sky; three's blur is an approximation.
  for (const [i, share] of [1, 0.5, 0.5, 0].entries()) {
    expect(Math.abs(shown[i] - 255 * share), shown.join()).toBeLessThanOrEqual(12);
  }
});
