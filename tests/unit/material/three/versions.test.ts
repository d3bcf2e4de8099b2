import { readdirSync, readFileSync } from 'node:fs';
import type { Mesh, Object3D, WebGLProgramParametersWithUniforms } from 'three';
import { afterAll, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import { MODES, recordedContext } from './recordedContext.js';
import { VERSIONS, withoutVersion, withVersion } from './versions.js';

const FOLDER = 'src/material/three';

const { version: installed } = JSON.parse(readFileSync('node_modules/three/package.json', 'utf8'));
const { version: oldest } = JSON.parse(readFileSync('node_modules/three-oldest/package.json', 'utf8'));

/** For the code of the sentence to load. */
const WAIT = { timeout: 60_000 };

const minor = (version: string): string => version.split('.').slice(0, 2).join('.');

test.each(readdirSync(FOLDER).filter((file) => file !== 'warnOfChunk.ts'))(
  '%s says which versions it knows',
  (file) => {
    const [first] = readFileSync(`${FOLDER}/${file}`, 'utf8').split('\n');
    expect(first).toMatch(new RegExp(`^/\\*\\* Known in three\\.js ${minor(oldest)} to ${minor(installed)}: .`));
  },
);

test('no other file knows what three.js does not promise', () => {
  const others = readdirSync('src', { recursive: true, encoding: 'utf8' })
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => /\.tsx?$/.test(path) && !path.startsWith('material/three/'));
  expect(others.length).toBeGreaterThan(300);
  const secrets =
    /\bShaderChunk\b(?!`| stays)|uniformsList|clippingState|_matricesTexture|_currentRenderContext|properties\.get\(|isSprite = |isInstancedMesh = |isSkinnedMesh = |CubeUVReflectionMapping/;
  const found = others.filter((path) => {
    const code = readFileSync(`src/${path}`, 'utf8').replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '');
    return secrets.test(code);
  });
  expect(found).toEqual([]);
});

/** What the tests take of a version of three.js, and of the library with it. */
const modulesOf = async () => {
  const { addChecks } = await import('../../../../src/material/firstDraw/loadChecks.js');
  addChecks(() => import('../../../../src/material/firstDraw/checkDraws.js'));
  return modulesOfThree();
};

const modulesOfThree = async () => ({
  ...(await import('../../../../src/material/three/MeshUniforms.js')),
  ...(await import('../../../../src/material/three/hooks.js')),
  ...(await import('../../../../src/material/three/posing.js')),
  ...(await import('../../../../src/material/three/batches.js')),
  ...(await import('../../../../src/material/three/clipping.js')),
  ...(await import('../../../../src/material/three/environments.js')),
  ...(await import('../../../../src/material/three/lightKinds.js')),
  ...(await import('../../../../src/material/three/shadowMaps.js')),
});

describe.each(VERSIONS)('$name', (version) => {
  let library: Awaited<ReturnType<typeof setUp>>;

  const setUp = () => withVersion(version, modulesOf);

  beforeAll(async () => {
    library = await setUp();
  });
  afterAll(withoutVersion);

  beforeEach(() => {
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    return () => vi.restoreAllMocks();
  });

  /** A renderer that draws nothing, and the calls that it makes. */
  function renderer() {
    const { three } = library;
    const { context, canvas, calls } = recordedContext();
    const made = new three.WebGLRenderer({ canvas, context });
    const camera = new three.PerspectiveCamera();
    camera.position.z = 5;
    return {
      made,
      calls,
      /** The calls of a frame. */
      draw(...objects: Object3D[]) {
        calls.length = 0;
        const scene = new three.Scene().add(...objects);
        made.render(scene, camera);
        return [...calls];
      },
    };
  }

  const VERTEX = `
uniform float ofMesh;
uniform float ink;
uniform float tone;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, ofMesh);
}`;
  const FRAGMENT = 'uniform float ink;\nvoid main() {\n  gl_FragColor = vec4(ink);\n}';

  function shader() {
    const { three } = library;
    const uniforms = { ofMesh: { value: 1 }, ink: { value: 1 }, tone: { value: 1 } };
    return new three.ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT });
  }

  const meshesOf = (material: object, count: number): Mesh[] =>
    Array.from({ length: count }, () => new library.three.Mesh(new library.three.BoxGeometry(), material as never));

  test('uploads only the uniforms that differ between meshes', () => {
    const { MeshUniforms } = library;
    const { made, draw } = renderer();
    const material = shader();
    const ofMesh = new MeshUniforms(material, ['ofMesh']);
    material.onBeforeRender = () => ofMesh.want(made);
    for (const isFirst of [true, false]) {
      const set = draw(...meshesOf(material, 3)).flatMap(({ uniform }) => uniform ?? []);
      const counts = ['ofMesh', 'ink', 'tone'].map((name) => set.filter((one) => one === name).length);
      // Values that have not changed are not uploaded: three.js keeps those of a program.
      if (isFirst) expect(set).toContain('ink');
      expect(counts[1]).toBeLessThanOrEqual(1);
    }
    let value = 10;
    material.onBeforeRender = () => {
      for (const uniform of Object.values(material.uniforms)) uniform.value = value++;
      ofMesh.want(made);
    };
    const set = draw(...meshesOf(material, 3)).flatMap(({ uniform }) => uniform ?? []);
    expect(['ofMesh', 'ink', 'tone'].map((name) => set.filter((one) => one === name).length)).toEqual([3, 1, 1]);
    material.onBeforeRender = () => {
      for (const uniform of Object.values(material.uniforms)) uniform.value = value++;
      material.uniformsNeedUpdate = true;
    };
    const all = draw(...meshesOf(material, 3)).flatMap(({ uniform }) => uniform ?? []);
    expect(['ofMesh', 'ink', 'tone'].map((name) => all.filter((one) => one === name).length)).toEqual([3, 3, 3]);
  });

  test('calls onBeforeRender, then asks for the key, then calls onBeforeCompile, all in one task', () => {
    const { RendererKind, defineRigid } = library;
    const { draw } = renderer();
    const material = shader();
    const calls: string[] = [];
    const kind = new RendererKind();
    let program: WebGLProgramParametersWithUniforms | undefined;
    material.onBeforeRender = () => void calls.push('render');
    material.customProgramCacheKey = () => {
      calls.push('key');
      kind.ask('Test');
      return '';
    };
    material.onBeforeCompile = (parameters) => {
      calls.push('compile');
      kind.state = 'webgl';
      defineRigid(parameters);
      program = parameters;
    };
    draw(...meshesOf(material, 1));
    expect(calls).toEqual(['render', 'key', 'compile']);
    expect(program?.vertexShader).toMatch(/^#define RIGID\n/);
  });

  test('tells a program that its meshes have instances', () => {
    const { defineRigid, three } = library;
    const { draw } = renderer();
    const material = shader();
    let source = '';
    material.onBeforeCompile = (parameters) => {
      defineRigid(parameters);
      source = parameters.vertexShader;
    };
    const mesh = new three.InstancedMesh(new three.BoxGeometry(), material, 2);
    mesh.setMatrixAt(0, new three.Matrix4());
    mesh.setMatrixAt(1, new three.Matrix4());
    draw(mesh);
    expect(source).toContain('void main()');
    expect(source).not.toContain('RIGID');
  });

  test('skins points that take the pose of a mesh, and builds their program without drawing them', () => {
    const { CornerPoints, NO_CORNERS, three } = library;
    const { made, calls, draw } = renderer();
    const geometry = new three.BoxGeometry();
    const bone = new three.Bone();
    const skinned = new three.SkinnedMesh(geometry, shader());
    skinned.bind(new three.Skeleton([bone]));
    const points = new CornerPoints(geometry);
    points.takePose(skinned);
    const material = shader();
    let isSkinned: boolean | undefined;
    material.onBeforeCompile = ({ skinning }) => {
      isSkinned = skinning;
    };
    const scene = new three.Scene();
    const [mesh] = meshesOf(shader(), 1);
    mesh.onBeforeRender = (_renderer, _scene, camera) => {
      made.renderBufferDirect(camera, scene, geometry, material, points, NO_CORNERS as never);
      expect(isSkinned).toBe(true);
      expect(calls.map(({ name }) => name)).toContain('link');
      expect(calls.filter(({ name }) => name === 'draw')).toEqual([]);
      made.renderBufferDirect(camera, scene, geometry, material, points, null as never);
      expect(calls.filter(({ name }) => name === 'draw')).toMatchObject([{ mode: MODES.POINTS }]);
    };
    expect(draw(mesh).filter(({ name }) => name === 'draw')).toHaveLength(2);
  });

  test('draws what is like a sprite from triangles, after what is opaque, and nothing where its count says so', () => {
    const { NO_VERTICES, SpriteLike, three } = library;
    const { draw } = renderer();
    class Lines extends SpriteLike {
      readonly mesh = null;
      material = Object.assign(shader(), { transparent: true });
    }
    const lines = new Lines();
    lines.frustumCulled = false;
    lines.geometry.setDrawRange(0, 9);
    lines.geometry.boundingSphere = new three.Sphere();
    const opaque = shader();
    const draws = draw(lines, ...meshesOf(opaque, 1)).filter(({ name }) => name === 'draw');
    expect(draws.map(({ count }) => count)).toEqual([36, 9]);
    expect(draws.map(({ mode }) => mode)).toEqual([MODES.TRIANGLES, MODES.TRIANGLES]);
    lines.geometry.setDrawRange(0, NO_VERTICES);
    expect(draw(lines).filter(({ name }) => name === 'draw')).toEqual([]);
  });

  test('visits a list of objects when it compiles, with the lights of another scene', () => {
    const { ObjectList, three } = library;
    const { made } = renderer();
    const material = shader();
    const compiled = vi.fn();
    material.onBeforeCompile = compiled;
    const list = new ObjectList(meshesOf(material, 1));
    made.compile(list as never, new three.PerspectiveCamera(), new three.Scene());
    expect(compiled).toHaveBeenCalledOnce();
  });

  test('keeps clipping planes where they can be forgotten, and matrices of batches where they are found', () => {
    const { batchMatrices, forgetClipping, three } = library;
    const { made, draw } = renderer();
    const material = shader();
    material.clipping = true;
    material.clippingPlanes = [new three.Plane(new three.Vector3(1, 0, 0), 0)];
    made.localClippingEnabled = true;
    draw(...meshesOf(material, 1));
    const kept = made.properties.get(material) as { clippingState: unknown };
    expect(kept.clippingState).toBeTruthy();
    forgetClipping(made, material);
    expect(kept.clippingState).toBeNull();
    const batch = new three.BatchedMesh(2, 24, 36, material);
    expect(batchMatrices(batch)).toBeInstanceOf(three.DataTexture);
    expect(batchMatrices(new three.Mesh())).toBeNull();
  });

  test('has only chunks that are known: shadow maps, lights, shadows of lights, environments', async () => {
    const { environmentLayout, lightChunks, shadowChunks, shadowDepthChunk, shadowMapsChunk } = library;
    const shadows = shadowMapsChunk();
    expect(shadowDepthChunk()).toContain('SHADOW_DEPTH(texel)');
    expect(shadows.includes('steadyFlat') || shadows.includes('unpackRGBAToDepth')).toBe(true);
    const { eachLight, lightShadows } = lightChunks();
    for (const name of ['directional', 'point', 'spot']) expect(eachLight).toContain(`${name}Lights[i]`);
    for (const name of ['getShadow', 'getPointShadow']) expect(lightShadows).toContain(`#define ${name}(`);
    expect(shadowChunks().shadowMatrices).toContain('directionalShadowMatrix');
    expect(environmentLayout()).toMatch(/^(atlas|cube)$/);
    // The sentence would be loaded first.
    await vi.dynamicImportSettled();
    expect(console.warn).not.toHaveBeenCalled();
  });

  test.each([
    ['shadowmap_pars_fragment', 'interleavedGradientNoise( gl', 'otherNoise( gl', /0\.\d+.*: edges of shadows/],
    ['lights_pars_begin', 'getSpotLightInfo', 'readSpotLight', /lights of an unknown kind/],
    ['lights_fragment_begin', 'Shadow(', 'Shade(', /tell shadows from shade/],
  ])('a changed chunk is named in one sentence: %s', async (name, from, to, sentence) => {
    const { environmentLayout, lightChunks, shadowMapsChunk, three } = library;
    const chunks = three.ShaderChunk as Record<string, string>;
    const before = chunks[name];
    // Versions before 0.182 filter shadows without what is replaced.
    if (!before.includes(from)) return;
    chunks[name] = before.replaceAll(from, to);
    try {
      for (let times = 0; times < 2; times++) {
        expect(shadowMapsChunk()).toContain('getShadow');
        expect(lightChunks().eachLight).toContain('directionalLights[i]');
        expect(environmentLayout()).not.toBeNull();
      }
    } finally {
      chunks[name] = before;
    }
    await vi.waitFor(() => expect(console.warn).toHaveBeenCalled(), WAIT);
    expect(console.warn).toHaveBeenCalledOnce();
    expect(vi.mocked(console.warn).mock.calls[0][0]).toContain(`"${name}"`);
    expect(vi.mocked(console.warn).mock.calls[0][0]).toMatch(sentence);
  });

  test('a layout of environments that is unknown gives no light, and a sentence', async () => {
    const { environmentLayout, three } = library;
    const chunks = three.ShaderChunk as Record<string, string | undefined>;
    const { cube_uv_reflection_fragment, envmap_physical_pars_fragment } = chunks;
    delete chunks.cube_uv_reflection_fragment;
    chunks.envmap_physical_pars_fragment = 'vec3 getIBLIrradiance() {}';
    try {
      expect(environmentLayout()).toBeNull();
    } finally {
      Object.assign(chunks, { envmap_physical_pars_fragment });
      if (cube_uv_reflection_fragment) Object.assign(chunks, { cube_uv_reflection_fragment });
    }
    await vi.waitFor(() => expect(console.warn).toHaveBeenCalledOnce(), WAIT);
    expect(vi.mocked(console.warn).mock.calls[0][0]).toMatch(/environments give no light\.$/);
  });
});
