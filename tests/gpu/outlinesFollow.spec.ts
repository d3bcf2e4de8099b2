import type * as Three from 'three';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Whatever decides whether and where three.js draws a mesh decides it for its outlines, in the frame that is drawn. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('layers, opacity, colour and scale of a mesh are those of its outlines', async ({ page }) => {
  const { whole, inks } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, total } = window.lining;
    const renderer = rendererOf(160);
    const ink = async (arrange: (mesh: Three.Mesh, camera: Three.Camera) => void) => {
      const mesh = await outlinedMesh(new THREE.IcosahedronGeometry(1, 12), { outlineWidth: 3 });
      const camera = lookFrom(0, 0, 4);
      const scene = paperScene(mesh);
      draw(scene, camera, renderer);
      arrange(mesh, camera);
      return total(draw(scene, camera, renderer));
    };
    const set = (values: Three.MaterialParameters) => (mesh: Three.Mesh) => {
      Object.assign(mesh.material, values);
    };
    return {
      whole: await ink(() => {}),
      inks: {
        layer: await ink((mesh) => mesh.layers.set(1)),
        layers: await ink((mesh, camera) => {
          mesh.layers.set(1);
          camera.layers.set(1);
        }),
        faded: await ink(set({ transparent: true, opacity: 0.25 })),
        opaque: await ink(set({ opacity: 0.25 })),
        seeThrough: await ink(set({ transparent: true, opacity: 0 })),
        colourless: await ink(set({ colorWrite: false })),
        forward: await ink(set({ polygonOffset: true, polygonOffsetFactor: -4, polygonOffsetUnits: -8 })),
        backward: await ink(set({ polygonOffset: true, polygonOffsetFactor: 4, polygonOffsetUnits: 8 })),
        nothing: await ink((mesh) => mesh.scale.setScalar(0)),
      },
    };
  });
  expect(whole).toBeGreaterThan(300);
  for (const name of ['layer', 'seeThrough', 'colourless', 'nothing'] as const) expect(inks[name], name).toBe(0);
  for (const name of ['layers', 'opaque', 'forward', 'backward'] as const)
    expect(inks[name] / whole, name).toBeCloseTo(1, 1);
  // Overlapping pieces of a line darken each other.
  expect(inks.faded / whole).toBeGreaterThan(0.2);
  expect(inks.faded / whole).toBeLessThan(0.4);
});

test('stencil, depth test and clipping planes of a mesh are those of its outlines, and of no other mesh', async ({
  page,
}) => {
  const inks = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, outlinesOf, rendererOf, inkOf } = window.lining;
    const renderer = rendererOf(200, { stencil: true });
    renderer.localClippingEnabled = true;
    const camera = lookFrom(0, 0, 6);
    const left = new THREE.Plane(new THREE.Vector3(-1, 0, 0), 0);
    /** The ink of a ball in the upper half of a picture, and of another with the same outlines in the lower: left and right. */
    const inkOfQuarters = async (material: Three.MaterialParameters, ...others: Three.Object3D[]) => {
      const ball = await outlinedMesh(new THREE.IcosahedronGeometry(0.8, 12), { outlineWidth: 3 });
      const plain = await outlinedMesh(new THREE.IcosahedronGeometry(0.8, 12));
      outlinesOf(plain).material = outlinesOf(ball).material;
      ball.position.y = 1;
      plain.position.y = -1;
      Object.assign(ball.material, material);
      renderer.render(paperScene(ball, plain, ...others), camera);
      const sums = [0, 0, 0, 0];
      for (const [i, ink] of inkOf(renderer).entries()) sums[2 * Number(i >= 20000) + Number(i % 200 >= 100)] += ink;
      return sums;
    };
    const mask = new THREE.Mesh(new THREE.PlaneGeometry(10, 10), new THREE.MeshBasicMaterial());
    mask.position.set(-5, 0, -2);
    mask.renderOrder = -1;
    const marking = { stencilWrite: true, stencilRef: 1, stencilZPass: THREE.ReplaceStencilOp };
    Object.assign(mask.material, marking);
    const wall = new THREE.Mesh(new THREE.PlaneGeometry(10, 4), new THREE.MeshBasicMaterial());
    wall.position.set(0, 2, 2);
    wall.renderOrder = -1;
    const found = {
      plain: await inkOfQuarters({}),
      stencil: await inkOfQuarters(
        { stencilWrite: true, stencilRef: 1, stencilFunc: THREE.EqualStencilFunc, depthWrite: true },
        mask,
      ),
      once: await inkOfQuarters({
        stencilWrite: true,
        stencilRef: 1,
        stencilFunc: THREE.NotEqualStencilFunc,
        stencilZPass: THREE.ReplaceStencilOp,
      }),
      clipped: await inkOfQuarters({ clippingPlanes: [left] }),
      behind: await inkOfQuarters({}, wall),
      before: await inkOfQuarters({ depthTest: false }, wall),
      onlyBehind: await inkOfQuarters({ depthFunc: THREE.GreaterDepth, depthWrite: false }, wall),
    };
    renderer.localClippingEnabled = false;
    return found;
  });
  const [upperLeft, upperRight, lowerLeft, lowerRight] = inks.plain;
  expect(Math.min(...inks.plain)).toBeGreaterThan(80);
  for (const [name, [, , left, right]] of Object.entries(inks)) {
    expect(left / lowerLeft, name).toBeCloseTo(1, 1);
    expect(right / lowerRight, name).toBeCloseTo(1, 1);
  }
  for (const name of ['stencil', 'clipped'] as const) {
    expect(inks[name][0] / upperLeft, name).toBeGreaterThan(0.9);
    expect(inks[name][1] / upperRight, name).toBeLessThan(0.1);
  }
  expect(inks.behind[0] + inks.behind[1]).toBe(0);
  for (const name of ['once', 'before', 'onlyBehind'] as const)
    expect(inks[name][0] / upperLeft, name).toBeCloseTo(1, 1);
});

