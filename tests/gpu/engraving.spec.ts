import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** The technique `engraving`: the tone of its lines, their spacing, and what they are fixed to. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('the mean darkness is the tone, at every distance between octaves, with and without crossing and hand', {
  tag: '@all',
}, async ({ page }) => {
  const errors = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(2, 2).rotateZ(0.3), { layout: 'indexed' });
    const material = new HatchingMaterial({ technique: 'engraving', direction: 'y', screenSpaceShare: 1 });
    const mesh = new THREE.Mesh(geometry, material);
    const light = new THREE.AmbientLight(0xffffff, 0);
    const scene = paperScene(mesh, light);
    const camera = new THREE.OrthographicCamera(-0.6, 0.6, 0.6, -0.6, 0.1, 10);
    camera.position.z = 2;
    const errors: { error: number; technique: 'engraving' | 'pen'; tone: number }[] = [];
    for (const [irregularity, crossFrom, technique] of [
      [0, 0.52, 'engraving'],
      [0, 1, 'engraving'],
      [0.4, 0.52, 'engraving'],
      [0.4, 0.52, 'pen'],
    ] as const) {
      Object.assign(material, { irregularity, crossFrom, technique, strokeLength: 30 });
      for (const tone of [0.1, 0.3, 0.5, 0.7, 0.85, 0.95]) {
        // A white surface shows a radiance of the intensity over π.
        light.intensity = Math.PI * (1 - tone);
        for (let eighth = 0; eighth < 8; eighth++) {
          camera.zoom = 2 ** (eighth / 8);
          camera.updateProjectionMatrix();
          const ink = draw(scene, camera, rendererOf(300));
          const mean = ink.reduce((sum, one) => sum + one, 0) / ink.length;
          errors.push({ error: Math.abs(mean - tone), technique, tone });
        }
      }
    }
    return errors;
  });
  expect(errors).toHaveLength(192);
  // A pen crosses lines in its darkest tones in three directions of one regular lattice, whose gaps meet less often than by chance.
  for (const { error, technique, tone } of errors) {
    expect(error, `${technique} at ${tone}`).toBeLessThan(technique === 'pen' && tone > 0.9 ? 0.035 : 0.012);
  }
});

test('carved lines are white wedges that end in points, and their mean is the tone', async ({ page }) => {
  const found = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry, wholePieces } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(2, 2), { layout: 'indexed' });
    const material = new HatchingMaterial({
      technique: 'woodcut',
      crossFrom: 1,
      direction: 'y',
      screenSpaceShare: 1,
      irregularity: 0,
      strokeLength: 50,
    });
    const light = new THREE.AmbientLight(0xffffff, 0);
    const scene = paperScene(new THREE.Mesh(geometry, material), light);
    const camera = new THREE.OrthographicCamera(-0.6, 0.6, 0.6, -0.6, 0.1, 10);
    camera.position.z = 2;
    const size = 300;
    const drawn = (tone: number, eighth: number) => {
      light.intensity = Math.PI * (1 - tone);
      camera.zoom = 2 ** (eighth / 8);
      camera.updateProjectionMatrix();
      return draw(scene, camera, rendererOf(size));
    };
    const errors: number[] = [];
    for (const tone of [0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 1]) {
      for (const eighth of [0, 2, 4, 6]) {
        const ink = drawn(tone, eighth);
        errors.push(ink.reduce((sum, one) => sum + one, 0) / ink.length - tone);
      }
    }
    // Wide enough apart for their forms to be measured. Widths of each white piece, column by column.
    material.lineSpacing = 14;
    const ink = drawn(0.75, 0);
    const pieces: { length: number; mean: number; most: number; ends: number }[] = [];
    for (const piece of wholePieces(size, (i) => ink[i] <= 0.5)) {
      const widths = new Map<number, number>();
      for (const i of piece) widths.set(i % size, (widths.get(i % size) ?? 0) + 1 - ink[i]);
      if (widths.size < 20) continue;
      const row = [...widths.keys()].toSorted((a, b) => a - b).map((x) => widths.get(x)!);
      const most = Math.max(...row);
      const mean = row.reduce((sum, width) => sum + width, 0) / row.length;
      pieces.push({ length: row.length, mean, most, ends: Math.max(row[0], row.at(-1)!) });
    }
    return { errors, pieces };
  });
  for (const error of found.errors) expect(Math.abs(error), `${found.errors}`).toBeLessThan(0.02);
  expect(found.pieces.length).toBeGreaterThan(20);
  for (const { length, mean, most, ends } of found.pieces) {
    expect(length).toBeGreaterThan(3 * most);
    // A wedge that is as wide as it ever is in one place alone has half of that width in the mean; a bar has all of it.
    expect(mean / most).toBeLessThan(0.7);
    expect(ends).toBeLessThan(2);
  }
});

