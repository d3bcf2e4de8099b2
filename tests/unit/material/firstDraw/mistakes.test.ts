import {
  ACESFilmicToneMapping,
  AmbientLight,
  BoxGeometry,
  BufferGeometry,
  DirectionalLight,
  type Group as DrawnGroup,
  Group,
  HemisphereLight,
  type Light,
  Mesh,
  NoToneMapping,
  PerspectiveCamera,
  PointLight,
  RectAreaLight,
  Scene,
  SphereGeometry,
  SpotLight,
  Texture,
  type Vector4,
  type WebGLRenderer,
} from 'three';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { HatchingMaterialParameters } from '../../../../src/material/checkValues.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import '../../../../src/development.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { TonalArtMap } from '../../../../src/material/tam/TonalArtMap.js';

const blank = () => new Uint8Array(16).fill(255);
const map = TonalArtMap.fromHatchImages({ size: 4, images: [[blank()], [new Uint8Array(16)]] });

let said: string[];
beforeEach(() => {
  said = [];
  for (const level of ['warn', 'error'] as const) {
    vi.spyOn(console, level).mockImplementation((sentence) => void said.push(sentence));
  }
});
afterEach(() => {
  HatchingMaterial.silent = false;
  vi.restoreAllMocks();
});

interface Drawing {
  scene?: Scene;
  lights?: Light[];
  renderer?: Partial<WebGLRenderer>;
  target?: object | null;
  camera?: PerspectiveCamera;
}

const sun = (intensity = Math.PI) => new DirectionalLight(0xffffff, intensity);

/** Draws a mesh as the renderer does, and waits until it was checked. */
async function draw(mesh: Mesh, { lights = [sun()], ...how }: Drawing = {}): Promise<string[]> {
  const {
    scene = (mesh.parent as Scene | null) ?? new Scene(),
    renderer = {},
    target = null,
    camera = new PerspectiveCamera(40, 1, 0.1, 1e4),
  } = how;
  if (mesh.parent === null) scene.add(mesh);
  for (const light of lights) scene.add(light);
  camera.position.z ||= 4;
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  mesh.geometry.computeBoundingSphere();
  const material = mesh.material as HatchingMaterial;
  const fake = {
    info: { render: { frame: 1 } },
    capabilities: { maxTextureSize: 4096 },
    extensions: { has: () => true },
    toneMapping: NoToneMapping,
    getRenderTarget: () => target,
    getPixelRatio: () => 1,
    getCurrentViewport: (viewport: Vector4) => viewport.set(0, 0, 500, 500),
    ...renderer,
  } as unknown as WebGLRenderer;
  material.onBeforeRender(fake, scene, camera, mesh.geometry, mesh, undefined as unknown as DrawnGroup);
  await vi.dynamicImportSettled();
  return said.splice(0);
}

const anchored = (parameters: HatchingMaterialParameters = {}) =>
  new HatchingMaterial({ technique: 'hatching', screenSpaceShare: 1, tonalArtMap: map, ...parameters });

const ball = (material = anchored()): Mesh => {
  const mesh = new Mesh(new SphereGeometry(), material);
  mesh.name = 'ball';
  return mesh;
};

const about = (mistake: string | RegExp) => [expect.stringMatching(mistake)];

describe('an ordinary mesh', () => {
  test('is drawn without a word', async () => {
    expect(await draw(ball())).toEqual([]);
    expect(await draw(ball(anchored({ screenSpaceShare: 0 })))).toEqual([]);
    expect(await draw(ball(new HatchingMaterial({ technique: 'engraving' })))).toEqual([]);
  });

  test('is looked at once, and again with another technique or geometry', async () => {
    const mesh = ball();
    const material = mesh.material as HatchingMaterial;
    const scene = new Scene();
    await draw(mesh, { scene });
    material.tonalArtMap = null;
    expect(await draw(mesh, { scene })).toEqual([]);
    mesh.geometry = new BoxGeometry();
    expect(await draw(mesh, { scene })).toEqual(about('tonalArtMap'));
    material.technique = 'adjacency';
    expect(await draw(mesh, { scene })).toEqual(about('adjacency'));
    expect(await draw(mesh, { scene })).toEqual([]);
  });
});

