import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { SIZE } from './pixels.js';
import { test } from './toolkitPage.js';

/** Surfaces that are drawn from both sides: which way their faces point makes no difference. */

/** The largest share of pixels that may differ: rounding decides where lines and shadows end. */
const MOST = 0.004;

const SHAPES = ['a bowl', 'a box without a lid', 'a roof', 'a room with furniture'] as const;
const LIGHTS = ['a sun', 'a spot', 'a lamp'] as const;

const cases = SHAPES.flatMap((shape) =>
  LIGHTS.flatMap((light) => (['tone', 'pen', 'crossHatching'] as const).map((look) => [shape, light, look] as const)),
);
const outlined = SHAPES.map((shape) => [shape, 'a sun', 'outlines'] as const);

for (const [shape, light, look] of [...cases, ...outlined]) {
  test(
    `${shape} under ${light}, turned inside out: ${look}`,
    quickIf(light === 'a sun' && (look === 'pen' || look === 'outlines')),
    async ({ page }) => {
      const pictures = await page.evaluate(
        async ([shape, light, look]) => {
          const { THREE, applyHatching, bakeOcclusion, makeRenderer, mergeGeometries, pixelsOf } = window.toolkit;
          const renderer = makeRenderer();
          renderer.shadowMap.enabled = true;
          const box = (...size: [number, number, number]) => new THREE.BoxGeometry(...size, 6, 6, 6);
          /** A box without one of its sides, as three.js numbers them. */
          const openBox = (geometry: import('three').BoxGeometry, side: number) => {
            const { index, groups } = geometry;
            const { start, count } = groups[side];
            geometry.setIndex(Array.from(index!.array).filter((_, i) => i < start || i >= start + count));
            geometry.clearGroups();
            return geometry;
          };
          const made = {
            'a bowl': () =>
              new THREE.SphereGeometry(0.8, 48, 24, 0, 2 * Math.PI, 0.5 * Math.PI, 0.5 * Math.PI).rotateX(0.6),
            'a box without a lid': () =>
              openBox(box(1.2, 0.8, 1), 2)
                .rotateY(0.5)
                .rotateX(0.6),
            'a roof': () => {
              const sheet = new THREE.PlaneGeometry(1.4, 1.2, 12, 12).rotateX(-0.5 * Math.PI);
              const { position } = sheet.attributes;
              for (let i = 0; i < position.count; i++) position.setY(i, 0.5 - Math.abs(position.getX(i)));
              sheet.computeVertexNormals();
              return sheet.rotateX(0.5).rotateY(0.3);
            },
            'a room with furniture': () => {
              const parts = [openBox(box(1.6, 1.1, 1.2), 4), box(0.5, 0.3, 0.4).translate(-0.3, -0.4, 0)];
              for (const part of parts) part.clearGroups();
              return mergeGeometries(parts).rotateX(0.2).rotateY(-0.3);
            },
          }[shape];
          const reversed = (geometry: import('three').BufferGeometry) => {
            const { index, attributes } = geometry;
            for (let i = 0; i < index!.count; i += 3) {
              const [b, c] = [index!.getX(i + 1), index!.getX(i + 2)];
              index!.setX(i + 1, c);
              index!.setX(i + 2, b);
            }
            const { array } = attributes.normal;
            for (let i = 0; i < array.length; i++) array[i] *= -1;
            return geometry;
          };
          const lamp = () => {
            if (light === 'a sun') return new THREE.DirectionalLight(0xffffff, 2.5);
            return light === 'a spot'
              ? new THREE.SpotLight(0xffffff, 2.5, 0, 0.6, 0.2, 0)
              : new THREE.PointLight(0xffffff, 2.5, 0, 0);
          };
          const pictures: number[][] = [];
          for (const isReversed of [false, true]) {
            const geometry = isReversed ? reversed(made()) : made();
            const mesh: import('three').Mesh = new THREE.Mesh(
              geometry,
              new THREE.MeshStandardMaterial({ color: 0x999999, side: THREE.DoubleSide }),
            );
            mesh.castShadow = mesh.receiveShadow = true;
            const sun = lamp();
            sun.position.set(-1.5, 2, 2.5);
            sun.castShadow = true;
            sun.shadow.normalBias = 0.02;
            sun.shadow.mapSize.set(1024, 1024);
            if ('isDirectionalLight' in sun)
              Object.assign(sun.shadow.camera, { left: -1.5, right: 1.5, top: 1.5, bottom: -1.5, near: 0.1, far: 10 });
            const scene = new THREE.Scene().add(mesh, sun, new THREE.AmbientLight(0xffffff, 0.5));
            scene.background = new THREE.Color('white');
            const debugView = look === 'tone' ? look : 'none';
            await applyHatching(scene, {
              preset: look === 'crossHatching' ? look : 'pen',
              // Rounding decides which way lines along the form run on a sphere.
              material: { debugView, composition: { exposure: 1 }, ...(shape === 'a bowl' && { direction: 'light' }) },
              outlines: look === 'outlines' && { outlineWidth: 3, weights: { creases: 0.6, suggestiveContours: 0.6 } },
            });
            // Lines alone.
            if (look === 'outlines') mesh.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide });
            await bakeOcclusion(scene);
            pictures.push(pixelsOf(scene, renderer));
          }
          return pictures;
        },
        [shape, light, look] as const,
      );
      // Ink or tone on a blank ground.
      expect(pictures[0].filter((value, i) => i % 4 === 0 && value < 200).length / SIZE ** 2).toBeGreaterThan(0.02);
      const differing = pictures[0].filter((value, i) => i % 4 === 0 && Math.abs(value - pictures[1][i]) > 12).length;
      expect(differing / SIZE ** 2).toBeLessThan(MOST);
    },
  );
}