test('groups of a mesh fade, vanish and are cut with what draws them', async ({ page }) => {
  const found = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, pixelOf, inkNear } = window.lining;
    const camera = lookFrom(1.6, 1.6, 3);
    const renderer = rendererOf(200);
    const look = async (change: (mesh: Three.Mesh, materials: Three.Material[]) => void) => {
      const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 1, 1), { outlineWidth: 3, weights: { creases: 1 } });
      const materials = Array.from({ length: 6 }, () => new THREE.MeshBasicMaterial());
      (mesh as Three.Mesh).material = materials;
      change(mesh, materials);
      const ink = draw(paperScene(mesh), camera, renderer);
      const at = (x: number, y: number, z: number) =>
        inkNear(ink, 200, pixelOf(new THREE.Vector3(x, y, z), camera, 200), 2);
      return {
        // The edges between the right, the upper and the front side.
        upper: at(0, 0.5, 0.5),
        lower: at(0, -0.5, 0.5),
        right: at(0.5, -0.5, 0),
        front: at(0.5, 0, 0.5),
      };
    };
    return {
      whole: await look(() => {}),
      // All sides but the front, which is the fifth.
      open: await look((_, materials) => {
        materials[4].visible = false;
      }),
      faded: await look((_, materials) => {
        Object.assign(materials[4], { transparent: true, opacity: 0.4 });
      }),
      alone: await look((mesh) => mesh.geometry.setDrawRange(24, 6)),
    };
  });
  const { whole, open, faded, alone } = found;
  for (const edge of ['upper', 'lower', 'right', 'front'] as const) {
    expect(whole[edge], edge).toBeGreaterThan(0.9);
    if (edge !== 'lower') expect(open[edge], edge).toBeGreaterThan(0.9);
  }
  // Without the front the lower side is seen from its back, which is not drawn.
  expect(open.lower).toBe(0);
  // The edge between it and the sides that do not fade belongs to those sides.
  expect(faded.upper).toBeGreaterThan(0.9);
  for (const edge of ['upper', 'lower', 'front'] as const) expect(alone[edge], edge).toBeGreaterThan(0.9);
  expect(alone.right).toBe(0);
});

test('instances of scale 0 leave no dot', async ({ page }) => {
  const inks = await page.evaluate(async () => {
    const { THREE, outlinedInstances, paperScene, lookFrom, draw, rendererOf, total } = window.lining;
    const inkAt = async (scale: number) => {
      const places = [1, scale].map((size, i) =>
        new THREE.Matrix4().makeScale(size, size, size).setPosition(2 * i - 1, 0, 0),
      );
      const many = await outlinedInstances(new THREE.BoxGeometry(1, 1, 1), places, { outlineWidth: 6 });
      const scene = paperScene(many);
      return [0, 1].map(() => total(draw(scene, lookFrom(0.5, 0.6, 5), rendererOf(160))));
    };
    return { one: await inkAt(0), two: await inkAt(1), alone: await inkAt(1e-7) };
  });
  expect(inks.two[0]).toBeGreaterThan(1.5 * inks.one[0]);
  // A very small one is a dot.
  for (const [i, ink] of inks.one.entries()) expect(ink).toBeLessThan(inks.alone[i] + 1e-3);
});

