import {
  Group,
  type Material,
  Mesh,
  MeshLambertMaterial,
  MeshPhongMaterial,
  MeshStandardMaterial,
  type Object3D,
  PlaneGeometry,
  ShadowMaterial,
} from 'three';
import { applyHatching, type HatchedScene, HatchingShadowMaterial, prepareHatchingGeometry } from 'three-hatching';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';
import { type LookName, lookOptions, materialOptions } from './lookOptions.js';

/** Times in milliseconds, one per turn, of a look and of three's materials under the same circumstances. */
export interface PresetTimes {
  triangles: number;
  times: Record<string, number[]>;
}

/** Frames in which lists of contours arrive and forms fade in, before anything is timed. */
const SETTLING_FRAMES = 4;
const SETTLING_PAUSE = 300;

/** Draws a model as `applyHatching` makes it, beside Lambert and Phong: alone, with outlines, in shadow, and with its shadow on a ground. */
export async function measurePresets(model: string, look: LookName, turns: number, size: number): Promise<PresetTimes> {
  const source = await loadModel(model);
  const ground = new PlaneGeometry(6, 6, 8, 8).rotateX(-Math.PI / 2);
  const plain = (material: Material): Mesh => shadowed(new Mesh(source, material));
  const alone = await hatch(plain(new MeshStandardMaterial()), look);
  const inShadow = await hatch(plain(new MeshStandardMaterial()), look);
  const [{ tonalArtMap }] = inShadow.hatched.materials;
  const ofGround = { ...materialOptions(look), tonalArtMap, depthWrite: false };
  const groundMaterial = new HatchingShadowMaterial(ofGround);
  await groundMaterial.ready;
  const plane = await prepareHatchingGeometry(ground);

  const lit = new Stage(size);
  const shady = new Stage(size, true);
  const phongOnGround = shadowed(new Mesh(ground, new ShadowMaterial()));
  const hatchedGround = shadowed(new Mesh(plane, groundMaterial));
  for (const { position } of [phongOnGround, hatchedGround]) position.y = -0.7;
  const drawings: Record<string, Drawing> = {
    lambert: { stage: lit, parts: [plain(new MeshLambertMaterial())] },
    phong: { stage: lit, parts: [plain(new MeshPhongMaterial())] },
    surface: { stage: lit, parts: [alone.root], outlines: [alone.hatched, false] },
    outlines: { stage: lit, parts: [alone.root], outlines: [alone.hatched, true] },
    'phong in shadow': { stage: shady, parts: [plain(new MeshPhongMaterial())] },
    shadow: { stage: shady, parts: [inShadow.root], outlines: [inShadow.hatched, true] },
    'phong on ground': { stage: shady, parts: [plain(new MeshPhongMaterial()), phongOnGround] },
    ground: { stage: shady, parts: [inShadow.root, hatchedGround], outlines: [inShadow.hatched, true] },
  };
  for (let i = 0; i < SETTLING_FRAMES; i++) {
    for (const drawing of Object.values(drawings)) await timeDrawing(drawing);
    await new Promise((resolve) => setTimeout(resolve, SETTLING_PAUSE));
  }
  const times = await timeTurns({ timeFrame: timeDrawing }, drawings, turns);
  return { triangles: source.index!.count / 3, times };
}

/** What one frame shows. Parts and outlines may belong to several drawings. */
interface Drawing {
  stage: Stage;
  parts: Object3D[];
  /** A hatched scene, and whether its outlines are drawn. */
  outlines?: readonly [HatchedScene, boolean];
}

function timeDrawing({ stage, parts, outlines }: Drawing): Promise<number> {
  if (outlines) for (const lines of outlines[0].outlines) lines.visible = outlines[1];
  return stage.timeFrame(new Group().add(...parts));
}

async function hatch(root: Mesh, look: LookName): Promise<{ root: Mesh; hatched: HatchedScene }> {
  const hatched = await applyHatching(root, lookOptions(look), { outlines: true });
  await hatched.formReady;
  return { root, hatched };
}

function shadowed(mesh: Mesh): Mesh {
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}
