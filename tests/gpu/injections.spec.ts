import { readFileSync } from 'node:fs';
import { asShipped } from '../../tools/building/shortShaders.js';
import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/**
 * Code of users, injected by `onBeforeCompile` at each place that docs/material.md promises, into the shaders as they are shipped. Each
 * injection colours the middle of a sphere that is white, lit from the side.
 */

type Stage = 'vertexShader' | 'fragmentShader';

interface Injection {
  place: string;
  /** The replacement of each text, by stage. */
  edits: readonly (readonly [stage: Stage, place: string, text: string])[];
  /** The colour in the middle, from 0 to 255; the ground is green. */
  middle: readonly [number, number, number];
  techniques?: readonly string[];
}

const TECHNIQUES = ['triangle', 'adjacency', 'hatching', 'engraving'];
const PER_FRAGMENT = ['hatching', 'engraving'];
const RED = [255, 0, 0] as const;
const GREEN = [0, 255, 0] as const;
const BLACK = [0, 0, 0] as const;
const WHITE = [255, 255, 255] as const;

const after = (stage: Stage, place: string, code: string) => [stage, place, `${place}\n${code}`] as const;
const before = (stage: Stage, place: string, code: string) => [stage, place, `${code}\n${place}`] as const;
const OUT = '#include <opaque_fragment>';

const INJECTIONS: readonly Injection[] = [
  {
    place: '#include <common>',
    edits: [
      after('vertexShader', '#include <common>', 'varying float vMine;\nfloat mine() { return 1.0; }'),
      after('vertexShader', '#include <begin_vertex>', 'vMine = mine();'),
      before('fragmentShader', '#include <common>', 'uniform vec3 tint;\nvarying float vMine;'),
      before('fragmentShader', OUT, 'outgoingLight = vMine * tint * paper * (1.0 - ink);'),
    ],
    middle: RED,
  },
  {
    place: 'void main() {',
    edits: [
      before('vertexShader', '#include <common>', 'varying float vMine;'),
      after('vertexShader', 'void main() {', 'vMine = 1.0;'),
      before('fragmentShader', '#include <common>', 'varying float vMine;'),
      after('fragmentShader', 'void main() {', 'float mine = vMine;'),
      before('fragmentShader', OUT, 'outgoingLight = vec3(mine, 0.0, 0.0);'),
    ],
    middle: RED,
  },
  {
    place: '#include <beginnormal_vertex>',
    // Of a normal that looks to the light.
    edits: [after('vertexShader', '#include <beginnormal_vertex>', 'objectNormal = vec3(1.0, 0.0, 0.0);')],
    middle: WHITE,
    techniques: PER_FRAGMENT,
  },
  {
    place: '#include <begin_vertex>',
    edits: [after('vertexShader', '#include <begin_vertex>', 'transformed.x += 10.0;')],
    middle: GREEN,
    techniques: PER_FRAGMENT,
  },
  {
    place: '#include <project_vertex>',
    edits: [after('vertexShader', '#include <project_vertex>', 'gl_Position.x += 3.0 * gl_Position.w;')],
    middle: GREEN,
  },
  {
    place: '#include <map_fragment>',
    edits: [
      after('fragmentShader', '#include <map_fragment>', 'diffuseColor.rgb = vec3(1.0, 0.0, 0.0);'),
      // Without strokes.
      after('fragmentShader', '#include <emissivemap_fragment>', 'totalEmissiveRadiance = vec3(9.0);'),
    ],
    middle: RED,
  },
  {
    place: '#include <emissivemap_fragment>',
    edits: [after('fragmentShader', '#include <emissivemap_fragment>', 'totalEmissiveRadiance = vec3(9.0);')],
    middle: WHITE,
  },
  {
    place: '#include <normal_fragment_begin>',
    edits: [after('fragmentShader', '#include <normal_fragment_begin>', 'normal = vec3(1.0, 0.0, 0.0);')],
    middle: WHITE,
    techniques: PER_FRAGMENT,
  },
  {
    place: '#include <opaque_fragment>',
    edits: [before('fragmentShader', OUT, 'outgoingLight = vec3(1.0, 0.0, 0.0);\ndiffuseColor.a = 1.0;')],
    middle: RED,
  },
  {
    place: '#include <fog_fragment>',
    edits: [after('fragmentShader', '#include <fog_fragment>', 'gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0);')],
    middle: RED,
  },
  {
    place: '#include <dithering_fragment>',
    edits: [after('fragmentShader', '#include <dithering_fragment>', 'gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0);')],
    middle: RED,
  },
];

test('docs/material.md promises the places that are tested', () => {
  const section = /## Your own shader code\n([\s\S]*?)\n## /.exec(readFileSync('docs/material.md', 'utf8'))![1];
  const promised = [...section.matchAll(/^\| `([^`]+)` \|/gm)].map(([, place]) => place);
  expect(INJECTIONS.map(({ place }) => place)).toEqual(promised);
});

for (const technique of TECHNIQUES) {
  test(`code of users at each promised place: ${technique}`, async ({ page }) => {
    const sources = await page.evaluate(async (technique) => {
      await window.toolkit.HatchingMaterial.preload();
      const { vertexShader, fragmentShader } = new window.toolkit.UsersMaterial({
        technique: technique as 'engraving',
      });
      return { vertexShader, fragmentShader };
    }, technique);
    const shipped = {
      vertexShader: asShipped(sources.vertexShader),
      fragmentShader: asShipped(sources.fragmentShader),
    };
    const injections = INJECTIONS.filter(({ techniques = TECHNIQUES }) => techniques.includes(technique));
    for (const { edits } of injections)
      for (const [stage, place] of edits) expect(shipped[stage].split(place), `${stage}: ${place}`).toHaveLength(2);
    const drawn = await page.evaluate(
      async ({ technique, shipped, injections }) => {
        const { THREE, UsersMaterial, hatchedMesh, makeRenderer, pixelsOf, sceneOf, sun } = window.toolkit;
        const mesh = await hatchedMesh(new THREE.SphereGeometry(1.2, 24, 16));
        const { tonalArtMap } = mesh.material;
        const renderer = makeRenderer();
        const scene = sceneOf(mesh, sun(Math.PI, [5, 0, -0.5]));
        return injections.map((edits) => {
          mesh.material = new UsersMaterial({
            technique: technique as 'engraving',
            tonalArtMap,
            ...{
              toneNormal: 'smooth',
              toneCurve: 'linear',
              reflectedLight: 0,
              composition: { exposure: 1 },
              irregularity: 0,
            },
            ...{ colorFill: 1, direction: 'y', strokeLayers: 'single', toneMapped: false },
          });
          Object.assign(mesh.material, shipped);
          // Hooks with the same source would share a program.
          mesh.material.customProgramCacheKey = () => JSON.stringify(edits);
          mesh.material.onBeforeCompile = (shader) => {
            shader.uniforms.tint = { value: new THREE.Color('red') };
            for (const [stage, place, text] of edits) shader[stage] = shader[stage].replace(place, text);
          };
          const pixels = pixelsOf(scene, renderer);
          const middle = 4 * (48 * 96 + 48);
          return pixels.slice(middle, middle + 3);
        });
      },
      { technique, shipped, injections: [[], ...injections.map(({ edits }) => edits)] },
    );
    // Without an injection the middle, which turns away from the light, is black. Lines are not quite absent in full light.
    const colours = drawn.map((colour) => colour.map((part) => 17 * Math.round(part / 17)));
    expect(colours).toEqual([BLACK, ...injections.map(({ middle }) => middle)]);
  });
}