describe('a sentence', () => {
  test('names the mesh, its type and where it is', async () => {
    const group = new Group();
    group.name = 'car';
    const scene = new Scene();
    const mesh = new Mesh(new BoxGeometry(), anchored({ tonalArtMap: null }));
    scene.add(new Group().add(new Group(), group.add(mesh)));
    expect(await draw(mesh, { scene })).toEqual(
      about(/^HatchingMaterial: the Mesh at Scene\/Group\[0\]\/car\/Mesh\[0\] /),
    );
  });

  test('stands for all meshes that are drawn together', async () => {
    const scene = new Scene();
    const material = anchored();
    const meshes = [1, 2, 3].map((i) =>
      Object.assign(new Mesh(new BoxGeometry().deleteAttribute('normal'), material), { name: `box ${i}` }),
    );
    scene.add(...meshes);
    expect((await Promise.all(meshes.map((mesh) => draw(mesh, { scene })))).flat()).toEqual(
      about(/the Mesh "box 1" at Scene\/box 1 and 2 more/),
    );
  });

  test('is not said of a mesh that is no longer there when it is checked', async () => {
    const scene = new Scene();
    const mesh = ball(anchored({ tonalArtMap: null }));
    const saying = draw(mesh, { scene });
    scene.clear();
    expect(await saying).toEqual([]);
  });

  test('is not said while the library is silent, and not made up for later', async () => {
    HatchingMaterial.silent = true;
    const mesh = ball(anchored({ tonalArtMap: null }));
    expect(await draw(mesh, { lights: [] })).toEqual([]);
    expect(said).toEqual([]);
  });
});

describe('the surface', () => {
  test('has no map', async () => {
    expect(await draw(ball(anchored({ tonalArtMap: null })))).toEqual(about(/"ball".* without strokes.* tonalArtMap/));
    expect(await draw(ball(new HatchingMaterial({ technique: 'engraving', tonalArtMap: null })))).toEqual([]);
  });

  test('is blank paper on purpose', async () => {
    const toneCurve = [
      [0, 0],
      [1, 0],
    ] as const;
    expect(await draw(ball(anchored({ tonalArtMap: null, toneCurve })), { lights: [] })).toEqual([]);
  });

  test('has no normals', async () => {
    const mesh = ball();
    mesh.geometry.deleteAttribute('normal');
    expect(await draw(mesh)).toEqual(about(/"ball".* no normals.*computeVertexNormals/));
    expect(await draw(ball().copy(mesh))).toEqual([]);
  });

  test('has no adjacency', async () => {
    const material = () => new HatchingMaterial({ technique: 'adjacency', tonalArtMap: map });
    expect(await draw(ball(material()))).toEqual(about(/"ball".* no triangle adjacency.* technique 'hatching'/));
    const mesh = ball(material());
    mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { layout: 'corner' });
    expect(await draw(mesh)).toEqual([]);
    mesh.geometry = await prepareHatchingGeometry(new SphereGeometry(), { layout: 'indexed' });
    expect(await draw(mesh)).toEqual(about(/without triangle adjacency.* technique 'hatching'/));
    mesh.geometry.userData = {};
    expect(await draw(ball().copy(mesh))).toEqual(about(/has lost its triangle adjacency.* technique 'hatching'/));
  });

  test('has no form to follow', async () => {
    const mesh = ball(new HatchingMaterial({ technique: 'engraving', direction: 'form' }));
    const found = about(/"ball".* is drawn with the direction 'light', because it was prepared without form/);
    expect(await draw(mesh)).toEqual(found);
    mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { form: true });
    expect(await draw(mesh)).toEqual([]);
    const strokes = ball(new HatchingMaterial({ direction: 'acrossForm' }));
    const alike = about(/"ball".* is drawn with the direction 'light', because it was prepared without form/);
    expect(await draw(strokes)).toEqual(alike);
    strokes.geometry = mesh.geometry;
    expect(await draw(strokes)).toEqual([]);
  });

  test('was moved after it was prepared', async () => {
    for (const layout of ['indexed', 'corner'] as const) {
      const mesh = ball();
      mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { layout });
      expect(await draw(mesh)).toEqual([]);
      mesh.geometry.scale(1, 2, 1);
      expect(await draw(mesh)).toEqual(
        about(
          /positions of the Mesh "ball".* have changed since it was prepared; .*outlines have not\..*bones or morph targets/,
        ),
      );
      expect(await draw(mesh)).toEqual([]);
    }
  });

  test('is tone mapped, on the screen', async () => {
    const renderer = { toneMapping: ACESFilmicToneMapping } as const;
    const mapped = () => ball(anchored({ toneMapped: true }));
    expect(await draw(mapped(), { renderer, target: {} })).toEqual([]);
    expect(await draw(ball(anchored({ toneMapped: false })), { renderer })).toEqual([]);
    expect(await draw(mapped(), { renderer })).toEqual(about(/"ball".* tone mapping.* toneMapped: false/));
  });

  test('is tone mapped after it was drawn without', async () => {
    const renderer = { toneMapping: ACESFilmicToneMapping } as const;
    const material = anchored({ toneMapped: false });
    const mesh = ball(material);
    expect(await draw(mesh, { renderer })).toEqual([]);
    material.toneMapped = true;
    expect(await draw(mesh, { renderer })).toEqual(about(/"ball".* tone mapping.* toneMapped: false/));
  });
});

