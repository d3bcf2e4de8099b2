import type { HatchingOutlineParameters } from '../../src/material/outlines/HatchingOutlineMaterial.js';
import { quickIf } from '../browser/quickIf.js';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Contours, borders and creases: where they lie, how wide they are, what hides them, and what they are drawn on. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('logarithmic and reversed depth draw the same outlines', { tag: '@all' }, async ({ page }) => {
  const { inks, differences } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, total } = window.lining;
    const scene = paperScene(await outlinedMesh(new THREE.TorusKnotGeometry(0.7, 0.25, 160, 24)));
    const camera = () => lookFrom(1, 2, 4);
    const plain = draw(scene, camera(), rendererOf(300));
    const others = [
      draw(scene, camera(), rendererOf(300, { logarithmicDepthBuffer: true })),
      draw(scene, camera(), rendererOf(300, { reversedDepthBuffer: true } as object)),
    ];
    return {
      inks: [plain, ...others].map(total),
      differences: others.map((ink) => ink.filter((one, i) => Math.abs(one - plain[i]) > 0.1).length),
    };
  });
  expect(inks[0]).toBeGreaterThan(800);
  // Pixels where the depths of surface and outline meet.
  for (const difference of differences) expect(difference).toBeLessThan(0.02 * inks[0]);
});

test('borders follow the side that a surface is drawn from', async ({ page }) => {
  const { sheet, dome } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, total } = window.lining;
    const inksOf = async (source: import('three').BufferGeometry, height: number, away: number) => {
      const mesh = await outlinedMesh(source, { outlineWidth: 3, weights: { contours: 0 } });
      const paper = mesh.material as import('three').Material;
      return [THREE.FrontSide, THREE.DoubleSide].map((side) => {
        paper.side = side;
        return total(draw(paperScene(mesh), lookFrom(0, height, away)));
      });
    };
    return {
      sheet: [
        ...(await inksOf(new THREE.PlaneGeometry(1.2, 1.2), 0, 3)),
        ...(await inksOf(new THREE.PlaneGeometry(1.2, 1.2), 0, -3)),
      ],
      // The dome hides the far half of its rim, from silhouette to silhouette.
      dome: await inksOf(new THREE.SphereGeometry(0.8, 48, 24, 0, 2 * Math.PI, 0, 0.5 * Math.PI), 1.2, 3),
    };
  });
  const [front, both, back, bothFromBack] = sheet;
  expect(front).toBeGreaterThan(800);
  expect(both).toBeCloseTo(front, 3);
  expect(back).toBe(0);
  expect(bothFromBack).toBeCloseTo(front, 0);
  expect(dome[1]).toBeGreaterThan(200);
  expect(dome[0] / dome[1]).toBeCloseTo(1, 1);
});

test('tiles of a picture fit together', { tag: '@all' }, async ({ page }) => {
  const difference = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf } = window.lining;
    const parameters = { wobble: 1.5, outlineWidth: 3, paperGrain: 0.6 };
    const scene = paperScene(await outlinedMesh(new THREE.TorusKnotGeometry(0.7, 0.25, 160, 24), parameters));
    const camera = lookFrom(1, 2, 4);
    const whole = draw(scene, camera, rendererOf(400));
    let differing = 0;
    for (const [left, top] of [
      [0, 0],
      [200, 0],
      [0, 200],
      [200, 200],
    ]) {
      camera.setViewOffset(400, 400, left, top, 200, 200);
      const tile = draw(scene, camera, rendererOf(200));
      tile.forEach((one, i) => {
        const there = whole[(top + Math.floor(i / 200)) * 400 + left + (i % 200)];
        if (Math.abs(one - there) > 0.06) differing++;
      });
    }
    return differing;
  });
  expect(difference).toBeLessThan(20);
});

