import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { at, difference, SIZE } from './pixels.js';
import { techniques } from './techniques.js';
import { test } from './toolkitPage.js';

/** Ambient occlusion as the material draws it; what it is has its own unit tests. */

for (const technique of techniques) {
  test(
    `a round pit under light from all around is as bright as the sky it sees: ${technique}`,
    quickIf(technique === 'adjacency'),
    async ({ page }) => {
      const [open, half, baked, restored] = await page.evaluate(async (technique) => {
        const { THREE, bakeOcclusion, hatchedMesh, makeRenderer, pixelsOf, sceneOf } = window.toolkit;
        const renderer = makeRenderer();
        const bowl = new THREE.SphereGeometry(1, 48, 24, 0, 2 * Math.PI, Math.PI / 2, Math.PI / 2).rotateX(Math.PI / 2);
        const mesh = await hatchedMesh(bowl, { technique, debugView: 'tone', side: THREE.BackSide });
        const scene = sceneOf(mesh, new THREE.AmbientLight(0xffffff, Math.PI));
        const open = pixelsOf(scene, renderer);
        const programs = renderer.info.programs!.length;
        const bake = await bakeOcclusion(scene);
        const baked = pixelsOf(scene, renderer);
        mesh.material.occlusion = 0.5;
        const half = pixelsOf(scene, renderer);
        mesh.material.occlusion = 1;
        bake.dispose();
        const restored = pixelsOf(scene, renderer);
        if (renderer.info.programs!.length !== programs) throw new Error('Another program was built.');
        return [open, half, baked, restored];
      }, technique);
      expect(difference(open, restored)).toBe(0);
      let seen = 0;
      const off = { open: 0, baked: 0, half: 0 };
      for (let y = 0; y < SIZE; y++) {
        for (let x = 0; x < SIZE; x++) {
          // Away from the rim, where it jumps.
          if (Math.hypot(x - SIZE / 2, y - SIZE / 2) > 0.3 * SIZE) continue;
          seen++;
          const note = (name: keyof typeof off, pixels: number[], share: number): void => {
            off[name] = Math.max(off[name], Math.abs(at(pixels, x, y)[0] / 255 - share));
          };
          note('open', open, 1);
          // A hemisphere: every place in it sees the opening alike.
          note('baked', baked, 0.5);
          note('half', half, 0.75);
        }
      }
      expect(seen).toBeGreaterThan(2000);
      expect(off.open).toBe(0);
      expect(off.baked).toBeLessThan(0.06);
      expect(off.half).toBeLessThan(0.035);
    },
  );

  test(
    `under a sun, meshes darken each other where they meet and nowhere else: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const [before, after] = await page.evaluate(async (technique) => {
        const { THREE, bakeOcclusion, hatchedMesh, makeRenderer, pixelsOf, sceneOf, sun } = window.toolkit;
        const renderer = makeRenderer();
        const wall = await hatchedMesh(new THREE.PlaneGeometry(4, 2, 64, 32), { technique, debugView: 'tone' });
        const shelf = await hatchedMesh(new THREE.BoxGeometry(4, 0.2, 0.6, 32, 2, 8).translate(0, 0, 0.3), {
          technique,
        });
        // Seen and lit from the front; the shelf is thin.
        const scene = sceneOf(wall, shelf, sun(Math.PI, [0, 0, 1]));
        const before = pixelsOf(scene, renderer);
        await bakeOcclusion(scene);
        return [before, pixelsOf(scene, renderer)];
      }, technique);
      const change = (y: number) => at(before, SIZE / 2, y)[0] - at(after, SIZE / 2, y)[0];
      // The wall ends at ±33 pixels from the middle, and the shelf covers five.
      expect(change(SIZE / 2 + 8)).toBeGreaterThan(30);
      expect(change(SIZE / 2 - 9)).toBeGreaterThan(30);
      expect(change(SIZE / 2 + 30)).toBeLessThan(12);
      expect(change(SIZE / 2 - 31)).toBeLessThan(12);
      expect(change(SIZE / 2 + 8)).toBeGreaterThan(change(SIZE / 2 + 16));
    },
  );
}

for (const technique of techniques) {
  test(
    `a bowl is as bright as the sky that the side sees which is seen: ${technique}`,
    quickIf(technique === 'engraving'),
    async ({ page }) => {
      const seen = await page.evaluate(async (technique) => {
        const { THREE, bakeOcclusion, hatchedMesh, makeRenderer, pixelsOf, sceneOf } = window.toolkit;
        const renderer = makeRenderer();
        const light = new THREE.AmbientLight(0xffffff, Math.PI);
        const bowl = new THREE.SphereGeometry(1, 48, 24, 0, 2 * Math.PI, Math.PI / 2, Math.PI / 2).rotateX(Math.PI / 2);
        const { FrontSide, BackSide, DoubleSide } = THREE;
        const cases: [string, import('three').Side, mirrored: boolean, turned: boolean, transparent?: boolean][] = [
          ['inside of both sides', DoubleSide, false, false],
          ['outside of both sides', DoubleSide, false, true],
          ['mirrored inside of both sides', DoubleSide, true, false],
          ['mirrored outside of both sides', DoubleSide, true, true],
          ['see-through inside of both sides', DoubleSide, false, false, true],
          ['see-through outside of both sides', DoubleSide, false, true, true],
          ['inside of the back', BackSide, false, false],
          ['mirrored inside of the back', BackSide, true, false],
          ['outside of the front', FrontSide, false, true],
          ['mirrored outside of the front', FrontSide, true, true],
        ];
        const found: [string, pixels: number[]][] = [];
        for (const [name, side, isMirrored, isTurned, transparent = false] of cases) {
          const mesh = await hatchedMesh(bowl.clone(), { technique, debugView: 'tone', side });
          if (isMirrored) mesh.scale.x = -1;
          if (isTurned) mesh.rotation.y = Math.PI;
          const scene = sceneOf(mesh, light);
          await bakeOcclusion(scene);
          // A see-through mesh would occlude nothing. three.js draws its back and its front apart.
          mesh.material.transparent = transparent;
          found.push([name, pixelsOf(scene, renderer)]);
        }
        return found;
      }, technique);
      for (const [name, pixels] of seen) {
        const isInside = name.includes('inside');
        for (let x = -15; x <= 15; x += 5)
          expect(Math.abs(at(pixels, SIZE / 2 + x, SIZE / 2)[0] / 255 - (isInside ? 0.5 : 1)), name).toBeLessThan(0.06);
      }
    },
  );

  test(
    `a mesh keeps the occlusion of its rest pose; instances have none, nor what was never prepared: ${technique}`,
    quickIf(technique === 'hatching'),
    async ({ page }) => {
      const [rest, moved, instanced, plain, unprepared] = await page.evaluate(async (technique) => {
        const { THREE, bakeOcclusion, hatchedMesh, HatchingMaterial, makeRenderer, pixelsOf, sceneOf } = window.toolkit;
        const renderer = makeRenderer();
        const light = new THREE.AmbientLight(0xffffff, 0.8 * Math.PI);
        const geometry = new THREE.PlaneGeometry(1, 1, 8, 8);
        const { count } = geometry.attributes.position;
        const aside = new Float32Array(3 * count);
        for (let i = 0; i < count; i++) aside[3 * i] = 1;
        geometry.morphAttributes.position = [new THREE.BufferAttribute(aside, 3)];
        geometry.morphTargetsRelative = true;
        const mesh = await hatchedMesh(geometry, { technique, debugView: 'tone' });
        mesh.position.x = -0.5;
        const roof = new THREE.Mesh(new THREE.PlaneGeometry(2, 4).translate(-1, 0, 0.1), new THREE.MeshBasicMaterial());
        await bakeOcclusion(sceneOf(mesh, roof));
        const scene = sceneOf(mesh, light);
        const rest = pixelsOf(scene, renderer);
        mesh.morphTargetInfluences![0] = 1;
        const moved = pixelsOf(scene, renderer);

        const flat = await hatchedMesh(new THREE.PlaneGeometry(1, 1, 8, 8), { technique, debugView: 'tone' });
        const plain = pixelsOf(sceneOf(flat, light), renderer);
        await bakeOcclusion(
          sceneOf(flat, new THREE.Mesh(new THREE.PlaneGeometry(9, 9).translate(0, 0, 0.1), roof.material)),
        );
        const instances = new THREE.InstancedMesh(flat.geometry, flat.material, 1);
        const instanced = pixelsOf(sceneOf(instances, light), renderer);
        // The two techniques that draw geometry without adjacency.
        const material = new HatchingMaterial({ technique, debugView: 'tone' });
        const bare = new THREE.Mesh(new THREE.PlaneGeometry(1, 1, 8, 8), material);
        const unprepared =
          technique === 'hatching' || technique === 'engraving' ? pixelsOf(sceneOf(bare, light), renderer) : plain;
        return [rest, moved, instanced, plain, unprepared];
      }, technique);
      const y = SIZE / 2;
      // 33 pixels to a unit.
      const pixel = (pixels: number[], x: number) => at(pixels, Math.round(SIZE / 2 + 33 * x), y)[0];
      expect(pixel(rest, -0.7)).toBeLessThan(60);
      expect(pixel(moved, 0.3)).toBeLessThan(60);
      expect(Math.abs(pixel(moved, 0.3) - pixel(rest, -0.7))).toBeLessThan(2);
      expect(pixel(plain, 0)).toBe(204);
      expect(difference(instanced, plain)).toBe(0);
      expect(difference(unprepared, plain)).toBe(0);
    },
  );
}
