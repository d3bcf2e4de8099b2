/** Draws scenes in GLSL on WebGLRenderer and of nodes on WebGPURenderer, and says how much the pictures differ. */
import { Color, type ColorRepresentation, Mesh, MeshBasicMaterial, PCFShadowMap, SphereGeometry } from 'three';

import { HatchingMaterial, HatchingShadowMaterial } from 'three-hatching';
import { HatchingNodeMaterial, HatchingShadowNodeMaterial } from 'three-hatching/webgpu';
import { lackOfWebGPU } from '../../tools/browser/lackOfWebGPU.js';
import type { HatchingSpec } from '../gpu/hatchingSpec.js';
import { specScene } from '../gpu/specScene.js';
import { type Drawer, drawOnCanvas, makeDrawer } from './drawing.js';
import { knot } from './knot.js';
import { type Comparison, compare, type Pixels, sideBySide } from './picturesOf.js';
import type { Depth, Drawn, Kit, SceneCase, Stage } from './SceneCase.js';

// Each scene tests one thing and is odd on purpose, so warnings about looks are off.
HatchingMaterial.silent = true;

const modules = import.meta.glob<{ cases: readonly SceneCase[] }>('./cases/*.ts', { eager: true });
/** The cases of each file, by its name without its ending. */
const groups = new Map(
  Object.entries(modules).map(([path, { cases }]) => [/([^/]+)\.ts$/.exec(path)![1], cases] as const),
);

const drawers = new Map<string, Promise<Drawer>>();

function drawerOf(drawn: Drawn, depth: Depth): Promise<Drawer> {
  const key = `${drawn} ${depth}`;
  const drawer = drawers.get(key) ?? makeDrawer(drawn, depth);
  drawers.set(key, drawer);
  return drawer;
}

const kitOf = (drawn: Drawn): Kit => ({
  drawn,
  async hatching(parameters) {
    const material = drawn === 'glsl' ? new HatchingMaterial(parameters) : new HatchingNodeMaterial(parameters);
    await material.ready;
    return material;
  },
  async shadows(parameters) {
    const material =
      drawn === 'glsl' ? new HatchingShadowMaterial(parameters) : new HatchingShadowNodeMaterial(parameters);
    await material.ready;
    return material;
  },
  either: (glsl, nodes) => (drawn === 'glsl' ? glsl() : nodes()),
});

function disposeOf({ scene }: Stage): void {
  scene.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    object.geometry.dispose();
    for (const material of [object.material].flat()) material.dispose();
  });
}

/** A picture of a case, and the colour of its background. */
async function draw(
  { show, shadows, depth = 'plain' }: SceneCase,
  drawn: Drawn,
): Promise<{ pixels: Pixels; background: number[] }> {
  const { renderer, draw, read } = await drawerOf(drawn, depth);
  renderer.shadowMap.enabled = shadows !== undefined;
  if (shadows !== undefined) renderer.shadowMap.type = shadows;
  const stage = await show(kitOf(drawn));
  stage.scene.background ??= new Color(0x00ff00);
  draw(stage);
  if (stage.change) {
    await stage.change();
    // WebGPURenderer moves bones once a frame.
    await new Promise(requestAnimationFrame);
    draw(stage);
  }
  const pixels = await read();
  disposeOf(stage);
  const background = (stage.scene.background as Color).toArray().map((share) => Math.round(255 * share));
  return { pixels, background };
}

interface Compared extends Comparison {
  /** Both pictures and their difference, as the data URL of a PNG. */
  picture: string;
}

/** The picture in GLSL of each case, by its group and name. */
const inGlsl = new Map<string, ReturnType<typeof draw>>();

async function measure(group: string, name: string, drawn: 'forceWebGL' | 'webgpu'): Promise<Compared> {
  const found = groups.get(group)?.find((one) => one.name === name);
  if (!found) throw new Error(`measure: there is no case "${name}" in cases/${group}.ts.`);
  const key = `${group}: ${name}`;
  const glsl = inGlsl.get(key) ?? draw(found, 'glsl');
  inGlsl.set(key, glsl);
  const { pixels, background } = await glsl;
  const nodes = (await draw(found, drawn)).pixels;
  return { ...compare(pixels, nodes, background), picture: sideBySide(pixels, nodes) };
}

