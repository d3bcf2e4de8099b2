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
    // A weight so small draws nothing, but asks for every triangle.
    outlines.material.weights.suggestiveContours = 1e-9;
    const all = draw(scene, camera);
    const ofAll = outlines.geometry.drawRange.count;
    outlines.material.weights.suggestiveContours = 0;
    let listed = draw(scene, camera);
    // The code of lists is fetched with the first frame of a page.
    while (outlines.geometry.drawRange.count === ofAll) {
      await new Promise(requestAnimationFrame);
      listed = draw(scene, camera);
    }
    const counts = [outlines.geometry.drawRange.count, ofAll];
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
    /** Curvature along the line of sight at the contour, where that line is tangent: 1 / r along the tube, cos v / (R + r cos v) around it. */
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
    // Some contours are hidden.
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
    const mesh = await outlinedMesh(new THREE.BoxGeometry(1, 0.2, 40), { weights: { creases: 1 } });
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