describe('the light', () => {
  const lamp = (intensity: number, z: number) => {
    const light = new PointLight(0xffffff, intensity);
    light.position.z = z;
    return light;
  };

  test.each<[string, Light[], RegExp]>([
    ['is missing', [], /"ball".* gets no light.* Add a DirectionalLight/],
    ['is black', [new DirectionalLight(0, 4)], /gets no light/],
    ['is ambient alone', [new AmbientLight(0xffffff, 3)], /same tone on all sides.* Add a DirectionalLight/],
    ['has an intensity of 1', [sun(1)], /too little light.* up to 1\. Raise/],
    ['is a lamp far away', [lamp(20, 30)], /too little light.* Raise/],
    ['is made for an exposure', [sun(100)], /too much light.* up to 100\. Lower/],
    ['is a lamp too near', [lamp(1000, 3)], /too much light.* Lower/],
  ])('%s', async (_, lights, sentence) => {
    expect(await draw(ball(), { lights })).toEqual(about(sentence));
  });

  test.each<[string, Light[]]>([
    ['from two sides', [sun(1), sun(2)]],
    ['of a scene for PBR', [sun(3), sun(2), new AmbientLight(0xffffff, 1)]],
    ['of a sky', [new HemisphereLight(0xffffff, 0x444444, 2)]],
    ['of a lamp', [lamp(Math.PI * 16, 4)]],
    ['of a spot', [Object.assign(new SpotLight(0xffffff, Math.PI), { decay: 0 })]],
    ['of an area, which no intensity tells', [new RectAreaLight(0xffffff, 1)]],
  ])('%s is right', async (_, lights) => {
    expect(await draw(ball(), { lights })).toEqual([]);
  });

  test.each<[string, Light[], RegExp | undefined]>([
    ['too weak', [sun(0.01)], undefined],
    ['too strong', [sun(100), sun(1000)], undefined],
    ['missing', [], /gets no light/],
    ['ambient alone', [new AmbientLight(0xffffff, 0.1)], /same tone on all sides/],
  ])('that is %s is told of, to an exposure of auto, if it shows no form', async (_, lights, sentence) => {
    const mesh = ball(anchored({ composition: { exposure: 'auto' } }));
    expect(await draw(mesh, { lights })).toEqual(sentence ? about(sentence) : []);
  });

  test('is told of where a tone curve by hand takes the place of the exposure', async () => {
    const curve = [
      [0, 0],
      [1, 0.9],
    ] as const;
    const mesh = ball(anchored({ composition: { exposure: 'auto' }, toneCurve: curve }));
    expect(await draw(mesh, { lights: [sun(0.01)] })).toEqual(about(/too little light/));
  });

  test('may come from an environment or a texture', async () => {
    const scene = new Scene();
    scene.environment = new Texture();
    expect(await draw(ball(), { scene, lights: [] })).toEqual([]);
    expect(await draw(ball(anchored({ lightMap: new Texture() })), { lights: [] })).toEqual([]);
    expect(await draw(ball(anchored({ emissive: 'white' })), { lights: [] })).toEqual([]);
  });

  test('is looked at once for a scene', async () => {
    const scene = new Scene();
    expect(await draw(ball(), { scene, lights: [] })).toHaveLength(1);
    expect(await draw(ball(), { scene, lights: [] })).toEqual([]);
  });

  test('that the camera does not see does not count', async () => {
    const hidden = sun();
    hidden.visible = false;
    const elsewhere = sun();
    elsewhere.layers.set(3);
    expect(await draw(ball(), { lights: [hidden, elsewhere] })).toEqual(about('gets no light'));
  });
});

