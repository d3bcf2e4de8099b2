import type { HatchingOutlineParameters } from '../../src/material/outlines/HatchingOutlineMaterial.js';
import { quickIf } from '../browser/quickIf.js';
import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Contours, borders and creases: where they lie, how wide they are, what hides them, and what they are drawn on. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('a cube shows exactly nine of its twelve edges', async ({ page }) => {
  const edges = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, pixelOf, inkNear } = window.lining;
    const camera = lookFrom(2.2, 1.6, 2.9);
    const ink = draw(paperScene(await outlinedMesh(new THREE.BoxGeometry(1, 1, 1))), camera);
    const found: boolean[] = [];
    for (const axis of [0, 1, 2]) {
      for (const corner of [0, 1, 2, 3]) {
        const at = (t: number) => {
          const place = [0, 0, 0];
          place[axis] = t - 0.5;
          place[(axis + 1) % 3] = (corner & 1) - 0.5;
          place[(axis + 2) % 3] = (corner >> 1) - 0.5;
          return pixelOf(new THREE.Vector3(...place), camera, 400);
        };
        const places = [0.2, 0.35, 0.5, 0.65, 0.8].map((t) => inkNear(ink, 400, at(t), 1.5));
        found.push(places.every((one) => one > 0.5));
        if (places.some((one) => one > 0.2) !== found.at(-1)) throw new Error(`an edge is drawn in part: ${places}`);
      }
    }
    return found;
  });
  expect(edges.filter(Boolean)).toHaveLength(9);
});

for (const [triangles, detail] of [
  [5120, 15],
  [20480, 31],
] as const) {
  test(
    `the contour of a sphere of ${triangles} triangles lies within half a pixel of the true one`,
    quickIf(detail === 15),
    async ({ page }) => {
      const offsets = await page.evaluate(async (detail) => {
        const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf, mergeVertices } = window.lining;
        const source = new THREE.IcosahedronGeometry(1, detail);
        for (const name of ['uv', 'normal']) source.deleteAttribute(name);
        const mesh = await outlinedMesh(mergeVertices(source), { outlineWidth: 2 });
        // Off the axis, where the outline is an ellipse.
        const camera = lookFrom(0, 0, 4.2, 40);
        mesh.position.set(0.35, 0.2, 0);
        const size = 700;
        const ink = draw(paperScene(mesh), camera, rendererOf(size));
        // A pixel lies on the outline if its ray and that to the centre enclose asin(r / d).
        const toCentre = mesh.position.clone().sub(camera.position);
        const angle = Math.asin(1 / toCentre.length());
        toCentre.normalize();
        const pixelAngle = (x: number, y: number) => {
          const ray = new THREE.Vector3((2 * x) / size - 1, 1 - (2 * y) / size, 0.5)
            .unproject(camera)
            .sub(camera.position);
          return ray.normalize().angleTo(toCentre);
        };
        const bins = Array.from({ length: 72 }, () => ({ ink: 0, offset: 0 }));
        const centre = window.lining.pixelOf(mesh.position, camera, size);
        for (let y = 0; y < size; y++) {
          for (let x = 0; x < size; x++) {
            const darkness = ink[y * size + x];
            if (darkness < 0.02) continue;
            const [px, py] = [x + 0.5, y + 0.5];
            const there = pixelAngle(px, py);
            const [ux, uy] = [px - centre.x, py - centre.y];
            const away = Math.hypot(ux, uy);
            const perPixel = pixelAngle(px + ux / away, py + uy / away) - there;
            const bin = bins[Math.floor((Math.atan2(uy, ux) / (2 * Math.PI) + 0.5) * 71.999)];
            bin.ink += darkness;
            bin.offset += (darkness * (there - angle)) / perPixel;
          }
        }
        return bins.map(({ ink, offset }) => offset / ink);
      }, detail);
      for (const offset of offsets) expect(Math.abs(offset)).toBeLessThan(0.5);
    },
  );
}

test('outlines on a sphere are as wide as asked, centred on the outline or not', { tag: '@all' }, async ({ page }) => {
  const widths = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, rendererOf, total } = window.lining;
    const mesh = await outlinedMesh(new THREE.IcosahedronGeometry(1, 40));
    const camera = lookFrom(0, 0, 4.2);
    // The outline is a circle of this radius in pixels.
    const size = 500;
    const radius = (Math.tan(Math.asin(1 / 4.2)) / Math.tan(Math.PI / 9)) * (size / 2);
    return [2, 4].map((width) => {
      outlinesOf(mesh).material.outlineWidth = width;
      return total(draw(paperScene(mesh), camera, rendererOf(size))) / (2 * Math.PI * radius);
    });
  });
  expect(widths[0]).toBeGreaterThan(1.9);
  expect(widths[0]).toBeLessThan(2.1);
  expect(widths[1]).toBeGreaterThan(3.9);
  expect(widths[1]).toBeLessThan(4.1);
});