test('where a picture or vertices cut a surface away, it has no outlines', async ({ page }) => {
  const found = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, pixelOf, inkNear, total } = window.lining;
    const camera = lookFrom(1.6, 1.6, 3);
    const renderer = rendererOf(200);
    // The left half of every side is there.
    const half = new THREE.DataTexture(Uint8Array.of(255, 255, 255, 255, 255, 255, 255, 0), 2, 1);
    half.needsUpdate = true;
    const look = async (material: Three.MeshBasicMaterialParameters, change?: (mesh: Three.Mesh) => void) => {
      const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 1, 1), { outlineWidth: 3, weights: { creases: 1 } });
      Object.assign(mesh.material, material);
      change?.(mesh);
      const ink = draw(paperScene(mesh), camera, renderer);
      const at = (x: number, y: number, z: number) =>
        inkNear(ink, 200, pixelOf(new THREE.Vector3(x, y, z), camera, 200), 2);
      return {
        // The lower edge of the front side: where it is drawn and where it is not.
        kept: at(-0.25, -0.5, 0.5),
        cut: at(0.25, -0.5, 0.5),
        // Between it, where it is not, and the side to the right, which is there.
        between: at(0.5, 0, 0.5),
        all: total(ink),
      };
    };
    const fading = (mesh: Three.Mesh) => {
      const { position } = mesh.geometry.attributes;
      const color = new THREE.BufferAttribute(new Float32Array(4 * position.count).fill(1), 4);
      for (let i = 0; i < position.count; i++) color.setW(i, position.getX(i) < 0 ? 1 : 0);
      mesh.geometry.setAttribute('color', color);
    };
    const alphaMap = new THREE.DataTexture(Uint8Array.of(255, 255, 255, 255, 0, 0, 0, 255), 2, 1);
    alphaMap.needsUpdate = true;
    return {
      whole: await look({}),
      opaque: await look({ map: half }),
      map: await look({ map: half, alphaTest: 0.5 }),
      alphaMap: await look({ alphaMap, alphaTest: 0.5 }),
      hashed: await look({ map: half, alphaHash: true }),
      unused: await look({ alphaTest: 0.5 }),
      blended: await look({ map: half, alphaTest: 0.5, transparent: true }),
      vertices: await look({ vertexColors: true, alphaTest: 0.5 }, fading),
    };
  });
  const { whole, vertices, ...others } = found;
  for (const [name, look] of Object.entries({ whole, ...others })) {
    expect(look.kept, name).toBeGreaterThan(0.9);
    expect(look.between, name).toBeGreaterThan(0.9);
  }
  for (const name of ['map', 'alphaMap', 'hashed'] as const) expect(found[name].cut, name).toBe(0);
  for (const name of ['opaque', 'unused', 'blended'] as const)
    expect(found[name].all / whole.all, name).toBeCloseTo(1, 2);
  expect([vertices.kept > 0.9, vertices.cut, vertices.between]).toEqual([true, 0, 0]);
});

test('a canvas with antialiasing that becomes a little smaller keeps all of its outlines', async ({ page }) => {
  const differences = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, inkOf, mostDifferent } = window.lining;
    const knot = await outlinedMesh(new THREE.TorusKnotGeometry(0.8, 0.3, 96, 16), { outlineWidth: 2 });
    const scene = paperScene(knot);
    const rendererOfItsOwn = () => {
      const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
      renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
      return renderer;
    };
    const picture = (renderer: Three.WebGLRenderer, [width, height]: readonly [number, number]) => {
      renderer.setSize(width, height, false);
      const camera = lookFrom(0, 0, 4);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      renderer.render(scene, camera);
      return inkOf(renderer);
    };
    const resized = rendererOfItsOwn();
    const found: number[] = [];
    for (const size of [
      [300, 220],
      [294, 214],
      [280, 210],
      [300, 220],
    ] as const) {
      const fresh = rendererOfItsOwn();
      found.push(mostDifferent(picture(resized, size), picture(fresh, size)));
      fresh.dispose();
      fresh.forceContextLoss();
    }
    resized.dispose();
    resized.forceContextLoss();
    return found;
  });
  for (const difference of differences) expect(difference).toBeLessThan(0.02);
});

test('several views on one canvas have the outlines of each alone', async ({ page }) => {
  const { difference, ink } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, inkOf, rendererOf, total } = window.lining;
    const knot = await outlinedMesh(new THREE.TorusKnotGeometry(0.8, 0.3, 96, 16), { outlineWidth: 2 });
    const scene = paperScene(knot);
    const renderer = rendererOf(200, { antialias: true });
    const views = [lookFrom(0, 0, 4), lookFrom(3, 2, 2)];
    const drawView = (i: number) => {
      renderer.setViewport(100 * i, 50 * i, 100, 100);
      renderer.setScissor(100 * i, 50 * i, 100, 100);
      renderer.setScissorTest(true);
      renderer.render(scene, views[i]);
    };
    const pictureOf = (...shown: number[]) => {
      renderer.setScissorTest(false);
      renderer.clear();
      for (const i of shown) drawView(i);
      renderer.setScissorTest(false);
      renderer.setViewport(0, 0, 200, 200);
      return inkOf(renderer);
    };
    renderer.setClearColor(0xffffff);
    const both = pictureOf(0, 1);
    const [left, right] = [pictureOf(0), pictureOf(1)];
    const apart = left.map((one, i) => Math.max(one, right[i]));
    return { difference: both.reduce((most, one, i) => Math.max(most, Math.abs(one - apart[i])), 0), ink: total(both) };
  });
  expect(ink).toBeGreaterThan(300);
  expect(difference).toBeLessThan(0.02);
});
