import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';
import { varyingRows } from './varyingRows.js';

/** WebGL 2 promises 15 rows of four varyings between the stages, and no more. */

const ROWS = 15;

for (const technique of ['triangle', 'adjacency', 'hatching', 'engraving'] as const) {
  // Engraved lines cross in a way of their own.
  for (const strokeLayers of technique === 'engraving'
    ? (['single'] as const)
    : (['single', 'lights', 'tone'] as const)) {
    test(
      `four shadows, clipping, fog, vertex colours and all maps, of two channels, fit: ${technique}, layers ${strokeLayers}`,
      quickIf(technique === 'engraving'),
      async ({ page }, testInfo) => {
        const programs = await page.evaluate(
          async ([technique, strokeLayers]) => {
            const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
            const renderer = makeRenderer();
            renderer.shadowMap.enabled = true;
            renderer.localClippingEnabled = true;
            const gl = renderer.getContext() as WebGL2RenderingContext;
            const geometry = new THREE.PlaneGeometry(2, 2);
            geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(12).fill(1), 3));
            geometry.setAttribute('uv1', geometry.getAttribute('uv'));
            const texture = (channel: number) => {
              const made = new THREE.DataTexture(new Uint8Array(4).fill(255), 1, 1);
              made.channel = channel;
              made.needsUpdate = true;
              return made;
            };
            const [first, second] = [texture(0), texture(1)];
            const sources: [string, string, string][] = [];
            for (const toneNormal of ['face', 'smooth'] as const) {
              const mesh = await hatchedMesh(geometry, {
                technique,
                strokeLayers,
                toneNormal,
                map: first,
                alphaMap: first,
                normalMap: first,
                bumpMap: first,
                emissiveMap: first,
                aoMap: second,
                lightMap: second,
                vertexColors: true,
                clippingPlanes: [new THREE.Plane(new THREE.Vector3(1, 0, 0), 2)],
                ...(technique === 'hatching' || technique === 'engraving'
                  ? {}
                  : { perTriangle: { levelRule: 'depth' } }),
              });
              mesh.receiveShadow = true;
              const spot = new THREE.SpotLight(0xffffff, 3);
              const lights = [sun(), sun(1, [0, 1, 1]), sun(1, [1, 0, 1]), spot];
              for (const light of lights) light.castShadow = true;
              const scene = sceneOf(mesh, ...lights);
              scene.fog = new THREE.Fog(0xffffff, 1, 90);
              pixelsOf(scene, renderer);
              const { currentProgram } = renderer.properties.get(mesh.material) as {
                currentProgram: { vertexShader: WebGLShader; fragmentShader: WebGLShader };
              };
              const [vertex, fragment] = [currentProgram.vertexShader, currentProgram.fragmentShader].map(
                (shader) => gl.getShaderSource(shader) ?? '',
              );
              sources.push([toneNormal, vertex, fragment]);
            }
            return sources;
          },
          [technique, strokeLayers] as const,
        );
        for (const [toneNormal, vertex, fragment] of programs) {
          const { rows, names } = varyingRows(vertex, fragment);
          testInfo.annotations.push({ type: toneNormal, description: `${rows} rows: ${names.join(', ')}` });
          expect(names.join(), 'what is asked for').toMatch(/vUv,.*vUv1,.*vDirectionalShadowCoord\[3\].*vClipPosition/);
          expect(rows, names.join()).toBeLessThanOrEqual(ROWS);
        }
      },
    );
  }
}

/** The number of varyings at which mid-range phones keep full speed. */
const ROWS_OF_PLAIN_LOOKS = 8;

test('looks as they are by default, under one light, need few rows', { tag: '@all' }, async ({ page }) => {
  const programs = await page.evaluate(async () => {
    const { THREE, hatchedMesh, sceneOf, sun, pixelsOf, makeRenderer } = window.toolkit;
    const renderer = makeRenderer();
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const looks = [
      { technique: 'triangle' },
      { technique: 'adjacency' },
      { technique: 'hatching' },
      { technique: 'dryMedia' },
      { technique: 'stipple' },
      { technique: 'engraving', direction: 'light' },
      { technique: 'engraving', direction: 'x' },
      { technique: 'pen', direction: 'light' },
      { technique: 'woodcut', direction: 'towardsLight' },
    ] as const;
    const sources: [string, string, string][] = [];
    for (const look of looks) {
      const mesh = await hatchedMesh(new THREE.SphereGeometry(1, 16, 12), look);
      pixelsOf(sceneOf(mesh, sun()), renderer);
      const { currentProgram } = renderer.properties.get(mesh.material) as {
        currentProgram: { vertexShader: WebGLShader; fragmentShader: WebGLShader };
      };
      const [vertex, fragment] = [currentProgram.vertexShader, currentProgram.fragmentShader].map(
        (shader) => gl.getShaderSource(shader) ?? '',
      );
      sources.push([JSON.stringify(look), vertex, fragment]);
    }
    return sources;
  });
  for (const [look, vertex, fragment] of programs) {
    const { rows, names } = varyingRows(vertex, fragment);
    expect(names.join(), look).toMatch(/vViewPosition/);
    expect(rows, `${look}: ${names.join()}`).toBeLessThanOrEqual(ROWS_OF_PLAIN_LOOKS);
  }
});