test('clipping planes cut outlines where they cut the surface', { tag: '@all' }, async ({ page }) => {
  const { beyond, before } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, draw, rendererOf } = window.lining;
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 0.2, 40), { weights: { creases: 1 }, isClear: true });
    outlinesOf(mesh).material.clippingPlanes = [new THREE.Plane(new THREE.Vector3(0, 0, 1), 4)];
    const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 100);
    camera.position.set(0, 1, 5);
    const renderer = rendererOf(400);
    renderer.localClippingEnabled = true;
    const ink = draw(paperScene(mesh), camera, renderer);
    renderer.localClippingEnabled = false;
    const at = (z: number) =>
      window.lining.inkNear(ink, 400, window.lining.pixelOf(new THREE.Vector3(0.5, 0.1, z), camera, 400), 1);
    return { beyond: at(-4.4), before: at(-3.6) };
  });
  expect(before).toBeGreaterThan(0.4);
  expect(beyond).toBeLessThan(0.05);
});

test('fog takes outlines along', { tag: '@all' }, async ({ page }) => {
  const inks = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, total } = window.lining;
    const scene = paperScene(await outlinedMesh(new THREE.IcosahedronGeometry(1, 12)));
    const clear = total(draw(scene, lookFrom(0, 0, 4)));
    scene.fog = new THREE.Fog(0xffffff, 2, 6);
    return [clear, total(draw(scene, lookFrom(0, 0, 4)))];
  });
  expect(inks[1] / inks[0]).toBeGreaterThan(0.4);
  expect(inks[1] / inks[0]).toBeLessThan(0.6);
});

test('instances have the outlines of separate meshes, also while the eye moves', { tag: '@all' }, async ({ page }) => {
  const pictures = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, total, HatchingOutlines } = window.lining;
    const mesh = await outlinedMesh(new THREE.TorusGeometry(0.4, 0.2, 24, 40), { weights: { lit: 0.5, shade: 1.4 } });
    const matrices = [
      new THREE.Matrix4().makeRotationX(0.7).setPosition(-0.7, 0.3, 0),
      new THREE.Matrix4()
        .makeRotationY(1.1)
        .scale(new THREE.Vector3(0.8, 1.2, 0.8))
        .setPosition(0.6, -0.3, 0.2),
    ];
    const light = new THREE.DirectionalLight(0xffffff, 3);
    light.position.set(1, 2, 1);
    const separate = matrices.map((matrix) => {
      const one = mesh.clone();
      one.applyMatrix4(matrix);
      return one;
    });
    const instanced = new THREE.InstancedMesh(mesh.geometry, mesh.material, 2);
    matrices.forEach((matrix, i) => {
      instanced.setMatrixAt(i, matrix);
    });
    instanced.add(new HatchingOutlines(instanced, outlinesOf(mesh).material));
    const camera = lookFrom(0, 0, 4);
    const [apart, together] = [paperScene(light, ...separate), paperScene(light.clone(), instanced)];
    // The first and the last are drawn from a list of what may hold an outline, that in between is not.
    return [0, 2.5, 2.5].map((x) => {
      camera.position.x = x;
      camera.lookAt(0, 0, 0);
      const one = draw(apart, camera);
      const other = draw(together, camera);
      return { difference: one.filter((value, i) => Math.abs(value - other[i]) > 0.05).length, ink: total(one) };
    });
  });
  for (const { difference, ink } of pictures) {
    expect(ink).toBeGreaterThan(300);
    expect(difference).toBeLessThan(8);
  }
});

