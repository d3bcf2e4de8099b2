import {
  type BufferGeometry,
  DirectionalLight,
  IcosahedronGeometry,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import {
  HatchingMaterial,
  HatchingOutlineMaterial,
  HatchingOutlines,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { drawer } from '../drawer.js';

/** Milliseconds of each way to draw, one entry per turn: the script of a frame alone, and the frame until a pixel can be read. */
export interface ManyTimes {
  script: Record<string, number[]>;
  frame: Record<string, number[]>;
  /** The first frame of each, with the programs compiled in it. */
  first: Record<string, number>;
}

interface Things {
  count: number;
  isInstanced: boolean;
}

/** A way to draw the things. */
interface Look {
  material: Material;
  /** Whether lines run on from mesh to mesh, as `applyHatching` has it: each mesh then has uniforms of its own. */
  hasFrame?: boolean;
  hasOutlines?: boolean;
}

/** Small, so that the script counts and not the pixels. */
const SCRIPT_SIZE = 64;
const WARM_UP_TURNS = 3;

/** Functions that draw one frame on the small canvas, by look. */
const drawers = new Map<string, () => void>();

/** Draws many small things, as meshes of their own or as instances of one, hatched and in Lambert's shading, in turn. */
export async function measureMany(things: Things, turns: number, size: number): Promise<ManyTimes> {
  const source = new IcosahedronGeometry(0.4);
  const geometry = await prepareHatchingGeometry(source, { layout: 'indexed', outlines: true });
  const looks = await looksFor(things);
  const side = Math.ceil(Math.sqrt(things.count));
  const places = Array.from({ length: things.count }, (_, i) =>
    new Matrix4().makeTranslation((i % side) - side / 2, Math.floor(i / side) - side / 2, 0),
  );
  const times: ManyTimes = { script: {}, frame: {}, first: {} };
  for (const pixels of [size, SCRIPT_SIZE]) {
    const found = pixels === SCRIPT_SIZE ? times.script : times.frame;
    const renderer = new WebGLRenderer({ antialias: false });
    renderer.setSize(pixels, pixels, false);
    const camera = new PerspectiveCamera(30, 1, 0.1, 10 * side);
    camera.position.z = 2 * side;
    const draw = drawer(renderer, camera);
    const scenes = Object.entries(looks).map(([name, look]) => {
      const scene = sceneOf(
        things.isInstanced ? [instancesOf(geometry, look, places)] : meshesOf(geometry, look, places),
      );
      found[name] = [];
      times.first[name] ??= draw(scene).frame;
      drawers.set(name, () => draw(scene));
      return [name, scene] as const;
    });
    for (let turn = -WARM_UP_TURNS; turn < turns; turn++) {
      for (const [name, scene] of turn % 2 === 0 ? scenes : scenes.toReversed()) {
        const { script, frame } = draw(scene);
        if (turn >= 0) found[name].push(pixels === SCRIPT_SIZE ? script : frame);
      }
    }
    if (pixels === SCRIPT_SIZE) continue;
    renderer.dispose();
    renderer.forceContextLoss();
  }
  return times;
}

/** Draws frames of a look of the last measurement, one after the other. */
export function drawMany(look: string, frames: number): void {
  for (let i = 0; i < frames; i++) drawers.get(look)!();
}

async function looksFor({ isInstanced }: Things): Promise<Record<string, Look>> {
  const tonalArtMap = await TonalArtMap.generate();
  const preset = (preset: 'pen' | 'engraving' | 'pencil') => new HatchingMaterial({ preset, tonalArtMap });
  const looks: Record<string, Look> = {
    lambert: { material: new MeshLambertMaterial() },
    hatching: { material: new HatchingMaterial(plainLook({ technique: 'hatching', tonalArtMap })) },
    engraving: { material: new HatchingMaterial(plainLook({ technique: 'engraving' })) },
  };
  if (isInstanced) return looks;
  return {
    ...looks,
    pen: { material: preset('pen') },
    engraving: { material: preset('engraving') },
    pencil: { material: preset('pencil') },
    'engraving, lines from mesh to mesh': { material: preset('engraving'), hasFrame: true },
    'the same, all uniforms for each': { material: uploadingAll(preset('engraving')), hasFrame: true },
    'pen, with outlines': { material: preset('pen'), hasOutlines: true },
  };
}

/** Has three.js upload every uniform again for each mesh, as it would without `MeshUniforms`. */
function uploadingAll(material: HatchingMaterial): HatchingMaterial {
  const want = (): void => {
    material.uniformsNeedUpdate = true;
  };
  Object.assign(material.ofMesh, { want });
  return material;
}

function sceneOf(objects: readonly Object3D[]): Scene {
  const sun = new DirectionalLight(0xffffff, Math.PI);
  sun.position.set(1, 1, 1);
  return new Scene().add(sun, ...objects);
}

function meshesOf(
  geometry: BufferGeometry,
  { material, hasFrame, hasOutlines }: Look,
  places: readonly Matrix4[],
): Mesh[] {
  const outlines = new HatchingOutlineMaterial();
  return places.map((place) => {
    const mesh = new Mesh(geometry, material);
    mesh.applyMatrix4(place);
    if (hasFrame) mesh.userData.hatchingField = place.toArray();
    if (hasOutlines) mesh.add(new HatchingOutlines(mesh, outlines));
    return mesh;
  });
}

function instancesOf(geometry: BufferGeometry, { material }: Look, places: readonly Matrix4[]): InstancedMesh {
  const mesh = new InstancedMesh(geometry, material, places.length);
  for (const [i, place] of places.entries()) mesh.setMatrixAt(i, place);
  return mesh;
}