test('a torus has two closed contours from each of four views', async ({ page }) => {
  const loops = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlineDataOf } = window.lining;
    const { geometry } = await outlinedMesh(new THREE.TorusGeometry(1, 0.42, 48, 96));
    const { search, triangleCount } = outlineDataOf(geometry)!;
    const { positions, normals, primitives, pointMask } = search!;
    return [
      [0.4, 0.3, 4],
      [3, 1, 2.5],
      [0.2, 4, 1.4],
      [-2, -2, 3],
    ].map((eye) => {
      const faces = (point: number) =>
        [0, 1, 2].reduce((sum, k) => sum + normals[3 * point + k] * (eye[k] - positions[3 * point + k]), 0) >= 0;
      // The contour crosses each edge whose ends differ; a triangle it runs through joins two of them.
      const neighbours = new Map<string, string[]>();
      for (let triangle = 0; triangle < triangleCount; triangle++) {
        const points = [0, 1, 2].map((k) => primitives[4 * triangle + k] & pointMask);
        const crossed = [0, 1, 2]
          .map((k) => [points[k], points[(k + 1) % 3]])
          .filter(([a, b]) => faces(a) !== faces(b))
          .map((edge) => edge.toSorted((a, b) => a - b).join());
        if (crossed.length !== 2) continue;
        for (const [from, to] of [crossed, crossed.toReversed()]) {
          neighbours.set(from, [...(neighbours.get(from) ?? []), to]);
        }
      }
      let count = 0;
      const seen = new Set<string>();
      for (const [start, ends] of neighbours) {
        if (ends.length !== 2) throw new Error('a contour ends');
        if (seen.has(start)) continue;
        count++;
        const open = [start];
        for (let edge = open.pop(); edge !== undefined; edge = open.pop()) {
          if (seen.has(edge)) continue;
          seen.add(edge);
          open.push(...neighbours.get(edge)!);
        }
      }
      return count;
    });
  });
  expect(loops).toEqual([2, 2, 2, 2]);
});

test('no outline of a sphere shows through a sphere in front of it', async ({ page }) => {
  const { inside, outside } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, mostDifferent, total } = window.lining;
    const near = await outlinedMesh(new THREE.IcosahedronGeometry(1, 20));
    const far = await outlinedMesh(new THREE.IcosahedronGeometry(1, 20));
    far.position.z = -2.2;
    const camera = lookFrom(0, 0, 5);
    const alone = draw(paperScene(near), camera);
    const both = draw(paperScene(near, far), camera);
    far.position.x = 1.5;
    return {
      inside: mostDifferent(alone, both),
      outside: total(draw(paperScene(near, far), camera)) - total(alone),
    };
  });
  expect(inside).toBe(0);
  expect(outside).toBeGreaterThan(100);
});

test('with a list of candidates, without, and just before the list runs out the picture is the same', async ({
  page,
}) => {
  const { differences, counts } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, mostDifferent } = window.lining;
    const mesh = await outlinedMesh(new THREE.TorusKnotGeometry(0.7, 0.25, 200, 32));
    const outlines = outlinesOf(mesh);
    const scene = paperScene(mesh);
    const camera = lookFrom(1, 2, 4);
    const listed = draw(scene, camera);
    const counts = [outlines.geometry.drawRange.count];
    // A weight so small draws nothing, but asks for every triangle.
    outlines.material.suggestiveContours = 1e-9;
    const all = draw(scene, camera);
    counts.push(outlines.geometry.drawRange.count);
    outlines.material.suggestiveContours = 0;
    // 0.75° of turn at the distance from the sphere around it.
    const { radius } = mesh.geometry.boundingSphere!;
    const reach = Math.sin(Math.PI / 240) * (camera.position.length() - radius);
    camera.position.add(new THREE.Vector3(1, -0.5, 0).setLength(0.99 * reach));
    camera.updateMatrixWorld();
    const old = draw(scene, camera);
    counts.push(outlines.geometry.drawRange.count);
    const fresh = draw(scene, camera.clone());
    counts.push(outlines.geometry.drawRange.count);
    return { differences: [mostDifferent(listed, all), mostDifferent(old, fresh)], counts };
  });
  for (const difference of differences) expect(difference).toBeLessThanOrEqual(2 / 255);
  expect(counts[0]).toBeLessThan(0.3 * counts[1]);
  expect(counts[2]).toBe(counts[0]);
  expect(counts[3]).not.toBe(counts[0]);
});

