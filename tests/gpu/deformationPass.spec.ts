import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './deformingPage.js';
import { covered, difference, differing } from './pixels.js';
import { kindsOfTechnique } from './techniques.js';

test('the pre-pass runs once for a pose, however often meshes are drawn, and leaves the renderer as it was', async ({
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

test('a device without float targets draws deforming meshes with strokes as at rest, and reports it once', async ({
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
    /the SkinnedMesh "tube".* is lit and hatched in its rest pose: .*EXT_color_buffer_float.*'hatching'/,
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
        // Early pre-passes are drawn anew in the pose of the frame.
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