for (const layout of ['indexed', 'pull'] as const) {
  test(
    `a skinned and morphing mesh has the outlines of its pose: ${layout}`,
    quickIf(layout === 'pull'),
    async ({ page }) => {
      const results = await page.evaluate(async (layout) => {
        const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, total, strayInk, HatchingOutlines } =
          window.lining;
        const source = new THREE.CylinderGeometry(0.35, 0.35, 2, 48, 60);
        const { position } = source.attributes;
        const indices: number[] = [];
        const weights: number[] = [];
        const bulge: number[] = [];
        for (let i = 0; i < position.count; i++) {
          const upper = THREE.MathUtils.smoothstep(position.getY(i), -0.3, 0.3);
          indices.push(0, 1, 0, 0);
          weights.push(1 - upper, upper, 0, 0);
          const swell = 0.5 * Math.exp(-8 * (position.getY(i) + 0.5) ** 2);
          bulge.push(swell * position.getX(i), 0, swell * position.getZ(i));
        }
        source.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4));
        source.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4));
        const results: { ink: number; stray: number; missing: number }[] = [];
        for (const morphs of [false, true]) {
          if (morphs) {
            source.morphTargetsRelative = true;
            source.morphAttributes.position = [new THREE.Float32BufferAttribute(bulge, 3)];
          }
          const plain = await outlinedMesh(source, { layout });
          const skinned = new THREE.SkinnedMesh(plain.geometry, plain.material);
          skinned.add(new HatchingOutlines(skinned, outlinesOf(plain).material.clone()));
          const bones = [new THREE.Bone(), new THREE.Bone()];
          bones[0].add(bones[1]);
          skinned.add(bones[0]);
          skinned.bind(new THREE.Skeleton(bones));
          bones[1].rotation.z = 0.8;
          if (morphs) skinned.morphTargetInfluences = [1];
          skinned.updateMatrixWorld(true);
          // The same pose as a mesh of its own.
          const posed = source.clone();
          posed.morphAttributes = {};
          for (const name of ['skinIndex', 'skinWeight']) posed.deleteAttribute(name);
          const vertex = new THREE.Vector3();
          const still = new THREE.SkinnedMesh(source, plain.material);
          still.bind(skinned.skeleton, skinned.bindMatrix);
          still.morphTargetInfluences = skinned.morphTargetInfluences;
          for (let i = 0; i < position.count; i++) {
            still.getVertexPosition(i, vertex);
            posed.attributes.position.setXYZ(i, vertex.x, vertex.y, vertex.z);
          }
          posed.computeVertexNormals();
          const camera = lookFrom(0.6, 0.8, 4);
          const moving = draw(paperScene(skinned), camera);
          const fixed = draw(paperScene(await outlinedMesh(posed, { layout: 'indexed' })), camera);
          results.push({
            ink: total(fixed),
            stray: strayInk(fixed, moving, 400, 3),
            missing: strayInk(moving, fixed, 400, 3),
          });
        }
        return results;
      }, layout);
      for (const { ink, stray, missing } of results) {
        expect(ink).toBeGreaterThan(400);
        expect(stray).toBeLessThan(0.03);
        expect(missing).toBeLessThan(0.03);
      }
    },
  );
}

test('two renderers and the cameras of an ArrayCamera each see their own outlines', { tag: '@all' }, async ({
  page,
}) => {
  const { halves, alone, second } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, mostDifferent } = window.lining;
    const scene = paperScene(await outlinedMesh(new THREE.TorusGeometry(0.8, 0.3, 32, 64)));
    const eyes = [lookFrom(1, 2, 4), lookFrom(-2, 1, 3)];
    const alone = eyes.map((eye) => draw(scene, eye, rendererOf(200)));
    const second = mostDifferent(alone[0], draw(scene, eyes[0], rendererOf(200, { antialias: false })));
    const pair = new THREE.ArrayCamera(
      eyes.map((eye, i) => Object.assign(eye, { viewport: new THREE.Vector4(200 * i, 0, 200, 200) })),
    );
    // One of its own: three.js leaves the last camera's viewport behind.
    const both = draw(scene, pair, rendererOf(400, { stencil: true }));
    const halves = [0, 1].map(
      (side) =>
        alone[side].filter((one, i) => {
          const there = both[(200 + Math.floor(i / 200)) * 400 + 200 * side + (i % 200)];
          return Math.abs(one - there) > 0.1;
        }).length,
    );
    return { halves, alone: alone.map((ink) => ink.filter((one) => one > 0.5).length), second };
  });
  for (const count of alone) expect(count).toBeGreaterThan(200);
  for (const differing of halves) expect(differing).toBeLessThan(8);
  expect(second).toBeLessThan(0.1);
});