describe('strokes', () => {
  test.each<[string, HatchingMaterialParameters, number, RegExp]>([
    [
      'finer than a pixel on the object',
      { screenSpaceShare: 0, tilesPerObjectUnit: 5e3 },
      1,
      /smaller than a pixel.* tilesPerObjectUnit is 5000\. Set it to about 3\./,
    ],
    [
      'larger than the object',
      { screenSpaceShare: 0, tilesPerObjectUnit: 3 },
      0.01,
      /larger than itself.* tilesPerObjectUnit is 3\. Set it to about 300\./,
    ],
    [
      'of lines larger than the object',
      { technique: 'engraving', screenSpaceShare: 0, tilesPerObjectUnit: 3, lineSpacing: 5 },
      0.001,
      /larger than itself.* tilesPerObjectUnit/,
    ],
    [
      'finer than a pixel on the screen',
      { strokeWidth: 0.1 },
      1,
      /smaller than a pixel.* strokeWidth is 0\.1\. Set it to about 1\.5\./,
    ],
    ['larger than the picture of the object', { strokeWidth: 800 }, 1, /larger than itself.* strokeWidth is 800/],
    [
      'of lines larger than that',
      { technique: 'engraving', lineSpacing: 800 },
      1,
      /larger than itself.* lineSpacing is 800/,
    ],
  ])('are %s', async (_, parameters, radius, sentence) => {
    const mesh = ball(anchored(parameters));
    mesh.geometry = new SphereGeometry(radius);
    const camera = new PerspectiveCamera(40, 1, radius / 10, 100 * radius);
    camera.position.z = 4 * radius;
    expect(await draw(mesh, { camera })).toEqual(about(sentence));
  });

  test('of a model far away are to be larger than those of one that fills the picture', async () => {
    const camera = new PerspectiveCamera(40, 1, 0.1, 1e5);
    camera.position.z = 300;
    const [sentence] = await draw(ball(anchored({ screenSpaceShare: 0, tilesPerObjectUnit: 3 })), { camera });
    const advised = Number(/tilesPerObjectUnit is 3\. Set it to about ([\d.]+)\./.exec(sentence)?.[1]);
    expect(advised).toBeGreaterThan(0);
    expect(advised).toBeLessThan(1);
    expect(await draw(ball(anchored({ screenSpaceShare: 0, tilesPerObjectUnit: advised })), { camera })).toEqual([]);
  });

  test('of a small part are for the whole model', async () => {
    const scene = new Scene().add(ball(anchored({ screenSpaceShare: 0 })));
    scene.traverse((object) => (object as Mesh).geometry?.computeBoundingSphere());
    const eye = ball(anchored({ screenSpaceShare: 0 }));
    eye.geometry = new SphereGeometry(0.01);
    expect(await draw(eye, { scene })).toEqual([]);
  });

  test('of many meshes are measured by one model, for which the scene is walked through once', async () => {
    const scene = new Scene();
    const balls = Array.from({ length: 20 }, () => ball(anchored({ screenSpaceShare: 0 })));
    scene.add(...balls);
    const walk = vi.spyOn(scene, 'traverseVisible');
    await Promise.all(balls.map((mesh) => draw(mesh, { scene })));
    // Another draw, for its lights.
    expect(walk).toHaveBeenCalledTimes(2);
  });

  test('of a scaled mesh are measured as they are drawn', async () => {
    const mesh = ball(anchored({ screenSpaceShare: 0, tilesPerObjectUnit: 300 }));
    mesh.geometry = new SphereGeometry(0.01);
    mesh.scale.setScalar(100);
    expect(await draw(mesh)).toEqual([]);
  });
});

test('a mesh without an own sphere is drawn without a word', async () => {
  const mesh = ball();
  mesh.geometry.computeBoundingSphere = () => {};
  expect(await draw(mesh, { lights: [new PointLight(0xffffff, 20)] })).toEqual([]);
  expect(new BufferGeometry().boundingSphere).toBeNull();
});

// Each test is the first to use its technique, because code is fetched once.
describe('a mesh that is drawn before its code is there', () => {
  /** Draws a mesh, then waits for the code and for some time. */
  async function drawEarly(technique: 'dryMedia' | 'stipple') {
    vi.stubGlobal('requestAnimationFrame', (callback: () => void) => callback());
    const info = { render: { frame: 1 } };
    const renderer = { info, getContext: () => ({ isContextLost: () => false }) } as unknown as WebGLRenderer;
    const mesh = ball(anchored({ technique }));
    vi.useFakeTimers({ toFake: ['setTimeout'] });
    expect(await draw(mesh, { renderer })).toEqual([]);
    await (mesh.material as HatchingMaterial).ready;
    return info;
  }
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  test('and never again', async () => {
    await drawEarly('dryMedia');
    await vi.advanceTimersByTimeAsync(2900);
    expect(said).toEqual([]);
    await vi.advanceTimersByTimeAsync(200);
    expect(said).toEqual(about(/the Mesh "ball" at .* never since\. .* material\.ready\.then/));
  });

  test('and again when it is', async () => {
    const info = await drawEarly('stipple');
    info.render.frame++;
    await vi.advanceTimersByTimeAsync(5000);
    expect(said).toEqual([]);
  });
});
