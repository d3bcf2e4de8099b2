/** Draws scenes in GLSL on WebGLRenderer and of nodes on WebGPURenderer, and says how much the pictures differ. */
import { Color, Mesh } from 'three';
import { HatchingMaterial } from 'three-hatching';
import { HatchingNodeMaterial } from 'three-hatching/webgpu';
import { type Drawer, lackOfWebGPU, makeDrawer } from './drawing.js';
import { type Comparison, compare, type Pixels, sideBySide } from './picturesOf.js';
import type { Drawn, Kit, SceneCase, Stage } from './SceneCase.js';

// Each scene shows one thing by itself, and is odd on purpose.
HatchingMaterial.silent = true;

const modules = import.meta.glob<{ cases: readonly SceneCase[] }>('./cases/*.ts', { eager: true });
/** The cases of each file, by its name without its ending. */
const groups = new Map(
  Object.entries(modules).map(([path, { cases }]) => [/([^/]+)\.ts$/.exec(path)![1], cases] as const),
);

/** The largest share of pixels that may be seen to differ, where a case says nothing else. */
const MOST_DIFFERING = 0.0005;

const drawers = new Map<Drawn, Promise<Drawer>>();

function drawerOf(drawn: Drawn): Promise<Drawer> {
  const drawer = drawers.get(drawn) ?? makeDrawer(drawn);
  drawers.set(drawn, drawer);
  return drawer;
}

const kitOf = (drawn: Drawn): Kit => ({
  drawn,
  async hatching(parameters) {
    const material = drawn === 'glsl' ? new HatchingMaterial(parameters) : new HatchingNodeMaterial(parameters);
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
async function draw({ show, shadows }: SceneCase, drawn: Drawn): Promise<{ pixels: Pixels; background: number[] }> {
  const { renderer, draw, read } = await drawerOf(drawn);
  renderer.shadowMap.enabled = shadows !== undefined;
  if (shadows !== undefined) renderer.shadowMap.type = shadows;
  const stage = await show(kitOf(drawn));
  stage.scene.background ??= new Color(0x00ff00);
  draw(stage);
  if (stage.change) {
    stage.change();
    draw(stage);
  }
  const pixels = await read();
  disposeOf(stage);
  const background = (stage.scene.background as Color).toArray().map((share) => Math.round(255 * share));
  return { pixels, background };
}

interface Compared extends Comparison {
  /** Both pictures and their difference, as the address of a PNG. */
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

const page = {
  lackOfWebGPU: await lackOfWebGPU(),
  /** The names of a group's cases, and what they are held to. */
  casesOf: (group: string) =>
    (groups.get(group) ?? []).map(({ name, onWebGPU = 'pixels', most = MOST_DIFFERING }) => ({ name, onWebGPU, most })),
  measure,
};

declare global {
  interface Window {
    besideGlsl: typeof page;
  }
}
window.besideGlsl = page;