test('outlines follow a transparent surface, and glass before it covers them', async ({ page }) => {
  const { before, through, order } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, rendererOf, draw, total } = window.lining;
    const mesh = await outlinedMesh(new THREE.TorusGeometry(0.8, 0.3, 32, 64));
    mesh.geometry.boundingSphere!.center.set(0.02, 0.01, 0.03);
    Object.assign(mesh.material, { transparent: true, opacity: 0.999 });
    const glass = new THREE.Mesh(
      new THREE.PlaneGeometry(4, 4),
      new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.5 }),
    );
    glass.position.z = 2;
    const camera = lookFrom(0, 0, 4);
    const order: string[] = [];
    mesh.onBeforeRender = () => void order.push('mesh');
    const outlines = outlinesOf(mesh);
    outlines.material.onBeforeRender = () => void order.push('outlines');
    glass.onBeforeRender = () => void order.push('glass');
    const before = total(draw(paperScene(mesh), camera));
    order.length = 0;
    const through = total(draw(paperScene(glass, mesh), camera, rendererOf(400)));
    return { before, through, order };
  });
  expect(order).toEqual(['mesh', 'outlines', 'glass']);
  expect(before).toBeGreaterThan(400);
  expect(through / before).toBeGreaterThan(0.4);
  expect(through / before).toBeLessThan(0.6);
});

test('outlines draw nothing into shadow maps, override passes, bounds, rays and files', async ({ page }) => {
  const result = await page.evaluate(async () => {
    const { THREE, STLExporter, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, mostDifferent } = window.lining;
    const mesh = await outlinedMesh(new THREE.TorusGeometry(0.8, 0.3, 16, 32));
    const outlines = outlinesOf(mesh);
    const scene = paperScene(mesh);
    const camera = lookFrom(0, 0, 4);
    scene.overrideMaterial = new THREE.MeshBasicMaterial({ color: 0x808080 });
    const withOutlines = draw(scene, camera);
    mesh.remove(outlines);
    const override = mostDifferent(withOutlines, draw(scene, camera));
    const box = new THREE.Box3().setFromObject(mesh);
    const file = new STLExporter().parse(mesh);
    mesh.add(outlines);
    const hits = new THREE.Raycaster(new THREE.Vector3(0.8, 0, 4), new THREE.Vector3(0, 0, -1)).intersectObject(
      mesh,
      true,
    );
    return {
      override,
      sameBox: box.equals(new THREE.Box3().setFromObject(mesh)),
      sameFile: file === new STLExporter().parse(mesh),
      hits: hits.every(({ object }) => object === mesh) && hits.length > 0,
      castShadow: outlines.castShadow,
    };
  });
  expect(result).toEqual({ override: 0, sameBox: true, sameFile: true, hits: true, castShadow: false });
});