test('above 100,000 triangles the worker makes the list; until it comes, nothing is missing', async ({ page }) => {
  const { difference, first, last } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, mostDifferent } = window.lining;
    const mesh = await outlinedMesh(new THREE.TorusKnotGeometry(0.7, 0.25, 900, 60));
    const outlines = outlinesOf(mesh);
    const scene = paperScene(mesh);
    const camera = lookFrom(1, 2, 4);
    const all = draw(scene, camera);
    const first = outlines.geometry.drawRange.count;
    let listed = all;
    while (outlines.geometry.drawRange.count === first) {
      await new Promise(requestAnimationFrame);
      listed = draw(scene, camera);
    }
    return { difference: mostDifferent(all, listed), first, last: outlines.geometry.drawRange.count };
  });
  expect(difference).toBeLessThanOrEqual(2 / 255);
  expect(first).toBeGreaterThanOrEqual(3 * 108_000);
  expect(last).toBeLessThan(0.3 * first);
});

test('a contour tapers to nothing where it ends in a cusp', { tag: '@all' }, async ({ page }) => {
  const { tapered, blunt, along } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, pixelOf, rendererOf } = window.lining;
    const [R, r] = [1, 0.42];
    const mesh = await outlinedMesh(new THREE.TorusGeometry(R, r, 160, 320), { outlineWidth: 6 });
    const camera = lookFrom(0, -3.2, 2.1);
    const at = (u: number, v: number) =>
      new THREE.Vector3((R + r * Math.cos(v)) * Math.cos(u), (R + r * Math.cos(v)) * Math.sin(u), r * Math.sin(v));
    const normal = (u: number, v: number) =>
      new THREE.Vector3(Math.cos(v) * Math.cos(u), Math.cos(v) * Math.sin(u), Math.sin(v));
    /** Of the line of sight, at the contour, where it lies in the surface: 1 / r along the tube, cos v / (R + r cos v) around. */
    const bend = (u: number, v: number) => {
      const sight = camera.position.clone().sub(at(u, v)).normalize();
      const around = new THREE.Vector3(-Math.sin(u), Math.cos(u), 0).dot(sight);
      return (1 - around * around) / r + (around * around * Math.cos(v)) / (R + r * Math.cos(v));
    };
    // The contour on the inner side: for each u the v at which n·v changes sign there.
    const inner: { u: number; v: number; bend: number }[] = [];
    for (let u = 0; u < 2 * Math.PI; u += 0.002) {
      const facing = (v: number) => normal(u, v).dot(camera.position.clone().sub(at(u, v)));
      for (let v = Math.PI / 2; v < 1.5 * Math.PI; v += 0.002) {
        if (facing(v) * facing(v + 0.002) > 0) continue;
        inner.push({ u, v, bend: bend(u, v) });
      }
    }
    const cusps = inner.filter(({ bend }, i) => i > 0 && bend * inner[i - 1].bend < 0);
    const full = inner.reduce((best, one) => (one.bend > best.bend ? one : best));
    const outlines = outlinesOf(mesh);
    const size = 700;
    const darknessAt = (place: { u: number; v: number }, taper: number) => {
      outlines.material.taper = taper;
      const ink = draw(paperScene(mesh), camera, rendererOf(size));
      const { x, y } = pixelOf(at(place.u, place.v), camera, size);
      let sum = 0;
      for (let j = -6; j <= 6; j++)
        for (let i = -3; i <= 3; i++) sum += ink[(Math.round(y) + j) * size + Math.round(x) + i];
      return sum;
    };
    // Some are hidden.
    const cusp = cusps.reduce((best, one) => (darknessAt(one, 0) > darknessAt(best, 0) ? one : best));
    return { tapered: darknessAt(cusp, 0.8), blunt: darknessAt(cusp, 0), along: darknessAt(full, 0.8) };
  });
  expect(along).toBeGreaterThan(15);
  expect(blunt).toBeGreaterThan(8);
  expect(tapered).toBeLessThan(0.7 * blunt);
});

