import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Engraved lines that follow the form: how dark they are, and what they are fixed to. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('the mean darkness is the tone, at every distance between octaves and far away, with and without crossing and hand', {
  tag: '@all',
}, async ({ page }) => {
  const errors = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.TorusGeometry(1, 0.45, 48, 96), { form: true });
    const material = new HatchingMaterial({ technique: 'engraving', toneCurve: 'linear', reflectedLight: 0 });
    const light = new THREE.AmbientLight(0xffffff, 0);
    const scene = paperScene(new THREE.Mesh(geometry, material), light);
    const camera = new THREE.OrthographicCamera(-1.6, 1.6, 1.6, -1.6, 0.1, 10);
    camera.position.set(0, 1.5, 3);
    camera.lookAt(0, 0, 0);
    const inked = (tone: number): Float32Array => {
      light.intensity = Math.PI * (1 - tone);
      return draw(scene, camera, rendererOf(400));
    };
    const errors: number[] = [];
    for (const look of [
      { direction: 'form', irregularity: 0, crossFrom: 1 },
      { direction: 'acrossForm', irregularity: 0, crossFrom: 1 },
      { direction: 'form', irregularity: 0.4, crossFrom: 0.3 },
    ] as const) {
      Object.assign(material, look);
      for (const quarter of [0, 1, 2, 3, -5, -8]) {
        camera.zoom = 2 ** (quarter / 4);
        camera.updateProjectionMatrix();
        const inside = inked(1).map((ink) => Number(ink > 0.999));
        const count = inside.reduce((sum, one) => sum + one, 0);
        for (const tone of [0.2, 0.4, 0.8]) {
          const sum = inked(tone).reduce((total, ink, i) => total + ink * inside[i], 0);
          errors.push(Math.abs(sum / count - tone));
        }
      }
    }
    return errors;
  });
  expect(errors).toHaveLength(54);
  for (const error of errors) expect(error).toBeLessThan(0.005);
});

test('seams are invisible, in lines of any octave and in their variation by the hand', async ({ page }) => {
  const worst = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const source = new THREE.SphereGeometry(1, 48, 32);
    const whole = (await prepareHatchingGeometry(source, { form: true })).toNonIndexed();
    const seamed = whole.clone();
    const { position, formValue, formSlope, formCrossing } = seamed.attributes;
    for (let first = 0; first < position.count; first += 3) {
      if (position.getX(first) + position.getX(first + 1) + position.getX(first + 2) < 0.3) continue;
      // Beyond such a seam φ′ = 12 − φ and φ₂′ = −6 − φ₂.
      for (let vertex = first; vertex < first + 3; vertex++) {
        formValue.setXY(vertex, 12 - formValue.getX(vertex), -6 - formValue.getY(vertex));
        for (const slope of [formSlope, formCrossing]) {
          slope.setXYZ(vertex, -slope.getX(vertex), -slope.getY(vertex), -slope.getZ(vertex));
        }
      }
    }
    const look = { technique: 'engraving', irregularity: 0.7, crossFrom: 0.2, shadowStrokes: 'cross' } as const;
    const material = new HatchingMaterial({ ...look, direction: 'form', toneCurve: 'linear', reflectedLight: 0 });
    const light = new THREE.DirectionalLight(0xffffff, 0.8 * Math.PI);
    light.position.set(0.5, 1, 2);
    const worst: number[] = [];
    for (const direction of ['form', 'acrossForm'] as const) {
      material.direction = direction;
      for (const distance of [2.5, 6, 14, 30]) {
        const camera = lookFrom(0.3, 0.5, distance);
        const [a, b] = [whole, seamed].map((geometry) =>
          draw(paperScene(new THREE.Mesh(geometry, material), light), camera, rendererOf(400)),
        );
        if (!a.some((ink) => ink > 0.5)) throw new Error('nothing is drawn');
        worst.push(a.reduce((most, ink, i) => Math.max(most, Math.abs(ink - b[i])), 0));
      }
    }
    return worst;
  });
  expect(worst).toHaveLength(8);
  for (const difference of worst) expect(difference).toBeLessThan(0.03);
});