test('lines lie as far apart as asked on the screen, from near and far, or half as far where new ones are born', async ({
  page,
}) => {
  const spacings = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(8, 8), { layout: 'indexed' });
    const material = new HatchingMaterial({
      technique: 'engraving',
      irregularity: 0,
      direction: 'y',
      screenSpaceShare: 1,
      lineSpacing: 6,
      crossFrom: 1,
    });
    const scene = paperScene(new THREE.Mesh(geometry, material), new THREE.AmbientLight(0xffffff, 0.6 * Math.PI));
    const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50);
    return [1, 1.6, 2.3, 3.4, 5].map((distance) => {
      camera.position.z = distance;
      const ink = draw(scene, camera, rendererOf(300));
      // Lines are level: count where a column gets dark.
      let lines = 0;
      for (let y = 1; y < 300; y++) if (ink[y * 300 + 150] >= 0.2 && ink[(y - 1) * 300 + 150] < 0.2) lines++;
      return 300 / lines;
    });
  });
  for (const spacing of spacings) {
    expect(spacing).toBeGreaterThan(2.9);
    expect(spacing).toBeLessThan(7);
  }
});

test('a picture of more pixels has the same lines, whatever they are sized on, and so has one of fewer while something moves', async ({
  page,
}) => {
  const { pictures, inMotion } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry, scaledSizes } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(8, 8), { layout: 'indexed' });
    const look = { technique: 'engraving', irregularity: 0, direction: 'y', crossFrom: 1 } as const;
    const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50);
    camera.position.z = 5;
    /** The middle column of a picture with sizes as they are given, or with others too. */
    const columnOf = (size: number, sizes: object): number[] => {
      const material = new HatchingMaterial({ ...look, ...sizes });
      const scene = paperScene(new THREE.Mesh(geometry, material), new THREE.AmbientLight(0xffffff, 0.7 * Math.PI));
      const ink = draw(scene, camera, rendererOf(size));
      return Array.from({ length: size }, (_, y) => ink[y * size + size / 2]);
    };
    const outlinesIn = (column: number[]) =>
      column.filter((ink, y) => y > 0 && ink >= 0.3 && column[y - 1] < 0.3).length;
    const pictures = [0, 0.5, 1].map((screenSpaceShare) => {
      const sizes = { screenSpaceShare, lineSpacing: [80, 20, 5][2 * screenSpaceShare] };
      return [1, 2, 4].map((factor) => outlinesIn(columnOf(150 * factor, { ...sizes, ...scaledSizes(sizes, factor) })));
    });
    const sizes = { screenSpaceShare: 1, lineSpacing: 4.5, minLineSpacing: 3 };
    const { minLineSpacing: _, ...bound } = scaledSizes(sizes, 0.5);
    const full = columnOf(300, sizes);
    /** The difference between a column at half resolution and the full one scaled down. */
    const awayFrom = (half: number[]) => {
      const away = half.map((ink, y) => Math.abs(ink - (full[2 * y] + full[2 * y + 1]) / 2));
      return away.reduce((sum, one) => sum + one) / half.length;
    };
    const inMotion = [
      { ...sizes, ...scaledSizes(sizes, 0.5) },
      { ...sizes, ...bound },
    ].map((half) => awayFrom(columnOf(150, half)));
    return { pictures, inMotion };
  });
  for (const lines of pictures) {
    expect(lines[0]).toBeGreaterThan(20);
    for (const others of lines) expect(Math.abs(others - lines[0]), JSON.stringify(lines)).toBeLessThanOrEqual(1);
  }
  const [scaled, bounded] = inMotion;
  // The bound that holds at rest would leave out every other line of what moves.
  expect(scaled).toBeLessThan(0.08);
  expect(bounded).toBeGreaterThan(2 * scaled);
});

