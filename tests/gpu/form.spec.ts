import { expect, testOnOnePage as onOnePage } from '../browser/test.js';

/** Engraved lines that follow the form: how dark they are, and what they are fixed to. */

const test = onOnePage('tests/gpu/outlines.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.lining !== undefined);
});

test('the mean darkness is the tone, at every distance between octaves, with and without crossing and hand', async ({
  page,
}) => {
  const errors = await page.evaluate(async () => {
    const { THREE, draw, rendererOf, paperScene } = window.lining;
    const { HatchingMaterial, prepareHatchingGeometry } = window.toolkit;
    const geometry = await prepareHatchingGeometry(new THREE.TorusGeometry(1, 0.45, 48, 96), { form: true });
    const material = new HatchingMaterial({ technique: 'engraved', toneCurve: 'linear', reflectedLight: 0 });
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
      { lineField: 'form', handmade: 0, crossFrom: 1 },
      { lineField: 'acrossForm', handmade: 0, crossFrom: 1 },
      { lineField: 'form', handmade: 0.4, crossFrom: 0.3 },
    ] as const) {
      Object.assign(material, look);
      for (let quarter = 0; quarter < 4; quarter++) {
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
  expect(errors).toHaveLength(36);
  for (const error of errors) expect(error).toBeLessThan(0.005);
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
    // So wide apart that no lines lie between those of the bake.
    const look = { technique: 'engraved', lineField: 'form', handmade: 0, crossFrom: 1, lineSpacing: 99 } as const;
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
      // Where φ is whole there is a line; halfway between two there is none.
      for (const [values, found] of [
        [Math.ceil(Math.min(from, to)), onLines],
        [Math.ceil(Math.min(from, to) - 0.5) + 0.5, between],
      ] as const) {
        const share = (values - from) / (to - from);
        if (!(share > 0.1 && share < 0.9)) continue;
        found.push(inkNear(ink, size, pixelOf(face.a.clone().lerp(face.b, share), camera, size), 0.6));
      }
    }
    return { onLines, between };
  });
  expect(Math.min(onLines.length, between.length)).toBeGreaterThan(100);
  expect(Math.min(...onLines)).toBeGreaterThan(0.7);
  expect(Math.max(...between)).toBeLessThan(0.1);
});
