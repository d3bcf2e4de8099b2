import { expect } from '../browser/test.js';
import { centre, covered, differing } from './pixels.js';
import { test } from './toolkitPage.js';

/** Settings at the ends of their ranges, and settings that come late: after a frame was drawn without them. */

test('a crease angle of 0 blends nothing, coplanar triangles neither', async ({ page }) => {
  const [alone, uncreased] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, stripedMap, sceneOf, sun, pixelsOf } = window.toolkit;
    const draw = async (parameters: object) => {
      const mesh = await hatchedMesh(new THREE.BoxGeometry(1.2, 1.2, 1.2, 3, 3, 3), {
        tonalArtMap: stripedMap(),
        ...parameters,
      });
      mesh.rotation.set(0.5, 0.6, 0);
      return pixelsOf(sceneOf(mesh, sun()));
    };
    return [
      await draw({ technique: 'triangle' }),
      await draw({ technique: 'adjacency', perTriangle: { blendAngle: 0 } }),
    ];
  });
  expect(covered(alone)).toBeGreaterThan(2000);
  expect(differing(alone, uncreased, 2)).toBe(0);
});

test('a tone curve that rounds to more than 1 prints full ink', { tag: '@all' }, async ({ page }) => {
  const darkest = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, TonalArtMap, sceneOf, pixelsOf } = window.toolkit;
    const tonalArtMap = await TonalArtMap.generate({ size: 64 });
    const plane = new THREE.PlaneGeometry(4, 4);
    // The greatest sum that these curves reach in single precision at the end of a span is 1 + 2⁻²³ and more.
    const pictures = [];
    for (const x of [0.3, 0.37, 0.41, 0.6, 0.7, 0.83]) {
      const toneCurve = [
        [0, 0.1],
        [x, 1],
        [1, 1],
      ] as const;
      const material = new HatchingMaterial({ tonalArtMap, technique: 'hatching', toneCurve });
      pictures.push(pixelsOf(sceneOf(new THREE.Mesh(plane, material))));
    }
    return pictures;
  });
  for (const pixels of darkest) {
    const ink = pixels.filter((value, i) => i % 4 === 0 && value === 0).length;
    expect(ink).toBe(pixels.length / 4);
  }
});

test('changes after a frame show in the next: maps, vertex colours, sides, channels', async ({ page }) => {
  const shown = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer, SIZE } = window.toolkit;
    const geometry = new THREE.PlaneGeometry(2, 2);
    geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(12).fill(0.25), 3));
    // Every second set of coordinates looks at the other texel.
    const uv1 = geometry.getAttribute('uv').clone();
    for (let i = 0; i < uv1.count; i++) uv1.setX(i, 0.75);
    geometry.setAttribute('uv1', uv1);
    const texture = (...bytes: number[]) => {
      const made = new THREE.DataTexture(new Uint8Array(bytes), bytes.length / 4, 1);
      made.needsUpdate = true;
      return made;
    };
    const red = texture(255, 0, 0, 255);
    const redBlue = texture(255, 0, 0, 255, 0, 0, 255, 255);
    redBlue.channel = 1;
    const half = texture(0, 128, 0, 255);
    const mesh = await hatchedMesh(geometry, { technique: 'adjacency' });
    const { material } = mesh;
    const scene = sceneOf(mesh, sun(Math.PI, [0, 0, 1]));
    const renderer = makeRenderer();
    const middle = () => [
      ...pixelsOf(scene, renderer)
        .slice(4 * (SIZE / 2) * (SIZE + 1))
        .slice(0, 3),
    ];
    const seen: Record<string, number[]> = { plain: middle() };
    material.map = red;
    seen.map = middle();
    material.map = redBlue;
    seen.channel = middle();
    material.map = null;
    seen.noMap = middle();
    material.vertexColors = true;
    seen.vertexColors = middle();
    material.vertexColors = false;
    material.alphaMap = half;
    material.transparent = true;
    seen.alphaMap = middle();
    material.alphaMap = null;
    material.transparent = false;
    mesh.rotation.y = Math.PI;
    seen.away = middle();
    material.side = THREE.DoubleSide;
    seen.doubleSided = middle();
    return seen;
  });
  expect(shown.plain).toEqual([255, 255, 255]);
  expect(shown.map).toEqual([255, 0, 0]);
  expect(shown.channel).toEqual([0, 0, 255]);
  expect(shown.noMap).toEqual([255, 255, 255]);
  expect(shown.vertexColors).toEqual([64, 64, 64]);
  expect(shown.alphaMap[0]).toBeGreaterThan(120);
  expect(shown.alphaMap[0]).toBeLessThan(136);
  expect(shown.away).toEqual([0, 255, 0]);
  expect(shown.doubleSided).toEqual([255, 255, 255]);
});

