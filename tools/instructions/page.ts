import {
  Mesh,
  MeshPhongMaterial,
  MeshStandardMaterial,
  NearestFilter,
  type Object3D,
  RGBAIntegerFormat,
  UnsignedIntType,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { applyHatching, type HatchedScene, HatchingMaterial } from 'three-hatching';
import { castShadow, litScene } from '../bench/litScene.js';
import { loadModel } from '../bench/loadModel.js';
import { type LookName, lookNames, lookOptions } from '../bench/presets/lookOptions.js';
import { type BlockSize, blockMean } from './blockMeans.js';
import { BRANCHES_PER_PICTURE, countedShader } from './countedShader.js';
import { traceBits, tracedShader } from './tracedShader.js';

/** What is compiled and drawn: a look or three's Phong, alone or in its own shadow. */
export interface Case {
  look: LookName | 'phong';
  isInShadow: boolean;
  model: string;
  size: number;
}

/** The program of a case, and how often its branches run. */
export interface FoundCase {
  vertex: string;
  fragment: string;
  /** The fragment shader with a number in each branch. */
  traced: string;
  /** What each branch is, and the bits of its number. */
  branches: { name: string; bits: number }[];
  /** For each size of a group of pixels, how often a group runs each branch, on average over what is drawn. */
  runs: { block: BlockSize; means: number[] }[];
}

/** A pixel by itself, and the groups of the widths of Intel and AMD. */
const BLOCKS: readonly BlockSize[] = [
  [1, 1],
  [4, 2],
  [4, 4],
  [8, 4],
  [8, 8],
];

/** Rewrites a fragment shader before it is compiled. */
type Rewrite = (fragment: string) => string;

async function findCase({ look, isInShadow, model, size }: Case): Promise<FoundCase> {
  const mesh = await meshOf(look, model);
  mesh.castShadow = mesh.receiveShadow = isInShadow;
  let vertex = '';
  let fragment = '';
  draw(
    mesh,
    isInShadow,
    size,
    (source) => source,
    (type, source) => {
      if (type === 'vertex') vertex = source;
      else fragment = source;
    },
  );
  const { source: traced, branches } = tracedShader(fragment);
  const count = branches.length;
  const means = BLOCKS.map((): number[] => []);
  for (let first = 1; first < Math.max(count, 2); first += BRANCHES_PER_PICTURE) {
    const words = draw(mesh, isInShadow, size, (source) => countedShader(source, first));
    const runs = new Uint8Array(words.buffer);
    const shown = Uint8Array.from({ length: size * size }, (_, pixel) => runs[16 * pixel]);
    for (let place = first === 1 ? 0 : 1; place <= BRANCHES_PER_PICTURE && first + place - 1 < count; place++) {
      const ofPlace = Uint8Array.from({ length: size * size }, (_, pixel) => runs[16 * pixel + place]);
      for (const [i, block] of BLOCKS.entries()) means[i].push(blockMean(ofPlace, shown, size, block));
    }
  }
  return {
    vertex,
    fragment,
    traced,
    branches: branches.map((name, branch) => ({ name, bits: traceBits(branch) })),
    runs: BLOCKS.map((block, i) => ({ block, means: means[i] })),
  };
}

/** Models that were hatched; another look of theirs needs no further bake. */
const hatchedModels = new Map<string, { mesh: Mesh; hatched: HatchedScene }>();

async function meshOf(look: Case['look'], model: string): Promise<Mesh> {
  if (look === 'phong') return new Mesh(await loadModel(model), new MeshPhongMaterial());
  const options = { ...lookOptions(look), outlines: false };
  const known = hatchedModels.get(model);
  if (known) {
    await known.hatched.setPreset(options);
    await known.hatched.formReady;
    return known.mesh;
  }
  const mesh = new Mesh(await loadModel(model), new MeshStandardMaterial());
  const hatched = await applyHatching(mesh, options);
  await hatched.formReady;
  hatchedModels.set(model, { mesh, hatched });
  return mesh;
}

/** Frames until a look is settled, when it is drawn for the first time. */
const SETTLING_FRAMES = 2;

/**
 * Draws an object with a renderer of its own, its fragment shader rewritten.
 *
 * @param onSource called with the sources of the object's program
 * @returns the target's words, four a pixel
 */
function draw(
  object: Object3D,
  isInShadow: boolean,
  size: number,
  rewrite: Rewrite,
  onSource?: (type: 'vertex' | 'fragment', source: string) => void,
): Uint32Array {
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.setSize(size, size, false);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { scene, camera, sun } = litScene();
  if (isInShadow) castShadow(renderer, sun);
  scene.add(object);
  const { shaderSource } = gl;
  const isOfObject = (source: string): boolean => !source.includes('#define SHADER_TYPE MeshDepthMaterial');
  gl.shaderSource = (shader, source) => {
    const isFragment = gl.getShaderParameter(shader, gl.SHADER_TYPE) === gl.FRAGMENT_SHADER;
    if (isOfObject(source)) onSource?.(isFragment ? 'fragment' : 'vertex', source);
    shaderSource.call(gl, shader, isFragment && isOfObject(source) ? rewrite(source) : source);
  };
  const isCounting = onSource === undefined;
  const target = new WebGLRenderTarget(size, size, {
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    format: RGBAIntegerFormat,
    type: UnsignedIntType,
    internalFormat: 'RGBA32UI',
  });
  // The colour that a canvas shows takes instructions, too.
  renderer.setRenderTarget(isCounting ? target : null);
  const words = new Uint32Array(4 * size * size);
  for (let i = isCounting ? 1 : SETTLING_FRAMES; i > 0; i--) {
    renderer.clear();
    renderer.render(scene, camera);
  }
  if (isCounting) gl.readPixels(0, 0, size, size, gl.RGBA_INTEGER, gl.UNSIGNED_INT, words);
  scene.remove(object);
  const error = gl.getError();
  if (error !== 0) throw new Error(`draw: WebGL says ${error}.`);
  renderer.dispose();
  renderer.forceContextLoss();
  return words;
}

await HatchingMaterial.preload();
Object.assign(window, { findCase, lookNames });