/** Compares pictures of a case on canvases, before this background or on transparent ones. */
async function measureOnCanvas(group: string, name: string, background: ColorRepresentation | null): Promise<Compared> {
  const found = groups.get(group)?.find((one) => one.name === name);
  if (!found) throw new Error(`measureOnCanvas: there is no case "${name}" in cases/${group}.ts.`);
  const pictures: Pixels[] = [];
  for (const drawn of ['glsl', 'forceWebGL'] as const) {
    const stage = await found.show(kitOf(drawn));
    stage.scene.background = background === null ? null : new Color(background);
    pictures.push(await drawOnCanvas(stage, drawn));
    disposeOf(stage);
  }
  const [glsl, nodes] = pictures;
  return { ...compare(glsl, nodes, [...glsl.subarray(0, 3)]), picture: sideBySide(glsl, nodes) };
}

/** A scene that is also compared with the reference in double precision. */
const caseOfSpec = (name: string, spec: HatchingSpec): SceneCase => ({
  name,
  shadows: PCFShadowMap,
  async show({ drawn }) {
    const made: (HatchingMaterial | HatchingNodeMaterial)[] = [];
    const stage = await specScene(spec, (parameters) => {
      const material = drawn === 'glsl' ? new HatchingMaterial(parameters) : new HatchingNodeMaterial(parameters);
      made.push(material);
      return material;
    });
    await Promise.all(made.map(({ ready }) => ready));
    return stage;
  },
});

async function measureSpec(name: string, spec: HatchingSpec, drawn: 'forceWebGL' | 'webgpu'): Promise<Comparison> {
  const one = caseOfSpec(name, spec);
  const glsl = inGlsl.get(name) ?? draw(one, 'glsl');
  inGlsl.set(name, glsl);
  const { pixels, background } = await glsl;
  return compare(pixels, (await draw(one, drawn)).pixels, background);
}

/** The number of fragment programs for materials of two kinds that all have different numbers and colours. */
async function programsOfMany(drawn: 'forceWebGL' | 'webgpu', count: number): Promise<number> {
  const { renderer, draw } = await makeDrawer(drawn);
  const stage = knot(new MeshBasicMaterial());
  stage.scene.remove(stage.mesh);
  const geometry = new SphereGeometry(0.1, 12, 8);
  for (let i = 0; i < count; i++) {
    const direction = i % 2 ? 'light' : 'y';
    const look = {
      technique: 'engraving',
      direction,
      lineSpacing: 4 + 0.1 * i,
      ink: i,
      irregularity: i / count,
    } as const;
    const mesh = new Mesh(geometry, await kitOf(drawn).hatching(look));
    mesh.position.set(0.2 * (i % 10) - 1, 0.2 * Math.floor(i / 10) - 0.5, 0);
    stage.scene.add(mesh);
  }
  draw(stage);
  const { programs } = (renderer as unknown as { _pipelines: { programs: { fragment: Map<string, unknown> } } })
    ._pipelines;
  const built = programs.fragment.size;
  disposeOf(stage);
  return built;
}

/** The share of pixels that differ where a renderer draws a scene after another one has lost its device. */
async function afterLoss(drawn: 'forceWebGL' | 'webgpu'): Promise<number> {
  const stage = knot(await kitOf(drawn).hatching({ preset: 'pencil' }));
  stage.scene.background = new Color(0x00ff00);
  const first = await makeDrawer(drawn);
  first.draw(stage);
  const before = await first.read();
  // three.js would report the deliberate loss of the device.
  Object.assign(first.renderer, { onDeviceLost() {} });
  const { backend } = first.renderer as unknown as {
    backend: { device?: { destroy(): void; lost: Promise<unknown> }; gl?: WebGL2RenderingContext };
  };
  const { device, gl } = backend;
  const lost = device?.lost ?? new Promise((resolve) => gl?.canvas.addEventListener('webglcontextlost', resolve));
  device?.destroy();
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  await lost;
  const second = await makeDrawer(drawn);
  second.draw(stage);
  const after = await second.read();
  disposeOf(stage);
  second.dispose();
  return compare(before, after, [0, 255, 0]).differing;
}

const page = {
  programsOfMany,
  afterLoss,
  lackOfWebGPU: await lackOfWebGPU(),
  /** The names of a group's cases, and what they are held to. */
  casesOf: (group: string) =>
    (groups.get(group) ?? []).map(({ name, onWebGPU = 'pixels', most }) => ({ name, onWebGPU, most })),
  measure,
  measureSpec,
  measureOnCanvas,
};

declare global {
  interface Window {
    besideGlsl: typeof page;
  }
}
window.besideGlsl = page;