test('hooks of one’s own run beside the material’s, in every frame and for compile', async ({ page }) => {
  const [pixels, calls, sources] = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer, makeCamera } = window.toolkit;
    const mesh = await hatchedMesh(new THREE.PlaneGeometry(2, 2), { technique: 'hatching' });
    const renderer = makeRenderer();
    const calls: unknown[] = [];
    const sources: string[] = [];
    const scene = sceneOf(mesh, sun(Math.PI, [0, 0, 1]));
    const { material } = mesh;
    const before = material.onBeforeRender;
    material.onBeforeRender = function (...parameters) {
      before.apply(this, parameters);
      calls.push(this === material, parameters[0] === renderer, parameters[4] === mesh);
    };
    // The usual decorators.
    const key = material.customProgramCacheKey;
    material.customProgramCacheKey = function () {
      return `${key.call(this)} green`;
    };
    material.onBeforeCompile = (shader) => {
      sources.push(shader.fragmentShader);
      shader.fragmentShader = shader.fragmentShader.replace(/}\s*$/, 'gl_FragColor.g = 1.0;}');
    };
    material.color.set(0xff0000);
    renderer.compile(scene, makeCamera());
    return [pixelsOf(scene, renderer), calls, sources] as const;
  });
  expect(centre([...pixels])).toEqual([255, 255, 0]);
  expect(calls).toEqual([true, true, true]);
  expect(sources.map((source) => source.split('#define RIGID').length)).toEqual([2]);
});

test('a map too large for the device leaves the paper blank and says so, once; one that fits is drawn', async ({
  page,
  pageProblems,
}) => {
  const inks = await page.evaluate(async () => {
    const { THREE, HatchingMaterial, prepareHatchingGeometry, stripedMap, sceneOf, pixelsOf, makeRenderer } =
      window.toolkit;
    HatchingMaterial.silent = false;
    const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(4, 4), { adjacency: true });
    const inks: Record<string, number> = {};
    // 64 texels per side, and 66 for the thresholds.
    for (const [technique, limit] of [
      ['adjacency', 63],
      ['adjacency', 64],
      ['hatching', 65],
      ['hatching', 66],
      ['none', 66],
    ] as const) {
      const renderer = makeRenderer();
      renderer.capabilities.maxTextureSize = limit;
      const material = new HatchingMaterial({
        technique: technique === 'none' ? 'hatching' : technique,
        tonalArtMap: technique === 'none' ? null : stripedMap(),
      });
      // Dark, but not without any light.
      const scene = sceneOf(new THREE.Mesh(geometry, material), new THREE.AmbientLight(0xffffff, 0.6));
      pixelsOf(scene, renderer);
      const pixels = pixelsOf(scene, renderer);
      inks[`${technique} ${limit}`] = pixels.filter((value, i) => i % 4 === 0 && value < 128).length;
    }
    await window.toolkit.whenChecked();
    return inks;
  });
  expect(inks['adjacency 63']).toBe(0);
  expect(inks['adjacency 64']).toBeGreaterThan(1000);
  expect(inks['hatching 65']).toBe(inks['none 66']);
  expect(inks['hatching 65']).toBe(0);
  expect(inks['hatching 66']).toBeGreaterThan(1000);
  // The light of the scenes is ambient alone, and one has no map.
  const said = pageProblems.splice(0).filter((problem) => problem.includes('this device'));
  expect(said).toHaveLength(2);
  expect(said[0]).toMatch(/a map of 64 texels per side needs a texture 64 texels wide, but this device allows 63/);
  expect(said[1]).toMatch(/needs a texture 66 texels wide, but this device allows 65.*give it a smaller map/);
});