test('weights, colours and hand change the picture and build no program, but for the hand itself', {
  tag: '@all',
}, async ({ page }) => {
  const { inks, programs } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, rendererOf, total } = window.lining;
    const renderer = rendererOf(350);
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 1, 1));
    const light = new THREE.DirectionalLight(0xffffff, 3);
    light.position.set(0, 3, 1);
    const scene = paperScene(mesh, light);
    const camera = lookFrom(2, 1.6, 2.6);
    const { material } = outlinesOf(mesh);
    const steps: [string, HatchingOutlineParameters][] = [
      ['as it is', {}],
      ['wider', { outlineWidth: 4 }],
      ['no creases', { weights: { creases: 0 } }],
      ['nothing', { weights: { contours: 0, borders: 0 } }],
      ['grey', { weights: { contours: 1, creases: 1 }, ink: new THREE.Color(0.5, 0.5, 0.5) }],
      ['shade', { weights: { lit: 0, shade: 1 } }],
      ['hand', { wobble: 2, overshoot: 5 }],
      ['other hand', { wobble: 3, overshoot: 0 }],
    ];
    const inks: Record<string, number> = {};
    const programs: number[] = [];
    for (const [name, values] of steps) {
      material.setValues(values);
      inks[name] = total(draw(scene, camera, renderer));
      programs.push(renderer.info.programs!.length);
    }
    return { inks, programs };
  });
  expect(inks.wider).toBeGreaterThan(1.8 * inks['as it is']);
  expect(inks['no creases']).toBeLessThan(0.95 * inks.wider);
  expect(inks.nothing).toBe(0);
  expect(inks.grey).toBeLessThan(0.75 * inks.wider);
  expect(inks.shade).toBeLessThan(0.9 * inks.grey);
  expect(inks.hand).not.toBe(inks.shade);
  expect(new Set(programs.slice(0, 6)).size).toBe(1);
  expect(new Set(programs.slice(6)).size).toBe(1);
});

test('a dry outline catches on the tooth and is soft at its sides; the tooth stays with the sheet', {
  tag: '@all',
}, async ({ page }) => {
  const { none, middle, sides, greys, moved, other } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw } = window.lining;
    const mesh = await outlinedMesh(new THREE.PlaneGeometry(4, 1), { outlineWidth: 24 });
    const scene = paperScene(mesh);
    const { material } = outlinesOf(mesh);
    const inkOf = (paperGrain: number) => {
      material.setValues({ paperGrain });
      return draw(scene, lookFrom(0, 0, 4));
    };
    const [plain, dry] = [inkOf(0), inkOf(0.6)];
    // Along the outline that is looked at: it stays where it is, and what is fixed on the plane does not.
    mesh.position.x = 0.1;
    const dryMoved = inkOf(0.6);
    mesh.position.x = 0;
    material.paperGrainSize *= 1.5;
    const dryOther = inkOf(0.6);
    const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
    const places = [...plain.keys()].filter((i) => i % 400 > 100 && i % 400 < 300 && plain[i] === 1);
    const middleRow = 199.5 - 0.5 * (200 / (4 * Math.tan(THREE.MathUtils.degToRad(20))));
    const off = (i: number) => {
      const row = Math.floor(i / 400);
      return Math.abs(Math.min(row, 399 - row) - middleRow);
    };
    const change = (pixels: ArrayLike<number>) => mean(places.map((i) => Math.abs(pixels[i] - dry[i])));
    return {
      none: mean(places.map((i) => plain[i])),
      middle: mean(places.filter((i) => off(i) < 3).map((i) => dry[i])),
      sides: mean(places.filter((i) => off(i) > 8).map((i) => dry[i])),
      greys: mean(places.map((i) => Number(dry[i] > 0.1 && dry[i] < 0.9))),
      moved: change(dryMoved),
      other: change(dryOther),
    };
  });
  expect(none).toBe(1);
  expect(middle).toBeLessThan(1);
  expect(middle).toBeGreaterThan(0.8);
  expect(middle - sides).toBeGreaterThan(0.3);
  expect(sides).toBeGreaterThan(0.1);
  expect(greys).toBeGreaterThan(0.06);
  expect(moved).toBeLessThan(0.005);
  expect(other).toBeGreaterThan(0.05);
});