test('outlines stay where they are while the camera turns by a degree', async ({ page }) => {
  const strays = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, strayInk, loadModel } = window.lining;
    const plate = new THREE.Shape(
      [
        [-1, -0.6],
        [1, -0.6],
        [1, 0.5],
        [-1, 0.5],
      ].map(([x, y]) => new THREE.Vector2(x, y)),
    );
    plate.holes.push(new THREE.Path().absarc(0.3, 0, 0.3, 0, 2 * Math.PI, true));
    const part = new THREE.ExtrudeGeometry(plate, { depth: 0.7, bevelEnabled: false, curveSegments: 24 }).center();
    const strays: number[] = [];
    for (const source of [await loadModel('bunny'), part, new THREE.TorusKnotGeometry(0.6, 0.2, 160, 24)]) {
      const scene = paperScene(await outlinedMesh(source));
      const from = (degrees: number) => {
        const angle = (degrees * Math.PI) / 180;
        return draw(scene, lookFrom(3.2 * Math.sin(angle), 1.1, 3.2 * Math.cos(angle)));
      };
      for (const degrees of [20, 130]) strays.push(strayInk(from(degrees), from(degrees + 1), 400, 4));
    }
    return strays;
  });
  for (const stray of strays) expect(stray).toBeLessThan(0.01);
});

test('an orthographic camera sees the circle of a sphere', async ({ page }) => {
  const { width, furthest } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, draw, total } = window.lining;
    const mesh = await outlinedMesh(new THREE.IcosahedronGeometry(1, 31), { outlineWidth: 2 });
    const camera = new THREE.OrthographicCamera(-1.25, 1.25, 1.25, -1.25, 0.1, 10);
    camera.position.set(1, 2, 3);
    camera.lookAt(0, 0, 0);
    const ink = draw(paperScene(mesh), camera);
    let furthest = 0;
    ink.forEach((darkness, i) => {
      if (darkness > 0.5) {
        const away = Math.hypot((i % 400) + 0.5 - 200, Math.floor(i / 400) + 0.5 - 200);
        furthest = Math.max(furthest, Math.abs(away - 160));
      }
    });
    return { width: total(ink) / (2 * Math.PI * 160), furthest };
  });
  expect(width).toBeGreaterThan(1.9);
  expect(width).toBeLessThan(2.1);
  expect(furthest).toBeLessThan(2);
});

test('an outline that runs past the camera is cut off there, not dropped', async ({ page }) => {
  const { bottom, middle } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, draw, pixelOf, inkNear } = window.lining;
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 0.2, 40), { creases: 1 });
    const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 100);
    camera.position.set(0, 1, 5);
    const ink = draw(paperScene(mesh), camera);
    // An edge from z = −20, ahead, to z = 20, far behind.
    const at = (z: number) => inkNear(ink, 400, pixelOf(new THREE.Vector3(0.5, 0.1, z), camera, 400), 1.5);
    return { bottom: at(2.6), middle: at(-6) };
  });
  expect(bottom).toBeGreaterThan(0.4);
  expect(middle).toBeGreaterThan(0.4);
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

test('tiles of a picture fit together', { tag: '@all' }, async ({ page }) => {
  const difference = await page.evaluate(async () => {
    const { THREE, outlinedMesh, paperScene, lookFrom, draw, rendererOf } = window.lining;
    const parameters = { wobble: 1.5, outlineWidth: 3, tooth: 0.6 };
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
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 0.2, 40), { creases: 1, isClear: true });
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
    const mesh = await outlinedMesh(new THREE.TorusGeometry(0.4, 0.2, 24, 40), { shadeWeights: [0.5, 1.4] });
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
      ['no creases', { creases: 0 }],
      ['nothing', { contours: 0, borders: 0 }],
      ['grey', { contours: 1, creases: 1, ink: new THREE.Color(0.5, 0.5, 0.5) }],
      ['shade', { shadeWeights: [0, 1] }],
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
    const inkOf = (tooth: number) => {
      material.setValues({ tooth });
      return draw(scene, lookFrom(0, 0, 4));
    };
    const [plain, dry] = [inkOf(0), inkOf(0.6)];
    // Along the outline that is looked at: it stays where it is, and what is fixed on the plane does not.
    mesh.position.x = 0.1;
    const dryMoved = inkOf(0.6);
    mesh.position.x = 0;
    material.toothSize *= 1.5;
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

test('the hand that strays belongs to the object: its outlines move no more than the outlines themselves', {
  tag: '@all',
}, async ({ page }) => {
  const { strays, moved } = await page.evaluate(async () => {
    const { THREE, outlinedMesh, outlinesOf, paperScene, lookFrom, draw, strayInk, mostDifferent } = window.lining;
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1.4, 0.9, 1.1), { wobble: 3, creases: 1 });
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