test('lines cut by an axis stay while the light moves; those cut by the light turn with it', async ({ page }) => {
  const { still, turned } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom, mostDifferent } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.IcosahedronGeometry(1, 20), { layout: 'indexed' });
    const material = new HatchingMaterial({ technique: 'engraving', screenSpaceShare: 1 });
    const sun = new THREE.DirectionalLight(0xffffff, 1e-3);
    const scene = paperScene(new THREE.Mesh(geometry, material), sun, new THREE.AmbientLight(0xffffff, 0.6 * Math.PI));
    const changeWith = (direction: 'light' | 'x') => {
      material.direction = direction;
      const pictures = [
        [1, 1, 1],
        [-1, 1, 0.2],
      ].map(([x, y, z]) => {
        sun.position.set(x, y, z);
        return draw(scene, lookFrom(0, 0, 4), rendererOf(300));
      });
      return mostDifferent(pictures[0], pictures[1]);
    };
    return { still: changeWith('x'), turned: changeWith('light') };
  });
  expect(still).toBeLessThan(0.02);
  expect(turned).toBeGreaterThan(0.5);
});

test('the triangulation does not show: a flat sheet of 2 and of 5,000 triangles are drawn alike', async ({ page }) => {
  const differing = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const light = new THREE.DirectionalLight(0xffffff, 1.5);
    light.position.set(1, 2, 2);
    const pictures: Float32Array[] = [];
    for (const parts of [1, 50]) {
      const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(2, 2, parts, parts), {
        layout: 'indexed',
      });
      const material = new HatchingMaterial({ technique: 'engraving', screenSpaceShare: 1 });
      pictures.push(draw(paperScene(light, new THREE.Mesh(geometry, material)), lookFrom(1, 1, 3), rendererOf(300)));
    }
    return pictures[0].filter((one, i) => Math.abs(one - pictures[1][i]) > 0.1).length;
  });
  expect(differing).toBeLessThan(90);
});

test('a scene that is engraved needs no map, and keeps its indices', async ({ page }) => {
  const { isReady, layout, ink } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom, total } = window.lining;
    const { applyHatching } = window.toolkit;
    const mesh = new THREE.Mesh(new THREE.TorusGeometry(0.8, 0.3, 24, 48), new THREE.MeshLambertMaterial());
    await applyHatching(mesh, { material: { technique: 'engraving', screenSpaceShare: 1 } });
    const light = new THREE.DirectionalLight(0xffffff, 2);
    const ink = total(draw(paperScene(light, mesh), lookFrom(1, 2, 4), rendererOf(300)));
    return {
      isReady: window.toolkit.TonalArtMap.shared().isReady,
      layout: mesh.geometry.userData.hatching.layout,
      ink,
    };
  });
  // Nobody has asked for it before.
  expect(isReady).toBe(false);
  expect(layout).toBe('indexed');
  expect(ink).toBeGreaterThan(1500);
});

test('lines hold fast to a mesh that bends: engraving moves with the surface', async ({ page }) => {
  const { moved, held } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom, mostDifferent } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const source = new THREE.CylinderGeometry(0.4, 0.4, 2, 32, 20);
    const count = source.attributes.position.count;
    source.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Uint16Array(4 * count), 4));
    source.setAttribute(
      'skinWeight',
      new THREE.Float32BufferAttribute(
        Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0)),
        4,
      ),
    );
    const geometry = await prepareHatchingGeometry(source, { layout: 'indexed' });
    const material = new HatchingMaterial({ technique: 'engraving', direction: 'y', irregularity: 0, crossFrom: 1 });
    const mesh = new THREE.SkinnedMesh(geometry, material);
    const bone = new THREE.Bone();
    mesh.add(bone);
    mesh.bind(new THREE.Skeleton([bone]));
    const scene = paperScene(mesh, new THREE.AmbientLight(0xffffff, 0.5 * Math.PI));
    const picture = () => draw(scene, lookFrom(0, 0.5, 4), rendererOf(300));
    const before = picture();
    // A shift of the bone shifts everything, lines included: seen from a camera shifted as well nothing has changed.
    bone.position.set(0.3, 0.2, -0.1);
    const moved = mostDifferent(before, picture());
    const camera = lookFrom(0, 0.5, 4);
    camera.position.add(bone.position);
    const held = mostDifferent(before, draw(scene, camera, rendererOf(300)));
    return { moved, held };
  });
  expect(moved).toBeGreaterThan(0.5);
  expect(held).toBeLessThan(0.1);
});

