import {
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
import { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { plainLook } from '../../plainLook.js';

/** Milliseconds of each way to draw, one entry per turn: the script of a frame alone, and the frame until a pixel can be read. */
export interface ManyTimes {
  script: Record<string, number[]>;
  frame: Record<string, number[]>;
  /** The first frame of each, with the programs compiled in it. */
  first: Record<string, number>;
}

/** Small, so that the script counts and not the pixels. */
const SCRIPT_SIZE = 64;
const WARM_UP_TURNS = 3;

/** Draws many small things, as meshes of their own or as instances of one, hatched and in Lambert's shading, in turn. */
export async function measureMany(
  { count, isInstanced }: { count: number; isInstanced: boolean },
  turns: number,
  size: number,
): Promise<ManyTimes> {
  const source = new IcosahedronGeometry(0.4);
  const geometry = await prepareHatchingGeometry(source, { layout: 'indexed' });
  const tonalArtMap = await TonalArtMap.generate();
  const materials: Record<string, Material> = {
    lambert: new MeshLambertMaterial(),
    anchored: new HatchingMaterial(plainLook({ technique: 'anchored', tonalArtMap })),
    engraved: new HatchingMaterial(plainLook({ technique: 'engraved' })),
  };
  const side = Math.ceil(Math.sqrt(count));
  const places = Array.from({ length: count }, (_, i) =>
    new Matrix4().makeTranslation((i % side) - side / 2, Math.floor(i / side) - side / 2, 0),
  );
  const times: ManyTimes = { script: {}, frame: {}, first: {} };
  for (const pixels of [SCRIPT_SIZE, size]) {
    const found = pixels === SCRIPT_SIZE ? times.script : times.frame;
    const renderer = new WebGLRenderer({ antialias: false });
    renderer.setSize(pixels, pixels, false);
    const camera = new PerspectiveCamera(30, 1, 0.1, 10 * side);
    camera.position.z = 2 * side;
    const draw = drawer(renderer, camera);
    const scenes = Object.entries(materials).map(([name, material]) => {
      const scene = sceneOf(
        isInstanced ? [instancesOf(geometry, material, places)] : meshesOf(geometry, material, places),
      );
      found[name] = [];
      times.first[name] = draw(scene).frame;
      return [name, scene] as const;
    });
    for (let turn = -WARM_UP_TURNS; turn < turns; turn++) {
      for (const [name, scene] of turn % 2 === 0 ? scenes : scenes.toReversed()) {
        const { script, frame } = draw(scene);
        if (turn >= 0) found[name].push(pixels === SCRIPT_SIZE ? script : frame);
      }
    }
    renderer.dispose();
    renderer.forceContextLoss();
  }
  return times;
}

function sceneOf(objects: readonly Object3D[]): Scene {
  const sun = new DirectionalLight(0xffffff, Math.PI);
  sun.position.set(1, 1, 1);
  return new Scene().add(sun, ...objects);
}

const meshesOf = (geometry: Mesh['geometry'], material: Material, places: readonly Matrix4[]): Mesh[] =>
  places.map((place) => {
    const mesh = new Mesh(geometry, material);
    mesh.applyMatrix4(place);
    return mesh;
  });

function instancesOf(geometry: Mesh['geometry'], material: Material, places: readonly Matrix4[]): InstancedMesh {
  const mesh = new InstancedMesh(geometry, material, places.length);
  for (const [i, place] of places.entries()) mesh.setMatrixAt(i, place);
  return mesh;
}

/** Draws a scene, and tells how long the script took, and the whole frame. */
function drawer(renderer: WebGLRenderer, camera: PerspectiveCamera) {
  const gl = renderer.getContext();
  const pixel = new Uint8Array(4);
  return (scene: Scene): { script: number; frame: number } => {
    const start = performance.now();
    renderer.render(scene, camera);
    const script = performance.now() - start;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return { script, frame: performance.now() - start };
  };
}