test('a geometry without outlines is reported once, and the scene is still drawn', async ({ page, pageProblems }) => {
  const ink = await page.evaluate(async () => {
    const { THREE, HatchingOutlines, paperScene, lookFrom, draw, total } = window.lining;
    const { HatchingMaterial } = window.toolkit;
    HatchingMaterial.silent = false;
    const mesh = new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshBasicMaterial({ color: 0 }));
    mesh.name = 'plain';
    mesh.add(new HatchingOutlines());
    const scene = paperScene(mesh);
    draw(scene, lookFrom(0, 0, 4));
    const ink = total(draw(scene, lookFrom(0, 0, 4)));
    HatchingMaterial.silent = true;
    return ink;
  });
  expect(ink).toBeGreaterThan(1000);
  expect(pageProblems.splice(0)).toEqual([
    expect.stringMatching(/the Mesh "plain".* has no outlines to draw\. .*outlines: true/),
  ]);
});

test('on a transparent canvas outlines bring their own alpha; a multisampled target has the same outlines', {
  tag: '@all',
}, async ({ page }) => {
  const { alphas, ink, sampled } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, lookFrom, paperScene, draw, rendererOf, total } = window.lining;
    const mesh = await outlinedMesh(new THREE.IcosahedronGeometry(1, 20), { isClear: true, outlineWidth: 3 });
    const scene = new THREE.Scene();
    scene.add(mesh);
    const camera = lookFrom(0, 0, 4.2);
    const renderer = rendererOf(300, { alpha: true, premultipliedAlpha: false });
    renderer.setClearAlpha(0);
    renderer.render(scene, camera);
    const gl = renderer.getContext();
    const pixels = new Uint8Array(4 * 300 * 300);
    gl.readPixels(0, 0, 300, 300, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const alphas = pixels.filter((_, i) => i % 4 === 3);
    const ink = total(draw(paperScene(mesh), camera, rendererOf(300, { antialias: false })));
    const sampled = total(draw(paperScene(mesh), camera, rendererOf(300, { antialias: true })));
    return { alphas: alphas.reduce((sum, alpha) => sum + alpha / 255, 0), ink, sampled };
  });
  expect(ink).toBeGreaterThan(1000);
  expect(alphas / ink).toBeGreaterThan(0.98);
  expect(alphas / ink).toBeLessThan(1.02);
  expect(sampled / ink).toBeGreaterThan(0.97);
  expect(sampled / ink).toBeLessThan(1.03);
});

test('there is an outline between the groups of a mesh with several materials, and none with a single material', async ({
  page,
}) => {
  const inks = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, pixelOf, inkNear } = window.lining;
    const sheet = new THREE.PlaneGeometry(2, 2, 4, 4);
    sheet.addGroup(0, 48, 0);
    sheet.addGroup(48, 48, 1);
    const camera = lookFrom(0, 0, 4.2);
    const mesh = await outlinedMesh(sheet);
    const middle = () =>
      inkNear(draw(paperScene(mesh), camera), 400, pixelOf(new THREE.Vector3(0.3, 0, 0), camera, 400), 1.5);
    const one = middle();
    const paper = mesh.material;
    Object.assign(mesh, { material: [paper, paper] });
    return [one, middle()];
  });
  expect(inks[0]).toBe(0);
  expect(inks[1]).toBeGreaterThan(0.5);
});

test('wobble is fixed to the object: wobbling outlines move no more than plain ones', {
  tag: '@all',
}, async ({ page }) => {
  const { strays, moved } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, strayInk, mostDifferent } = window.lining;
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1.4, 0.9, 1.1), { wobble: 3, weights: { creases: 1 } });
    const scene = paperScene(mesh);
    const from = (degrees: number) => {
      const angle = (degrees * Math.PI) / 180;
      return draw(scene, lookFrom(5 * Math.sin(angle), 2.4, 5 * Math.cos(angle), 28));
    };
    const steady = from(30);
    const strays = [strayInk(steady, from(30.5), 400, 3)];
    outlinesOf(mesh).material.wobble = 0;
    strays.push(strayInk(from(30), from(30.5), 400, 3));
    return { strays, moved: mostDifferent(steady, from(30)) };
  });
  expect(moved).toBeGreaterThan(0.5);
  expect(strays[0]).toBeLessThanOrEqual(strays[1] + 0.005);
});