test('lines stay where they are on a skin that bends, and between them it stays blank', async ({ page }) => {
  const { onLines, between } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom, pixelOf, inkNear } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const source = new THREE.CylinderGeometry(0.4, 0.4, 2, 48, 40, true);
    const { position } = source.attributes;
    const upper = Array.from({ length: position.count }, (_, i) =>
      THREE.MathUtils.smoothstep(position.getY(i), -0.5, 0.5),
    );
    source.setAttribute(
      'skinIndex',
      new THREE.Uint16BufferAttribute(
        upper.flatMap(() => [0, 1, 0, 0]),
        4,
      ),
    );
    source.setAttribute(
      'skinWeight',
      new THREE.Float32BufferAttribute(
        upper.flatMap((w) => [1 - w, w, 0, 0]),
        4,
      ),
    );
    const geometry = await prepareHatchingGeometry(source, { form: true });
    // The greatest spacing of lines.
    const look = {
      technique: 'engraving',
      direction: 'form',
      irregularity: 0,
      crossFrom: 1,
      lineSpacing: 999,
    } as const;
    const material = new HatchingMaterial({ ...look, toneCurve: 'linear', reflectedLight: 0 });
    const mesh = new THREE.SkinnedMesh(geometry, material);
    const [lower, bent] = [new THREE.Bone(), new THREE.Bone()];
    mesh.add(lower.add(bent));
    mesh.bind(new THREE.Skeleton([lower, bent]));
    bent.rotation.z = -0.7;
    const size = 600;
    const camera = lookFrom(0, 0.3, 4);
    const scene = paperScene(mesh, new THREE.AmbientLight(0xffffff, 0.7 * Math.PI));
    const ink = draw(scene, camera, rendererOf(size));

    const onLines: number[] = [];
    const between: number[] = [];
    const { formValue } = geometry.attributes;
    const at = (vertex: number) => mesh.getVertexPosition(vertex, new THREE.Vector3());
    const index = geometry.index!;
    for (let triangle = 0; triangle < index.count; triangle += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => index.getX(triangle + k));
      const face = new THREE.Triangle(at(a), at(b), at(c));
      const toCamera = camera.position.clone().sub(face.a).normalize();
      if (face.getNormal(new THREE.Vector3()).dot(toCamera) < 0.6) continue;
      const [from, to] = [formValue.getX(a), formValue.getX(b)];
      // Lines lie where φ is a multiple of 4.
      for (const [rest, found] of [
        [0, onLines],
        [2, between],
      ] as const) {
        const value = 4 * Math.ceil((Math.min(from, to) - rest) / 4) + rest;
        const share = (value - from) / (to - from);
        if (!(share > 0.1 && share < 0.9)) continue;
        found.push(inkNear(ink, size, pixelOf(face.a.clone().lerp(face.b, share), camera, size), 0.6));
      }
    }
    return { onLines, between };
  });
  expect(Math.min(onLines.length, between.length)).toBeGreaterThan(50);
  expect(Math.min(...onLines)).toBeGreaterThan(0.7);
  expect(Math.max(...between)).toBeLessThan(0.1);
});

test('strokes run on where the sign of the baked function changes', async ({ page }) => {
  const [changed, inked] = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom, total } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } = window.toolkit;
    const tonalArtMap = await TonalArtMap.generate({ size: 256 });
    const source = new THREE.TorusGeometry(1, 0.45, 24, 48);
    const geometry = await prepareHatchingGeometry(source, { form: true, layout: 'corner' });
    const material = new HatchingMaterial({ tonalArtMap, technique: 'hatching', direction: 'form', edgePixels: 0 });
    const scene = paperScene(new THREE.Mesh(geometry, material), new THREE.AmbientLight(0xffffff, 0.6 * Math.PI));
    const [camera, renderer] = [lookFrom(0, 1.5, 3.5), rendererOf(400)];
    const before = draw(scene, camera, renderer);
    const { formSlope } = geometry.attributes;
    for (let corner = 0; corner < formSlope.count; corner++) {
      if (Math.floor(corner / 3) % 2 === 0) continue;
      const [x, y, z] = [0, 1, 2].map((axis) => -formSlope.getComponent(corner, axis));
      formSlope.setXYZ(corner, x, y, z);
    }
    formSlope.needsUpdate = true;
    const after = draw(scene, camera, renderer);
    const changed = after.filter((ink, i) => Math.abs(ink - before[i]) > 0.2).length;
    return [changed / after.length, total(before) / before.length];
  });
  expect(inked).toBeGreaterThan(0.05);
  expect(changed).toBeLessThan(0.001);
});