test('around a near lamp lines are cut by spheres: on a floor they are circles about its foot', async ({ page }) => {
  const spread = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial } = window.toolkit;
    const material = new HatchingMaterial({
      technique: 'engraving',
      irregularity: 0,
      crossFrom: 1,
      screenSpaceShare: 1,
      lineSpacing: 12,
    });
    // Two triangles: the rings must not come from vertices.
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(4, 4), material);
    const lamp = new THREE.PointLight(0xffffff, 1e-3);
    const foot = { x: 0.4, y: -0.3 };
    lamp.position.set(foot.x, foot.y, 0.5);
    const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
    camera.position.z = 2;
    const ink = draw(paperScene(floor, lamp, new THREE.AmbientLight(0xffffff, 0.7 * Math.PI)), camera, rendererOf(300));
    // The variation of ink on each ring of pixels around the foot, relative to that of the whole floor.
    const rings = Array.from({ length: 90 }, () => [] as number[]);
    for (const [i, one] of ink.entries()) {
      const x = ((i % 300) + 0.5) / 150 - 1 - foot.x;
      const y = 1 - (Math.floor(i / 300) + 0.5) / 150 - foot.y;
      const ring = Math.floor(Math.hypot(x, y) * 150);
      if (ring >= 20 && ring < 90) rings[ring].push(one);
    }
    const varianceOf = (values: number[]) => {
      const mean = values.reduce((sum, one) => sum + one, 0) / values.length;
      return values.reduce((sum, one) => sum + (one - mean) ** 2, 0) / values.length;
    };
    const used = rings.slice(20);
    return used.reduce((sum, ring) => sum + varianceOf(ring), 0) / used.length / varianceOf(used.flat());
  });
  expect(spread).toBeLessThan(0.25);
});

test('lines run on from mesh to mesh of a scene, whatever the parts are scaled, turned and shifted by', async ({
  page,
}) => {
  const { differing, apart } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom } = window.lining;
    const { applyHatching } = window.toolkit;
    const light = new THREE.DirectionalLight(0xffffff, 2);
    light.position.set(1, 2, 2);
    const draws = async (scene: InstanceType<typeof THREE.Object3D>, clones = false) => {
      const hatched = await applyHatching(scene, {
        material: { technique: 'engraving', screenSpaceShare: 0.5, lineSpacing: 20 },
        tilesPerWorldUnit: 3,
      });
      const drawn = clones ? scene.clone() : scene;
      const picture = draw(paperScene(light, drawn), lookFrom(0.3, 0.4, 3), rendererOf(300));
      hatched.dispose();
      return { picture, isLeft: scene.children.some(({ userData }) => 'hatchingField' in userData) };
    };
    const paper = new THREE.MeshLambertMaterial();
    const whole = new THREE.Group().add(new THREE.Mesh(new THREE.PlaneGeometry(1.6, 0.8), paper));
    const parts = new THREE.Group();
    for (const [side, scale, turn] of [
      [-1, 2, 0],
      [1, 0.25, Math.PI / 2],
    ]) {
      const part = new THREE.Mesh(new THREE.PlaneGeometry(0.8 / scale, 0.8 / scale).rotateZ(-turn), paper);
      part.position.x = 0.4 * side;
      part.rotation.z = turn;
      part.scale.setScalar(scale);
      parts.add(part);
    }
    const one = await draws(whole);
    const two = await draws(parts);
    const cloned = await draws(parts, true);
    const differ = (a: Float32Array, b: Float32Array) => a.filter((ink, i) => Math.abs(ink - b[i]) > 0.1).length;
    return {
      differing: [differ(one.picture, two.picture), differ(two.picture, cloned.picture)],
      apart: two.isLeft,
    };
  });
  for (const pixels of differing) expect(pixels).toBeLessThan(60);
  // The restored scene draws the same picture.
  expect(apart).toBe(false);
});

test('a face that lies in a cutting plane has lines all the same: other families take its tone', async ({ page }) => {
  const means = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial } = window.toolkit;
    const material = new HatchingMaterial({ technique: 'engraving', irregularity: 0, direction: 'z' });
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(4, 4), material);
    const camera = new THREE.OrthographicCamera(-0.6, 0.6, 0.6, -0.6, 0.1, 10);
    camera.position.z = 2;
    const light = new THREE.AmbientLight(0xffffff, 0.6 * Math.PI);
    return [0, 0.12, 0.3].map((turn) => {
      mesh.rotation.x = turn;
      mesh.updateMatrixWorld();
      return [0, 1].map((screenSpaceShare) => {
        material.screenSpaceShare = screenSpaceShare;
        const ink = draw(paperScene(mesh, light), camera, rendererOf(300));
        const mean = ink.reduce((sum, one) => sum + one, 0) / ink.length;
        return { mean, deviation: Math.sqrt(ink.reduce((sum, one) => sum + (one - mean) ** 2, 0) / ink.length) };
      });
    });
  });
  for (const { mean, deviation } of means.flat()) {
    expect(Math.abs(mean - 0.4)).toBeLessThan(0.02);
    // Lines, not a grey.
    expect(deviation).toBeGreaterThan(0.25);
  }
});