test('strokes in object space take the direction of the form as it is deformed', { tag: '@all' }, async ({ page }) => {
  const [changed, inked] = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom, total } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } = window.toolkit;
    const tonalArtMap = await TonalArtMap.generate({ size: 256 });
    const geometry = await prepareHatchingGeometry(new THREE.TorusGeometry(0.7, 0.3, 24, 48), { form: true });
    const { count } = geometry.attributes.position;
    const moves = new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(0.5, 0.4, 0.3));
    moves.scale(new THREE.Vector3(1.4, 0.8, 1)).setPosition(0.1, 0.2, 0);

    // The same shape, deformed before it is drawn.
    const moved = new THREE.BufferGeometry().setIndex(geometry.index);
    const turned = new THREE.Matrix3().getNormalMatrix(moves);
    for (const name of ['position', 'normal', 'hatchNormal', 'formSlope', 'formValue']) {
      const from = geometry.getAttribute(name);
      const values = Array.from({ length: count }, (_, vertex) => {
        const value = new THREE.Vector3().fromBufferAttribute(from, vertex);
        if (name === 'position') return value.applyMatrix4(moves).toArray();
        return name === 'formValue' ? value.toArray() : value.applyMatrix3(turned).toArray();
      });
      moved.setAttribute(name, new THREE.Float32BufferAttribute(values.flat(), 3));
    }

    geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Uint16Array(4 * count), 4));
    const weights = Array.from({ length: count }, () => [1, 0, 0, 0]);
    geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights.flat(), 4));
    const look = { technique: 'hatching', direction: 'form', strokeAnchor: 'deformed', edgePixels: 0 } as const;
    const material = new HatchingMaterial({ ...look, tonalArtMap });
    const skinned = new THREE.SkinnedMesh(geometry, material);
    const bone = new THREE.Bone();
    bone.matrixAutoUpdate = false;
    skinned.add(bone);
    skinned.bind(new THREE.Skeleton([bone]));
    bone.matrix.copy(moves);
    skinned.frustumCulled = false;

    const [camera, renderer] = [lookFrom(0, 1, 3.5), rendererOf(400)];
    const [first, second] = [skinned, new THREE.Mesh(moved, material)].map((mesh) =>
      draw(paperScene(mesh, new THREE.AmbientLight(0xffffff, 0.6 * Math.PI)), camera, renderer),
    );
    const changed = second.filter((ink, i) => Math.abs(ink - first[i]) > 0.2).length;
    return [changed / second.length, total(first) / first.length];
  });
  expect(inked).toBeGreaterThan(0.05);
  expect(changed).toBeLessThan(0.002);
});

test('a large mesh follows the light first, then changes over to the form without a program built in a frame or a change of tone', {
  tag: '@all',
}, async ({ page }) => {
  const { before, during, after } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom } = window.lining;
    const { applyHatching } = window.toolkit;
    const renderer = rendererOf(300);
    const camera = lookFrom(0, 1.5, 4);
    const mesh = new THREE.Mesh(new THREE.TorusGeometry(1, 0.45, 280, 360), new THREE.MeshLambertMaterial());
    const scene = paperScene(mesh, new THREE.AmbientLight(0xffffff, 0.5 * Math.PI));
    const programs = () => renderer.info.programs!.map(({ id }) => id);
    const drawn = () => {
      const ink = draw(scene, camera, renderer);
      const sum = ink.reduce((total, one) => total + one, 0);
      return { ink: sum / ink.length, programs: programs(), isFormed: mesh.geometry.hasAttribute('formValue') };
    };
    const during: ReturnType<typeof drawn>[] = [];
    const hatched = await applyHatching(mesh, {
      material: { technique: 'engraving', direction: 'form', irregularity: 0, toneCurve: 'linear', reflectedLight: 0 },
      renderer,
      camera,
      invalidate: () => during.push({ ...drawn(), programs: programs() }),
    });
    const before = drawn();
    await hatched.formReady;
    return { before, during, after: drawn() };
  });
  expect([before.isFormed, after.isFormed]).toEqual([false, true]);
  expect(new Set(during.map(({ isFormed }) => isFormed))).toEqual(new Set([false, true]));
  for (const { ink, programs } of during) {
    expect(Math.abs(ink - before.ink)).toBeLessThan(0.01);
    expect(programs).toEqual(during[0].programs);
  }
  expect(Math.abs(after.ink - before.ink)).toBeLessThan(0.01);
});

test('lines cross at a new angle of the material, and at the former one until they are baked at it', async ({
  page,
}) => {
  const { isSame, ...changes } = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene, lookFrom } = window.lining;
    const { applyHatching } = window.toolkit;
    const renderer = rendererOf(300);
    const camera = lookFrom(0, 1.5, 4);
    const hatchedRing = async (crossAngle: number) => {
      const mesh = new THREE.Mesh(new THREE.TorusGeometry(1, 0.45, 24, 48), new THREE.MeshLambertMaterial());
      const material = {
        technique: 'engraving',
        direction: 'form',
        irregularity: 0,
        crossFrom: 0,
        crossAngle,
      } as const;
      const hatched = await applyHatching(mesh, { material });
      return { hatched, scene: paperScene(mesh, new THREE.AmbientLight(0xffffff, 0.4 * Math.PI)) };
    };
    const { hatched, scene } = await hatchedRing(1);
    const picture = () => draw(scene, camera, renderer).slice();
    const first = picture();
    hatched.materials[0].crossAngle = 1.5;
    const meanwhile = picture();
    const changed = await hatched.formReady;
    const last = picture();
    const expected = draw((await hatchedRing(1.5)).scene, camera, renderer);
    const differs = (a: Float32Array, b: Float32Array) => a.some((ink, i) => Math.abs(ink - b[i]) > 1 / 255);
    return {
      meanwhile: differs(first, meanwhile),
      last: differs(first, last),
      isSame: !differs(last, expected),
      meshes: changed.length,
    };
  });
  expect(changes).toEqual({ meanwhile: false, last: true, meshes: 1 });
  expect(isSame).toBe(true);
});
